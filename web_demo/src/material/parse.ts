// Reads material files by the rules of the C++ loader, but for textures and blended microsurfaces.
import type {
    Base,
    ConductorBase,
    DiffuseFacetsBase,
    Layer,
    Material,
    Medium,
    Microsurface,
    Rgb,
} from "./material";
import { MaterialError, Place } from "./place";
import {
    ALBEDO,
    ALPHA,
    ANISOTROPY,
    CONDUCTOR_ETA,
    CONDUCTOR_KAPPA,
    IOR,
    iorBeside,
    MAX_LAYERS,
    SIGMA,
    TAU,
    THICKNESS,
} from "./ranges";

export interface OpticalConstants {
    eta: Rgb;
    kappa: Rgb;
}

// Refractive indices by the name of the metal.
export type Metals = ReadonlyMap<string, OpticalConstants>;

function parseJson(text: string, origin: string): Place {
    try {
        return new Place(origin, JSON.parse(text));
    } catch (error) {
        throw new MaterialError(`${origin}: ${error instanceof Error ? error.message : error}`);
    }
}

function readMicrosurface(place: Place): Microsurface {
    if (place.find("blend") !== undefined) {
        place.notShown("this page does not show blended microsurfaces");
    }
    const alpha: Place = place.member("alpha");
    const [x, y = x, ...rest] = alpha.isArray() ? alpha.elements() : [alpha];
    if (x === undefined || y === undefined || rest.length > 0) {
        alpha.fail("expected one number or two: along x and y");
    }
    return {
        ndf: place.find("ndf")?.choice("ggx", "beckmann") ?? "ggx",
        alpha: [x.number(ALPHA), y.number(ALPHA)],
    };
}

function readInterface(place: Place, iorAbove: number): Omit<Layer, "medium"> {
    place.expectObject("ior", "alpha", "ndf", "blend");
    const ior = place.member("ior");
    const value = ior.number(IOR);
    const { low, high } = iorBeside(iorAbove);
    if (value < low || value > high) {
        ior.fail(`${value} below ${iorAbove} is a ratio outside [1/3, 3]`);
    }
    return { ior: value, microsurface: readMicrosurface(place) };
}

function noMedium(): Medium {
    return { kind: "absorbing", tau: [1, 1, 1] };
}

function readMedium(place: Place): Medium {
    place.expectObject("tau", "sigma_a", "sigma_s", "g", "thickness");
    const tau = place.find("tau");
    const others = ["sigma_a", "sigma_s", "g", "thickness"].filter((key) => place.find(key));
    if (tau !== undefined) {
        const [other] = others;
        if (other !== undefined) {
            place.member(other).fail(`'${other}' and 'tau' exclude each other: give one`);
        }
        return { kind: "absorbing", tau: tau.rgb(TAU) };
    }
    const sigmaA = place.find("sigma_a")?.rgb(SIGMA);
    const sigmaS = place.find("sigma_s")?.rgb(SIGMA);
    if (sigmaA === undefined && sigmaS === undefined) {
        place.fail("one of 'tau', 'sigma_a' and 'sigma_s' is needed");
    }
    return {
        kind: "scattering",
        sigmaA: sigmaA ?? [0, 0, 0],
        sigmaS: sigmaS ?? [0, 0, 0],
        g: place.find("g")?.number(ANISOTROPY) ?? 0,
        thickness: place.find("thickness")?.number(THICKNESS) ?? 1,
    };
}

function findMetal(place: Place, metals: Metals): OpticalConstants {
    const known = [...metals.keys()].join(", ");
    return metals.get(place.string()) ?? place.fail(`'${place.string()}' is not one of: ${known}`);
}

function readConductor(place: Place, metals: Metals): ConductorBase {
    place.expectObject("eta", "kappa", "metal", "alpha", "ndf", "blend");
    const microsurface = readMicrosurface(place);
    const metal = place.find("metal");
    if (metal !== undefined) {
        const { eta, kappa } = findMetal(metal, metals);
        return { kind: "conductor", eta: [...eta], kappa: [...kappa], microsurface };
    }
    const eta = place.member("eta").rgb(CONDUCTOR_ETA);
    const kappa = place.member("kappa").rgb(CONDUCTOR_KAPPA);
    return { kind: "conductor", eta, kappa, microsurface };
}

function readDiffuseFacets(place: Place): DiffuseFacetsBase {
    place.expectObject("albedo", "alpha", "ndf", "blend");
    const microsurface = readMicrosurface(place);
    return { kind: "diffuse-facets", albedo: place.member("albedo").rgb(ALBEDO), microsurface };
}

function readBase(place: Place, metals: Metals): Base {
    if (place.isString()) {
        return { kind: place.choice("none") };
    }
    place.expectObject("lambertian", "conductor", "diffuse_facets");
    const conductor = place.find("conductor");
    if (conductor !== undefined) {
        return readConductor(conductor, metals);
    }
    const facets = place.find("diffuse_facets");
    if (facets !== undefined) {
        return readDiffuseFacets(facets);
    }
    const lambertian = place.member("lambertian");
    lambertian.expectObject("albedo");
    return { kind: "lambertian", albedo: lambertian.member("albedo").rgb(ALBEDO) };
}

function readLayers(place: Place, exteriorIor: number): Layer[] {
    const layers = place.elements();
    if (layers.length > MAX_LAYERS) {
        place.fail(`${layers.length} layers, at most ${MAX_LAYERS} are allowed`);
    }
    let iorAbove = exteriorIor;
    return layers.map((layer) => {
        layer.expectObject("interface", "medium");
        const read = readInterface(layer.member("interface"), iorAbove);
        iorAbove = read.ior;
        const medium = layer.find("medium");
        return { ...read, medium: medium === undefined ? noMedium() : readMedium(medium) };
    });
}

// The material that `text` describes; `origin` names it in messages, and where it has no name.
export function parseMaterial(text: string, origin: string, metals: Metals): Material {
    const root = parseJson(text, origin);
    root.expectObject("$schema", "name", "exterior_ior", "layers", "base");
    const exteriorIor = root.find("exterior_ior")?.number(IOR) ?? 1;
    const list = root.find("layers");
    const layers = list === undefined ? [] : readLayers(list, exteriorIor);
    const base = readBase(root.member("base"), metals);
    if (layers.length === 0 && base.kind === "none") {
        root.member("base").fail('"none" without layers leaves nothing to shade');
    }
    const name = root.find("name")?.string() ?? origin;
    return { name, exteriorIor, layers, base };
}

// The table of refractive indices, tables/optical_constants.json.
export function parseMetals(text: string, origin: string): Metals {
    const metals = new Map<string, OpticalConstants>();
    for (const metal of parseJson(text, origin).member("metals").elements()) {
        metals.set(metal.member("name").string(), {
            eta: metal.member("eta").rgb(CONDUCTOR_ETA),
            kappa: metal.member("kappa").rgb(CONDUCTOR_KAPPA),
        });
    }
    return metals;
}
