// Reads material files, as far as the model `plain` shades them: by the rules of the C++ loader.
import type { ConductorBase, Interface, Material, Microsurface, Rgb } from "./material";
import { MaterialError, Place } from "./place";
import { ALBEDO, ALPHA, CONDUCTOR_ETA, CONDUCTOR_KAPPA, IOR, iorBelow, MAX_LAYERS } from "./ranges";

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
        place.fail("the model 'plain' cannot shade a blended microsurface");
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

function readInterface(place: Place, iorAbove: number): Interface {
    place.expectObject("ior", "alpha", "ndf", "blend");
    const ior = place.member("ior");
    const value = ior.number(IOR);
    const { low, high } = iorBelow(iorAbove);
    if (value < low || value > high) {
        ior.fail(`${value} below ${iorAbove} is a ratio outside [1/3, 3]`);
    }
    return { ior: value, microsurface: readMicrosurface(place) };
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

function readBase(place: Place, metals: Metals, omitted: string[]): Material["base"] {
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
        omitted.push("the roughness of the base");
        return { kind: "lambertian", albedo: facets.member("albedo").rgb(ALBEDO) };
    }
    const lambertian = place.member("lambertian");
    lambertian.expectObject("albedo");
    return { kind: "lambertian", albedo: lambertian.member("albedo").rgb(ALBEDO) };
}

function readLayers(place: Place, exteriorIor: number, omitted: string[]): Interface[] {
    const layers = place.elements();
    if (layers.length > MAX_LAYERS) {
        place.fail(`${layers.length} layers, at most ${MAX_LAYERS} are allowed`);
    }
    let iorAbove = exteriorIor;
    const interfaces = layers.map((layer) => {
        layer.expectObject("interface", "medium");
        const read = readInterface(layer.member("interface"), iorAbove);
        iorAbove = read.ior;
        return read;
    });
    if (layers.length > 1) {
        omitted.push("the lower layers");
    }
    if (layers.some((layer) => layer.find("medium") !== undefined)) {
        omitted.push("what the layers absorb and scatter");
    }
    return interfaces;
}

// The material that `text` describes; `origin` names it in messages, and where it has no name.
export function parseMaterial(text: string, origin: string, metals: Metals): Material {
    const root = parseJson(text, origin);
    root.expectObject("$schema", "name", "exterior_ior", "layers", "base");
    const omitted: string[] = [];
    const exteriorIor = root.find("exterior_ior")?.number(IOR) ?? 1;
    const layers = root.find("layers");
    const [coat] = layers === undefined ? [] : readLayers(layers, exteriorIor, omitted);
    const base = readBase(root.member("base"), metals, omitted);
    if (coat === undefined && base.kind === "none") {
        root.member("base").fail('"none" without layers leaves nothing to shade');
    }
    const name = root.find("name")?.string() ?? origin;
    return { name, exteriorIor, ...(coat && { coat }), base, omitted };
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
