// What the models shade of a material: its top layer and its base.

export type Rgb = [number, number, number];

// Distribution of facet normals.
export type Ndf = "ggx" | "beckmann";

// `alpha` are the slope roughnesses along x and y, each in [0, 1].
export interface Microsurface {
    ndf: Ndf;
    alpha: [number, number];
}

// `tau` is the transmittance along the normal.
export interface Medium {
    tau: Rgb;
    scatters: boolean;
}

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

export interface NoBase {
    kind: "none";
}

export interface Material {
    name: string;
    exteriorIor: number;
    coat?: Layer;
    base: LambertianBase | ConductorBase | NoBase;
    // What the file describes beyond that.
    layerCount: number;
    hasMedium: boolean; // in any layer
    hasDiffuseFacets: boolean; // a base that is not quite Lambertian
}
