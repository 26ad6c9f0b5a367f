// A canvas that shows a sphere.
import { configureCanvas } from "./gpu/canvas";
import { createSphereViewPipeline, type SphereView, SphereViewPass } from "./passes/sphere_view";

// What all the canvases of a page share.
export interface Renderer {
    device: GPUDevice;
    format: GPUTextureFormat;
    pipeline: GPURenderPipeline;
}

export async function createRenderer(device: GPUDevice): Promise<Renderer> {
    const format = navigator.gpu.getPreferredCanvasFormat();
    return { device, format, pipeline: await createSphereViewPipeline(device, format) };
}

export class SphereCanvas {
    private readonly context: GPUCanvasContext;
    private readonly pass: SphereViewPass;

    constructor(
        private readonly renderer: Renderer,
        canvas: HTMLCanvasElement,
    ) {
        this.context = configureCanvas(renderer.device, canvas, renderer.format);
        this.pass = new SphereViewPass(renderer.device, renderer.pipeline);
    }

    draw(view: SphereView): void {
        const encoder = this.renderer.device.createCommandEncoder({ label: "SphereCanvas.draw" });
        this.pass.run(encoder, this.context.getCurrentTexture(), view);
        this.renderer.device.queue.submit([encoder.finish()]);
    }
}
