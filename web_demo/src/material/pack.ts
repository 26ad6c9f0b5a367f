// A material as the rows of four numbers that the model `plain` reads:
// lq_one_coat_unpack of shader_src/kernels/one_coat_rows.glsl.
import type { Material, Microsurface, Rgb } from "./material";

export type Row = [number, number, number, number];

const NDF = { ggx: 0, beckmann: 1 };
const BASE = { none: 0, lambertian: 1, conductor: 2 };
const NO_FACETS: Microsurface = { ndf: "ggx", alpha: [0, 0] };

function facetsRow({ alpha, ndf }: Microsurface, third: number): Row {
    return [alpha[0], alpha[1], third, NDF[ndf]];
}

export function packPlain({ coat, base, exteriorIor }: Material): Row[] {
    const conductor = base.kind === "conductor" ? base : undefined;
    const albedo: Rgb = base.kind === "lambertian" ? base.albedo : [0, 0, 0];
    const relative = ([r, g, b]: Rgb): Row => [r / exteriorIor, g / exteriorIor, b / exteriorIor, 0];
    return [
        facetsRow(coat?.microsurface ?? NO_FACETS, coat === undefined ? 0 : coat.ior / exteriorIor),
        facetsRow(conductor?.microsurface ?? NO_FACETS, BASE[base.kind]),
        [...albedo, 0],
        relative(conductor?.eta ?? [0, 0, 0]),
        relative(conductor?.kappa ?? [0, 0, 0]),
        [0, 0, 0, 0], // optical depth: the model `plain` has no media
    ];
}
