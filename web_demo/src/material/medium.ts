// What the medium of a layer does to light that crosses it along the normal.
import type { Medium, Rgb } from "./material";

// Of absorption; infinite where the medium is opaque.
export function opticalDepth(medium: Medium): Rgb {
    if (medium.kind === "absorbing") {
        const [r, g, b] = medium.tau;
        return [-Math.log(r), -Math.log(g), -Math.log(b)];
    }
    return times(medium.sigmaA, medium.thickness);
}

// Of scattering.
export function scatteringDepth(medium: Medium): Rgb {
    return medium.kind === "absorbing" ? [0, 0, 0] : times(medium.sigmaS, medium.thickness);
}

export function transmittance(medium: Medium): Rgb {
    const [r, g, b] = opticalDepth(medium);
    return [Math.exp(-r), Math.exp(-g), Math.exp(-b)];
}

export function scatters(medium: Medium): boolean {
    return medium.kind === "scattering" && medium.sigmaS.some((sigma) => sigma > 0);
}

export function isClear(medium: Medium): boolean {
    return !scatters(medium) && transmittance(medium).every((tau) => tau === 1);
}

function times([r, g, b]: Rgb, factor: number): Rgb {
    return [r * factor, g * factor, b * factor];
}
