// A layered material as its file describes it.

export type Rgb = [number, number, number];

// Distribution of facet normals.
export type Ndf = "ggx" | "beckmann";

// `alpha` are the slope roughnesses along x and y, each in [0, 1].
export interface Microsurface {
    ndf: Ndf;
    alpha: [number, number];
}

// Of unit thickness; `tau` is the transmittance along the normal.
export interface AbsorbingMedium {
    kind: "absorbing";
    tau: Rgb;
}

// Coefficients per unit of thickness; `g` is the mean cosine of the phase function.
export interface ScatteringMedium {
    kind: "scattering";
    sigmaA: Rgb;
    sigmaS: Rgb;
    g: number;
    thickness: number;
}

export type Medium = AbsorbingMedium | ScatteringMedium;

// `ior` is the absolute index of the medium below.
export interface Layer {
    ior: number;
    microsurface: Microsurface;
    medium: Medium;
}

export interface LambertianBase {
    kind: "lambertian";
    albedo: Rgb;
}

// The absolute index is eta + i kappa.
export interface ConductorBase {
    kind: "conductor";
    eta: Rgb;
    kappa: Rgb;
    microsurface: Microsurface;
}

// Rough, of diffuse facets.
export interface DiffuseFacetsBase {
    kind: "diffuse-facets";
    albedo: Rgb;
    microsurface: Microsurface;
}

// Light passes on below the last layer.
export interface NoBase {
    kind: "none";
}

export type Base = LambertianBase | ConductorBase | DiffuseFacetsBase | NoBase;

export interface Material {
    name: string;
    exteriorIor: number;
    layers: Layer[]; // top to bottom
    base: Base;
}
