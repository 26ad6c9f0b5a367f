// A material as the rows of four numbers that shaders read: lq_one_coat_unpack of
// shader_src/kernels/one_coat_rows.glsl and lq_coated_unpack of model_coated.glsl.
import type { Material, Microsurface, Rgb } from "./material";

export type Row = [number, number, number, number];

const NDF = { ggx: 0, beckmann: 1 };
const BASE = { none: 0, lambertian: 1, conductor: 2 };
const NO_FACETS: Microsurface = { ndf: "ggx", alpha: [0, 0] };
const BLACK: Rgb = [0, 0, 0];
const CLEAR: Rgb = [1, 1, 1];
const LARGEST_FLOAT = 3.4028234663852886e38; // for infinities, which WGSL does not have

function facetsRow({ alpha, ndf }: Microsurface, third: number): Row {
    return [alpha[0], alpha[1], third, NDF[ndf]];
}

function coatRow({ coat, exteriorIor }: Material): Row {
    return facetsRow(
        coat?.microsurface ?? NO_FACETS,
        coat === undefined ? 0 : coat.ior / exteriorIor,
    );
}

function albedoOf({ base }: Material): Rgb {
    return base.kind === "lambertian" ? base.albedo : BLACK;
}

export function packOneCoat(material: Material): Row[] {
    const { coat, base, exteriorIor } = material;
    const conductor = base.kind === "conductor" ? base : undefined;
    const relative = ([r, g, b]: Rgb): Row => [r / exteriorIor, g / exteriorIor, b / exteriorIor, 0];
    const opticalDepth = (tau: number): number => Math.min(-Math.log(tau), LARGEST_FLOAT);
    const [r, g, b] = coat?.medium.tau ?? CLEAR;
    return [
        coatRow(material),
        facetsRow(conductor?.microsurface ?? NO_FACETS, BASE[base.kind]),
        [...albedoOf(material), 0],
        relative(conductor?.eta ?? BLACK),
        relative(conductor?.kappa ?? BLACK),
        [opticalDepth(r), opticalDepth(g), opticalDepth(b), 0],
    ];
}

// `ggx`: the base's light leaves as a GGX lobe.
export function packCoated(material: Material, ggx: boolean): Row[] {
    const tau = material.coat?.medium.tau ?? CLEAR;
    return [coatRow(material), [...tau, ggx ? 1 : 0], [...albedoOf(material), 0]];
}
