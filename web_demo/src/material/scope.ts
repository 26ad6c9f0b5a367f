// Which materials a model can shade. The C++ side of it is host/core/model_scope.cpp; the page does
// not even read blended microsurfaces.
import type { Base, Layer, Material } from "./material";
import { scatters } from "./medium";
import type { ModelName } from "./models";
import { MAX_LAYERS } from "./ranges";

// A feature that a model has no formula for is left out, as the page says, or refused.
interface Scope {
    refusesDeeperLayers: boolean; // those below the first
    refusesScattering: boolean;
    lambertianOnly: boolean; // a coat over a Lambertian base, and nothing else
    wholeStacks: boolean; // at least one layer, and bases as they are
}

const ANYTHING: Scope = {
    refusesDeeperLayers: false,
    refusesScattering: false,
    lambertianOnly: false,
    wholeStacks: false,
};
const ONE_COAT: Scope = { ...ANYTHING, refusesDeeperLayers: true, refusesScattering: true };

const SCOPES: Record<ModelName, Scope> = {
    plain: ANYTHING,
    clearcoat: ONE_COAT,
    "weidlich-wilkie": ONE_COAT,
    "openpbr-coat": ONE_COAT,
    "coated-ggx": { ...ONE_COAT, lambertianOnly: true },
    "coated-exact": { ...ONE_COAT, lambertianOnly: true },
    stack: { ...ANYTHING, wholeStacks: true },
    "stack-symmetric": { ...ANYTHING, wholeStacks: true },
};

// The JSON pointer of what is refused, and what the model does.
interface Refusal {
    pointer: string;
    why: string;
}

function refusedLayers(layers: Layer[], scope: Scope): Refusal | undefined {
    if (layers.length === 0 && scope.lambertianOnly) {
        const why = "shades one layer over a Lambertian base, and there is none";
        return { pointer: "/layers", why };
    }
    if (layers.length === 0 && scope.wholeStacks) {
        return { pointer: "/layers", why: "needs at least one layer" };
    }
    if (scope.wholeStacks && layers.length > MAX_LAYERS) {
        return { pointer: `/layers/${MAX_LAYERS}`, why: `shades at most ${MAX_LAYERS} layers` };
    }
    if (scope.refusesDeeperLayers && layers.length > 1) {
        return { pointer: "/layers/1", why: "shades at most one layer" };
    }
    const shaded = scope.wholeStacks ? layers : layers.slice(0, 1);
    const scattering = shaded.findIndex(({ medium }) => scatters(medium));
    if (scope.refusesScattering && scattering >= 0) {
        const pointer = `/layers/${scattering}/medium/sigma_s`;
        return { pointer, why: "cannot shade a medium that scatters" };
    }
    return undefined;
}

function refusedBase({ kind }: Base, scope: Scope): Refusal | undefined {
    if (scope.lambertianOnly && kind !== "lambertian") {
        return { pointer: "/base", why: "shades Lambertian bases only" };
    }
    if (scope.wholeStacks && kind === "diffuse-facets") {
        return { pointer: "/base/diffuse_facets", why: "cannot shade diffuse facets" };
    }
    return undefined;
}

// Why `model` cannot shade `material`; undefined where it can.
export function whyNotShadeable(material: Material, model: ModelName): string | undefined {
    const scope = SCOPES[model];
    const refusal = refusedLayers(material.layers, scope) ?? refusedBase(material.base, scope);
    return refusal && `${refusal.pointer}: the model '${model}' ${refusal.why}`;
}
