// The models that the page can shade with: which shaders, which materials, which rows. The C++ side
// of it is host/core/model_scope.cpp and host/backends/pack*.cpp.
import type { Material } from "./material";
import { packCoated, packOneCoat, type Row } from "./pack";

export const MODEL_NAMES = [
    "plain",
    "clearcoat",
    "weidlich-wilkie",
    "openpbr-coat",
    "coated-ggx",
    "coated-exact",
] as const;

export type ModelName = (typeof MODEL_NAMES)[number];

// The level of the shader source: what the names of its files begin with.
export function levelOf(model: ModelName): string {
    return isCoated(model) ? "coated" : model.replace("-", "_");
}

function isCoated(model: ModelName): boolean {
    return model === "coated-ggx" || model === "coated-exact";
}

// Why `model` cannot shade `material`; undefined where it can.
export function whyNotShadeable(material: Material, model: ModelName): string | undefined {
    const { coat, base, layerCount, hasDiffuseFacets } = material;
    if (model === "plain") {
        return undefined;
    }
    if (isCoated(model) && coat === undefined) {
        return "shades one layer over a Lambertian base, and there is none";
    }
    if (layerCount > 1) {
        return "shades at most one layer";
    }
    if (coat?.medium.scatters) {
        return "cannot shade a medium that scatters";
    }
    if (isCoated(model) && (base.kind !== "lambertian" || hasDiffuseFacets)) {
        return "shades Lambertian bases only";
    }
    return undefined;
}

export function modelsFor(material: Material): ModelName[] {
    return MODEL_NAMES.filter((model) => whyNotShadeable(material, model) === undefined);
}

// `wanted` where it can shade `material`, otherwise "plain".
export function modelFor(material: Material, wanted: ModelName): ModelName {
    return whyNotShadeable(material, wanted) === undefined ? wanted : "plain";
}

// What the file describes and `model` leaves out, in words.
export function omittedBy(material: Material, model: ModelName): string[] {
    const omitted: string[] = [];
    if (material.layerCount > 1) {
        omitted.push("the lower layers");
    }
    if (model === "plain" && material.hasMedium) {
        omitted.push("what the layers absorb and scatter");
    }
    if (model === "clearcoat" && material.hasMedium) {
        omitted.push("what the layer absorbs");
    }
    if (material.hasDiffuseFacets) {
        omitted.push("the roughness of the base");
    }
    return omitted;
}

// The rows of four numbers that the shaders of `model` read.
export function packSurface(material: Material, model: ModelName): Row[] {
    return isCoated(model) ? packCoated(material, model === "coated-ggx") : packOneCoat(material);
}
