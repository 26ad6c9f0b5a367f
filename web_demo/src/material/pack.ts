// A material as the rows of four numbers that shaders read. In shader_src/kernels:
// lq_one_coat_unpack of one_coat_rows.glsl, lq_coated_unpack of model_coated.glsl and
// lq_stack_unpack of model_stack.glsl.
import type { ConductorBase, Layer, Material, Microsurface, Rgb } from "./material";
import { opticalDepth, scatteringDepth, transmittance } from "./medium";
import { MAX_LAYERS } from "./ranges";

export type Row = [number, number, number, number];

const NDF = { ggx: 0, beckmann: 1 };
const BASE = { none: 0, lambertian: 1, "diffuse-facets": 1, conductor: 2 };
const NO_FACETS: Microsurface = { ndf: "ggx", alpha: [0, 0] };
const BLACK: Rgb = [0, 0, 0];
const CLEAR: Rgb = [1, 1, 1];
const STACK_ROWS = 3 + 7 * MAX_LAYERS; // with room for strata, which the page does not show
const LARGEST_FLOAT = 3.4028234663852886e38; // for infinities, which WGSL does not have

function facetsRow({ alpha, ndf }: Microsurface, third: number): Row {
    return [alpha[0], alpha[1], third, NDF[ndf]];
}

function colorRow([r, g, b]: Rgb, fourth = 0): Row {
    const most = LARGEST_FLOAT;
    return [Math.min(r, most), Math.min(g, most), Math.min(b, most), fourth];
}

// Indices are relative to the exterior's.
function layerRow({ microsurface, ior }: Layer, { exteriorIor }: Material): Row {
    return facetsRow(microsurface, ior / exteriorIor);
}

function indexRow([r, g, b]: Rgb, { exteriorIor }: Material, fourth = 0): Row {
    return [r / exteriorIor, g / exteriorIor, b / exteriorIor, fourth];
}

function coatRow(material: Material): Row {
    const [coat] = material.layers;
    return coat === undefined ? facetsRow(NO_FACETS, 0) : layerRow(coat, material);
}

function albedoOf({ base }: Material): Rgb {
    return "albedo" in base ? base.albedo : BLACK;
}

function conductorOf({ base }: Material): ConductorBase | undefined {
    return base.kind === "conductor" ? base : undefined;
}

export function packOneCoat(material: Material): Row[] {
    const [coat] = material.layers;
    const conductor = conductorOf(material);
    return [
        coatRow(material),
        facetsRow(conductor?.microsurface ?? NO_FACETS, BASE[material.base.kind]),
        colorRow(albedoOf(material)),
        indexRow(conductor?.eta ?? BLACK, material),
        indexRow(conductor?.kappa ?? BLACK, material),
        colorRow(coat === undefined ? BLACK : opticalDepth(coat.medium)),
    ];
}

// `ggx`: the base's light leaves as a GGX lobe.
export function packCoated(material: Material, ggx: boolean): Row[] {
    const [coat] = material.layers;
    const tau = coat === undefined ? CLEAR : transmittance(coat.medium);
    return [coatRow(material), colorRow(tau, ggx ? 1 : 0), colorRow(albedoOf(material))];
}

function stackLayerRows(layer: Layer, material: Material): Row[] {
    const { medium } = layer;
    return [
        layerRow(layer, material),
        colorRow(opticalDepth(medium), medium.kind === "scattering" ? medium.g : 0),
        colorRow(scatteringDepth(medium)),
    ];
}

// The rows of absent layers are zeros.
export function packStack(material: Material): Row[] {
    const { layers, base } = material;
    const conductor = conductorOf(material);
    const { alpha, ndf } = conductor?.microsurface ?? NO_FACETS;
    const rows: Row[] = [
        [layers.length, BASE[base.kind], ...alpha],
        conductor === undefined
            ? colorRow(albedoOf(material))
            : indexRow(conductor.eta, material, NDF[ndf]),
        indexRow(conductor?.kappa ?? BLACK, material),
        ...layers.flatMap((layer) => stackLayerRows(layer, material)),
    ];
    return [...rows, ...Array.from({ length: STACK_ROWS - rows.length }, () => colorRow(BLACK))];
}
