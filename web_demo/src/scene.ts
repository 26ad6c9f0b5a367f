// What the page shows: a material under a light that can be moved.
import { type Vec3, vec3 } from "wgpu-matrix";
import type { Material, Rgb } from "./material/material";
import { levelOf, type ModelName, modelFor, packSurface } from "./material/models";
import type { Light, SphereView } from "./passes/sphere_view";

export interface Scene {
    material: Material;
    model: ModelName; // for materials that it can shade; modelFor chooses for the others
    light: Vec3; // unit, towards the light
    irradiance: number;
    // Two dim lights from behind trace the sphere's outline.
    studio: boolean;
}

// From above the viewer's left shoulder, as in the pictures of `lacquer compare`.
export const DEFAULT_LIGHT: Vec3 = vec3.normalize([-0.5, 0.65, 0.6]);

// A white Lambertian surface that faces the light has radiance 1.
export const DEFAULT_IRRADIANCE = Math.PI;

// Direction and colour of the lights from behind; the colours are small shares of the light's.
const STUDIO: { direction: Vec3; color: Rgb }[] = [
    { direction: vec3.normalize([0.8, -0.2, -0.62]), color: [0.2, 0.27, 0.38] },
    { direction: vec3.normalize([-0.25, -0.75, -0.7]), color: [0.24, 0.17, 0.13] },
];

function lightsOf({ light, irradiance, studio }: Scene): Light[] {
    const gray: Rgb = [irradiance, irradiance, irradiance];
    const fromBehind = STUDIO.map(({ direction, color: [r, g, b] }): Light => {
        return { direction, irradiance: [r * irradiance, g * irradiance, b * irradiance] };
    });
    return [{ direction: light, irradiance: gray }, ...(studio ? fromBehind : [])];
}

export function sphereView(scene: Scene, halfExtent: number): SphereView {
    const { material } = scene;
    const model = modelFor(material, scene.model);
    return {
        level: levelOf(model),
        surface: packSurface(material, model),
        lights: lightsOf(scene),
        halfExtent,
    };
}
