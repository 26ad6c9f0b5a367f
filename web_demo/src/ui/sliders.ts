// Sliders for the numbers that materials are made of.
import type { FolderApi } from "tweakpane";
import type { Microsurface, Rgb } from "../material/material";
import { ALPHA, type Range } from "../material/ranges";

const NDF_OPTIONS = { GGX: "ggx", Beckmann: "beckmann" };

export function slider({ low, high }: Range, label: string) {
    return { label, min: low, max: high, format: (value: number) => value.toFixed(3) };
}

export function addRgb(folder: FolderApi, name: string, rgb: Rgb, range: Range): void {
    folder.addBinding(rgb, 0, slider(range, `${name} r`));
    folder.addBinding(rgb, 1, slider(range, `${name} g`));
    folder.addBinding(rgb, 2, slider(range, `${name} b`));
}

// Roughness as the papers have it, alpha; one slider where it is the same in both directions.
export function addMicrosurface(folder: FolderApi, microsurface: Microsurface): void {
    const { alpha } = microsurface;
    if (alpha[0] === alpha[1]) {
        folder.addBinding(alpha, 0, slider(ALPHA, "alpha")).on("change", ({ value }) => {
            alpha[1] = value;
        });
    } else {
        folder.addBinding(alpha, 0, slider(ALPHA, "alpha x"));
        folder.addBinding(alpha, 1, slider(ALPHA, "alpha y"));
    }
    folder.addBinding(microsurface, "ndf", { label: "facets", options: NDF_OPTIONS });
}
