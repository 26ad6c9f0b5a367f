// A canvas that shows a sphere.
import { configureCanvas } from "./gpu/canvas";
import { type SphereView, SphereViewPass, type SphereViewPipelines } from "./passes/sphere_view";

export class SphereCanvas {
    private readonly context: GPUCanvasContext;
    private readonly pass: SphereViewPass;

    constructor(
        private readonly pipelines: SphereViewPipelines,
        canvas: HTMLCanvasElement,
    ) {
        this.context = configureCanvas(pipelines.device, canvas, pipelines.format);
        this.pass = new SphereViewPass(pipelines);
    }

    async draw(view: SphereView): Promise<void> {
        const pipeline = await this.pipelines.get(view.level);
        const encoder = this.pipelines.device.createCommandEncoder({ label: "SphereCanvas.draw" });
        this.pass.run(encoder, this.context.getCurrentTexture(), view, pipeline);
        this.pipelines.device.queue.submit([encoder.finish()]);
    }
}
