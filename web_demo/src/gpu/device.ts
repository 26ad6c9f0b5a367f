// The WebGPU device, and the page's end where there is none or it is lost.
import { assertPresent, fail } from "../fail";

const ADVICE = "Current versions of Chrome, Edge, Firefox and Safari have it.";

export async function requestDevice(): Promise<GPUDevice> {
    const gpu: GPU | undefined = navigator.gpu;
    assertPresent(gpu, `This browser has no WebGPU. ${ADVICE}`);
    const adapter = await gpu.requestAdapter();
    assertPresent(adapter, "WebGPU is there, but found no graphics adapter that it may use.");
    const device = await adapter.requestDevice({ label: "lacquer" });
    void device.lost.then((info) => fail(`The graphics device was lost. ${info.message}`));
    device.addEventListener("uncapturederror", (event) => fail(`WebGPU: ${event.error.message}`));
    return device;
}
