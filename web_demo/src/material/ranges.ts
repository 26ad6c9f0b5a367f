// The range of every number of a material file that the page reads.

export interface Range {
    low: number;
    high: number;
}

export const IOR: Range = { low: 0.3, high: 4 };
export const IOR_RATIO: Range = { low: 1 / 3, high: 3 };
export const ALPHA: Range = { low: 0, high: 1 };
export const ALBEDO: Range = { low: 0, high: 1 };
export const TAU: Range = { low: 0, high: 1 };
export const SIGMA: Range = { low: 0, high: 1e9 };
export const ANISOTROPY: Range = { low: -0.99, high: 0.99 };
export const THICKNESS: Range = { low: 0, high: 1e9 };
export const CONDUCTOR_ETA: Range = { low: 0, high: 5 };
export const CONDUCTOR_KAPPA: Range = { low: 0, high: 10 };
export const MAX_LAYERS = 8;

// The indices that a medium may have beside others, above or below it.
export function iorBeside(...neighbours: number[]): Range {
    return {
        low: Math.max(IOR.low, ...neighbours.map((ior) => IOR_RATIO.low * ior)),
        high: Math.min(IOR.high, ...neighbours.map((ior) => IOR_RATIO.high * ior)),
    };
}
