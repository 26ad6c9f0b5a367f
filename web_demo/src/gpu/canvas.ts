// Canvases that WebGPU draws to, at the size that they have on the screen.
import { assertPresent } from "../fail";

export function configureCanvas(
    device: GPUDevice,
    canvas: HTMLCanvasElement,
    format: GPUTextureFormat,
): GPUCanvasContext {
    const context = canvas.getContext("webgpu");
    assertPresent(context, "This browser's canvas cannot be drawn to by WebGPU.");
    context.configure({ device, format, alphaMode: "premultiplied" });
    return context;
}

// Gives `canvas` as many pixels as it covers on the screen, now and after each change of its size,
// and calls `resized`.
export function followSize(device: GPUDevice, canvas: HTMLCanvasElement, resized: () => void): void {
    const limit = device.limits.maxTextureDimension2D;
    const toPixels = (length: number): number =>
        Math.max(1, Math.min(limit, Math.round(length * devicePixelRatio)));
    new ResizeObserver(() => {
        canvas.width = toPixels(canvas.clientWidth);
        canvas.height = toPixels(canvas.clientHeight);
        resized();
    }).observe(canvas);
}
