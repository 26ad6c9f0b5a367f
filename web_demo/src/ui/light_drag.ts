// Moving the light: the highlight of a smooth sphere follows the pointer, or the arrow keys.
import { type Vec3, vec3 } from "wgpu-matrix";

// Highlights nearer the edge than this would mean a light straight behind the sphere.
const MAX_RADIUS = 0.98;
const KEY_STEP = 0.04;

// The light whose highlight is at (x, y) on the disk of the sphere: the mirror image of the viewer.
function lightAt(x: number, y: number): Vec3 {
    const shrink = Math.min(1, MAX_RADIUS / Math.hypot(x, y));
    const [nx, ny] = [x * shrink, y * shrink];
    const nz = Math.sqrt(1 - nx * nx - ny * ny);
    return vec3.normalize([2 * nz * nx, 2 * nz * ny, 2 * nz * nz - 1]);
}

// Where the highlight of `light` is.
function highlightOf(light: Vec3): [number, number] {
    const halfway = vec3.normalize(vec3.add(light, [0, 0, 1]));
    return [halfway[0] ?? 0, halfway[1] ?? 0];
}

const KEYS: Record<string, readonly [number, number]> = {
    ArrowLeft: [-KEY_STEP, 0],
    ArrowRight: [KEY_STEP, 0],
    ArrowUp: [0, KEY_STEP],
    ArrowDown: [0, -KEY_STEP],
};

// Lets people move the light on `canvas`, whose shorter half is `halfExtent` radii of the sphere.
export function dragLight(
    canvas: HTMLCanvasElement,
    halfExtent: number,
    light: () => Vec3,
    moved: (light: Vec3) => void,
): void {
    const follow = (event: PointerEvent): void => {
        const { left, top, width, height } = canvas.getBoundingClientRect();
        const radius = Math.min(width, height) / (2 * halfExtent);
        const x = (event.clientX - left - width / 2) / radius;
        const y = (top + height / 2 - event.clientY) / radius;
        moved(lightAt(x, y));
    };
    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        follow(event);
    });
    canvas.addEventListener("pointermove", (event) => {
        if (canvas.hasPointerCapture(event.pointerId)) {
            follow(event);
        }
    });
    canvas.addEventListener("keydown", (event) => {
        const step = KEYS[event.key];
        if (step !== undefined) {
            event.preventDefault();
            const [x, y] = highlightOf(light());
            moved(lightAt(x + step[0], y + step[1]));
        }
    });
}
