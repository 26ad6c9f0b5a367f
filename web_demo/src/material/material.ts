// What the model `plain` shades of a material: its top interface and its base.

export type Rgb = [number, number, number];

// Distribution of facet normals.
export type Ndf = "ggx" | "beckmann";

// `alpha` are the slope roughnesses along x and y, each in [0, 1].
export interface Microsurface {
    ndf: Ndf;
    alpha: [number, number];
}

// `ior` is the absolute index of the medium below.
export interface Interface {
    ior: number;
    microsurface: Microsurface;
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
    coat?: Interface;
    base: LambertianBase | ConductorBase | NoBase;
    // What the file describes and `plain` leaves out, in words.
    omitted: string[];
}
