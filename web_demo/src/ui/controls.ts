// The numbers of the scene on sliders.
import { Pane, type FolderApi } from "tweakpane";
import type { Layer, Material, Microsurface, Rgb } from "../material/material";
import { type ModelName, modelFor, modelsFor } from "../material/models";
import {
    ALBEDO,
    ALPHA,
    CONDUCTOR_ETA,
    CONDUCTOR_KAPPA,
    iorBelow,
    type Range,
    TAU,
} from "../material/ranges";
import type { Scene } from "../scene";

const MAX_IRRADIANCE = 30;
const NDF_OPTIONS = { GGX: "ggx", Beckmann: "beckmann" };

function slider({ low, high }: Range, label: string) {
    return { label, min: low, max: high, format: (value: number) => value.toFixed(3) };
}

function addRgb(folder: FolderApi, name: string, rgb: Rgb, range: Range): void {
    folder.addBinding(rgb, 0, slider(range, `${name} r`));
    folder.addBinding(rgb, 1, slider(range, `${name} g`));
    folder.addBinding(rgb, 2, slider(range, `${name} b`));
}

// Roughness as the papers have it, alpha; one slider where it is the same in both directions.
function addMicrosurface(folder: FolderApi, microsurface: Microsurface): void {
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

function addCoat(pane: Pane, coat: Layer, exteriorIor: number): void {
    const folder = pane.addFolder({ title: "Coat" });
    folder.addBinding(coat, "ior", slider(iorBelow(exteriorIor), "ior"));
    addMicrosurface(folder, coat.microsurface);
    addRgb(folder, "tau", coat.medium.tau, TAU);
}

// The models that can shade the material.
function addModel(pane: Pane, scene: Scene, chosen: (model: ModelName) => void): void {
    const state = { model: modelFor(scene.material, scene.model) };
    const options = Object.fromEntries(modelsFor(scene.material).map((name) => [name, name]));
    pane.addBinding(state, "model", { options }).on("change", ({ value }) => chosen(value));
}

function addBase(pane: Pane, base: Material["base"]): void {
    if (base.kind === "lambertian") {
        addRgb(pane.addFolder({ title: "Diffuse base" }), "albedo", base.albedo, ALBEDO);
    } else if (base.kind === "conductor") {
        const folder = pane.addFolder({ title: "Metal" });
        addMicrosurface(folder, base.microsurface);
        addRgb(folder, "eta", base.eta, CONDUCTOR_ETA);
        addRgb(folder, "kappa", base.kappa, CONDUCTOR_KAPPA);
    }
}

// Fills `container` with the model and the sliders of `scene`; returns what takes them away again.
export function showControls(container: HTMLElement, scene: Scene, changed: () => void): () => void {
    const pane = new Pane({ container });
    addModel(pane, scene, (model) => {
        scene.model = model;
    });
    if (scene.material.coat !== undefined) {
        addCoat(pane, scene.material.coat, scene.material.exteriorIor);
    }
    addBase(pane, scene.material.base);
    const light = pane.addFolder({ title: "Light" });
    light.addBinding(scene, "irradiance", slider({ low: 0, high: MAX_IRRADIANCE }, "irradiance"));
    light.addBinding(scene, "studio", { label: "rim lights" });
    pane.on("change", changed);
    return () => pane.dispose();
}
