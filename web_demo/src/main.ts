// Wires the page together: the address, the device, the scene, and what people change of it.
import "./style.css";
import { type Address, readAddress } from "./address";
import { element, fail, showUncaughtErrors } from "./fail";
import { followSize } from "./gpu/canvas";
import { requestDevice } from "./gpu/device";
import { bundledMaterial, bundledNames, metals } from "./material/bundled";
import type { Material } from "./material/material";
import { parseMaterial } from "./material/parse";
import { MaterialError } from "./material/place";
import { type ModelName, modelFor, omittedBy } from "./material/models";
import { whyNotShadeable } from "./material/scope";
import { type SphereView, SphereViewPipelines } from "./passes/sphere_view";
import { DEFAULT_IRRADIANCE, DEFAULT_LIGHT, type Scene, sphereView } from "./scene";
import { SphereCanvas } from "./sphere_canvas";
import { showControls } from "./ui/controls";
import { dragLight } from "./ui/light_drag";
import { addSwatch, markChosen } from "./ui/swatches";

const DEFAULT_MATERIAL = "vermilion_lacquer";
const DEFAULT_MODEL: ModelName = "coated-exact";
const STAGE_HALF_EXTENT = 1.2; // leaves the sphere some air
const SWATCH_HALF_EXTENT = 1.02;

const canvas = element<HTMLCanvasElement>("#stage");
const swatches = element<HTMLElement>("#swatches");
const notice = element<HTMLElement>("#notice");

function sceneOf(address: Address): Scene {
    const material = bundledMaterial(address.material ?? DEFAULT_MATERIAL);
    const why = address.model && whyNotShadeable(material, address.model);
    if (why !== undefined) {
        fail(`${material.name}: ${why}.`);
    }
    return {
        material,
        model: address.model ?? DEFAULT_MODEL,
        light: address.light ?? DEFAULT_LIGHT,
        irradiance: address.irradiance ?? DEFAULT_IRRADIANCE,
        studio: address.studio ?? true,
    };
}

// A drawing of `scene`, asked for any number of times and done once per frame of the display.
function drawOnDemand(pipelines: SphereViewPipelines, scene: Scene, halfExtent: number): () => void {
    const stage = new SphereCanvas(pipelines, canvas);
    let asked = false;
    return () => {
        if (asked) {
            return;
        }
        asked = true;
        requestAnimationFrame(async () => {
            asked = false;
            await stage.draw(sphereView(scene, halfExtent));
            await pipelines.device.queue.onSubmittedWorkDone();
            document.body.dataset["drawn"] = "true"; // what the tests wait for
        });
    };
}

// One after the other, so that the stage need not wait for all of them.
async function drawSwatches(
    pipelines: SphereViewPipelines,
    views: Map<HTMLCanvasElement, SphereView>,
): Promise<void> {
    for (const [small, view] of views) {
        await new SphereCanvas(pipelines, small).draw(view);
        await pipelines.device.queue.onSubmittedWorkDone();
    }
    swatches.dataset["drawn"] = "true"; // what the tests wait for
}

function describe({ material, model: wanted }: Scene): void {
    element("#material-name").textContent = material.name;
    const model = modelFor(material, wanted);
    const omitted = omittedBy(material, model);
    notice.textContent =
        omitted.length === 0 ? "" : `The model “${model}” leaves out ${omitted.join(" and ")}.`;
}

// The page as people see it: materials to choose, sliders, and a light to drag.
function showInterface(
    pipelines: SphereViewPipelines,
    scene: Scene,
    chosen: string,
    redraw: () => void,
): void {
    const panel = element<HTMLElement>("#controls");
    let removeControls = (): void => {};
    const show = (material: Material): void => {
        scene.material = material;
        describe(scene);
        removeControls();
        removeControls = showControls(panel, scene, () => {
            describe(scene);
            redraw();
        });
        redraw();
    };
    const views = new Map<HTMLCanvasElement, SphereView>();
    for (const name of bundledNames) {
        const material = bundledMaterial(name);
        const { button, canvas: small } = addSwatch(swatches, material.name, () => {
            markChosen(swatches, button);
            show(bundledMaterial(name));
        });
        const view = sphereView({ ...scene, material, light: DEFAULT_LIGHT }, SWATCH_HALF_EXTENT);
        views.set(small, view);
        if (name === chosen) {
            markChosen(swatches, button);
        }
    }
    element<HTMLInputElement>("#open").addEventListener("change", async ({ currentTarget }) => {
        const file = (currentTarget as HTMLInputElement).files?.[0];
        if (file !== undefined) {
            try {
                show(parseMaterial(await file.text(), file.name, metals));
                markChosen(swatches, undefined);
            } catch (error) {
                notice.textContent = error instanceof MaterialError ? error.message : String(error);
            }
        }
    });
    dragLight(canvas, STAGE_HALF_EXTENT, () => scene.light, (light) => {
        scene.light = light;
        redraw();
    });
    show(scene.material);
    void drawSwatches(pipelines, views);
}

async function start(): Promise<void> {
    const address = readAddress(location.search);
    const scene = sceneOf(address);
    const device = await requestDevice();
    const format = navigator.gpu.getPreferredCanvasFormat();
    const pipelines = await SphereViewPipelines.create(device, format);
    if (address.size !== undefined) {
        document.body.classList.add("picture");
        canvas.style.width = canvas.style.height = `${address.size / devicePixelRatio}px`;
        canvas.width = canvas.height = address.size;
        drawOnDemand(pipelines, scene, 1)();
        return;
    }
    const redraw = drawOnDemand(pipelines, scene, STAGE_HALF_EXTENT);
    showInterface(pipelines, scene, address.material ?? DEFAULT_MATERIAL, redraw);
    followSize(pipelines.device, canvas, redraw);
}

showUncaughtErrors();
void start();
