// The numbers of the scene on sliders.
import { Pane } from "tweakpane";
import type { Base } from "../material/material";
import { type ModelName, modelFor, modelsFor } from "../material/models";
import { ALBEDO, CONDUCTOR_ETA, CONDUCTOR_KAPPA } from "../material/ranges";
import type { Scene } from "../scene";
import { addLayers } from "./layer_controls";
import { addMicrosurface, addRgb, slider } from "./sliders";

const MAX_IRRADIANCE = 30;

// The models that can shade the material.
function addModel(pane: Pane, scene: Scene, chosen: (model: ModelName) => void): void {
    const state = { model: modelFor(scene.material, scene.model) };
    const options = Object.fromEntries(modelsFor(scene.material).map((name) => [name, name]));
    pane.addBinding(state, "model", { options }).on("change", ({ value }) => chosen(value));
}

function addBase(pane: Pane, base: Base): void {
    if (base.kind === "lambertian" || base.kind === "diffuse-facets") {
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
    addLayers(pane, scene.material);
    addBase(pane, scene.material.base);
    const light = pane.addFolder({ title: "Light" });
    light.addBinding(scene, "irradiance", slider({ low: 0, high: MAX_IRRADIANCE }, "irradiance"));
    light.addBinding(scene, "studio", { label: "rim lights" });
    pane.on("change", changed);
    return () => pane.dispose();
}
