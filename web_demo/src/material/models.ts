// The models that the page can shade with: which shaders, which rows, what they leave out. The C++
// side of it is host/core/model.cpp and host/backends/pack*.cpp.
import type { Material } from "./material";
import { isClear } from "./medium";
import { packCoated, packOneCoat, packStack, type Row } from "./pack";
import { whyNotShadeable } from "./scope";

export const MODEL_NAMES = [
    "plain",
    "clearcoat",
    "weidlich-wilkie",
    "openpbr-coat",
    "coated-ggx",
    "coated-exact",
    "stack",
    "stack-symmetric",
] as const;

export type ModelName = (typeof MODEL_NAMES)[number];

// The level of the shader source: what the names of its files begin with.
export function levelOf(model: ModelName): string {
    return isCoated(model) ? "coated" : model.replace("-", "_");
}

function isStack(model: ModelName): boolean {
    return model === "stack" || model === "stack-symmetric";
}

function isCoated(model: ModelName): boolean {
    return model === "coated-ggx" || model === "coated-exact";
}

export function modelsFor(material: Material): ModelName[] {
    return MODEL_NAMES.filter((model) => whyNotShadeable(material, model) === undefined);
}

// `wanted` where it can shade `material`; otherwise "stack", which leaves nothing out, or "plain",
// which can shade anything.
export function modelFor(material: Material, wanted: ModelName): ModelName {
    const models = modelsFor(material);
    return [wanted, "stack" as const].find((model) => models.includes(model)) ?? "plain";
}

// What the file describes and `model` leaves out, in words.
export function omittedBy({ layers, base }: Material, model: ModelName): string[] {
    const omitted: string[] = [];
    const hasMedium = layers.some(({ medium }) => !isClear(medium));
    if (!isStack(model) && layers.length > 1) {
        omitted.push("the lower layers");
    }
    if (model === "plain" && hasMedium) {
        omitted.push("what the layers absorb and scatter");
    }
    if (model === "clearcoat" && hasMedium) {
        omitted.push("what the layer absorbs");
    }
    if (base.kind === "diffuse-facets") {
        omitted.push("the roughness of the base");
    }
    return omitted;
}

// The rows of four numbers that the shaders of `model` read.
export function packSurface(material: Material, model: ModelName): Row[] {
    if (isStack(model)) {
        return packStack(material);
    }
    return isCoated(model) ? packCoated(material, model === "coated-ggx") : packOneCoat(material);
}
