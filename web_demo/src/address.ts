// The parameters of the page's address, with which a picture can be asked for exactly:
//     ?material=celadon&model=coated-exact&light=-0.5,0.65,0.6&irradiance=3.14&studio=0&size=256
// `size` shows nothing but the sphere, touching the edges of a square of so many pixels.
import { type Vec3, vec3 } from "wgpu-matrix";
import { fail } from "./fail";
import { MODEL_NAMES, type ModelName } from "./material/models";

export interface Address {
    material?: string;
    model?: ModelName;
    light?: Vec3;
    irradiance?: number;
    studio?: boolean;
    size?: number;
}

const MAX_SIZE = 4096;

function readNumber(key: string, text: string, low: number, high: number): number {
    const value = text.trim() === "" ? Number.NaN : Number(text);
    if (!(value >= low && value <= high)) {
        fail(`In the page's address, ${key}=${text} is not a number in [${low}, ${high}].`);
    }
    return value;
}

function readDirection(key: string, text: string): Vec3 {
    const numbers = text.split(",").map((part) => readNumber(key, part, -1e6, 1e6));
    const [x, y, z, ...rest] = numbers;
    if (x === undefined || y === undefined || z === undefined || rest.length > 0) {
        fail(`In the page's address, ${key}=${text} is not three numbers.`);
    }
    if (Math.hypot(x, y, z) === 0) {
        fail(`In the page's address, ${key}=${text} has no direction.`);
    }
    return vec3.normalize([x, y, z]);
}

function readModel(text: string): ModelName {
    const found = MODEL_NAMES.find((model) => model === text);
    return found ?? fail(`The model '${text}' is not one of: ${MODEL_NAMES.join(", ")}.`);
}

export function readAddress(query: string): Address {
    const address: Address = {};
    for (const [key, text] of new URLSearchParams(query)) {
        if (key === "material") {
            address.material = text;
        } else if (key === "model") {
            address.model = readModel(text);
        } else if (key === "light") {
            address.light = readDirection(key, text);
        } else if (key === "irradiance") {
            address.irradiance = readNumber(key, text, 0, 1000);
        } else if (key === "studio") {
            address.studio = readNumber(key, text, 0, 1) !== 0;
        } else if (key === "size") {
            address.size = Math.round(readNumber(key, text, 1, MAX_SIZE));
        }
    }
    return address;
}
