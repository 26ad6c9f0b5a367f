// The numbers of a material's layers on sliders, a folder for each.
import type { BindingApi } from "@tweakpane/core";
import type { FolderApi, Pane } from "tweakpane";
import type { Material, Medium } from "../material/material";
import { iorBeside, TAU } from "../material/ranges";
import { addMicrosurface, addRgb, slider } from "./sliders";

// Sliders of what has no upper end, at least; they go to twice a larger number.
const MAX_SIGMA = 4;
const MAX_THICKNESS = 2;

// What a medium scatters decides which models can shade it, and is not to be changed here.
function addMedium(folder: FolderApi, medium: Medium): void {
    if (medium.kind === "absorbing") {
        addRgb(folder, "tau", medium.tau, TAU);
        return;
    }
    const { sigmaA, thickness } = medium;
    const sigmas = { low: 0, high: Math.max(MAX_SIGMA, 2 * Math.max(...sigmaA)) };
    const thicknesses = { low: 0, high: Math.max(MAX_THICKNESS, 2 * thickness) };
    addRgb(folder, "sigma a", sigmaA, sigmas);
    folder.addBinding(medium, "thickness", slider(thicknesses, "thickness"));
}

// The indices of the layers, the range of each of which depends on what its neighbours' are now.
class Indices {
    private readonly bindings: BindingApi[] = [];

    constructor(
        private readonly folders: FolderApi[],
        private readonly material: Material,
    ) {
        folders.forEach((_, n) => this.show(n));
    }

    // Puts the slider of layer n in place, or a new one in its place.
    private show(n: number): void {
        const { exteriorIor, layers } = this.material;
        const [folder, layer] = [this.folders[n], layers[n]];
        if (folder === undefined || layer === undefined) {
            return;
        }
        this.bindings[n]?.dispose();
        const above = layers[n - 1]?.ior ?? exteriorIor;
        const range = iorBeside(above, layers[n + 1]?.ior ?? above);
        const binding = folder.addBinding(layer, "ior", { ...slider(range, "ior"), index: 0 });
        binding.on("change", ({ last }) => {
            if (last) {
                this.show(n - 1);
                this.show(n + 1);
            }
        });
        this.bindings[n] = binding;
    }
}

export function addLayers(pane: Pane, material: Material): void {
    const { layers } = material;
    const folders = layers.map(({ microsurface, medium }, n) => {
        const title = layers.length === 1 ? "Coat" : `Layer ${n + 1}`;
        const folder = pane.addFolder({ title, expanded: n === 0 });
        addMicrosurface(folder, microsurface);
        addMedium(folder, medium);
        return folder;
    });
    new Indices(folders, material);
}
