// Draws the sphere with the generated shaders of the variant `sphere_view`.
import fragmentSource from "@shaders/plain_sphere_view.frag.wgsl?raw";
import vertexSource from "@shaders/plain_sphere_view.vert.wgsl?raw";
import { makeShaderDataDefinitions, makeStructuredView } from "webgpu-utils";
import type { Vec3 } from "wgpu-matrix";
import { assertPresent } from "../fail";
import type { Rgb } from "../material/material";
import type { Row } from "../material/pack";

// A directional light: the unit direction towards it, and its irradiance across the beam.
export interface Light {
    direction: Vec3;
    irradiance: Rgb;
}

export interface SphereView {
    surface: Row[];
    lights: Light[]; // at most 4
    // From the centre of the picture to its nearest edge, in radii of the sphere.
    halfExtent: number;
}

const viewDefinition = makeShaderDataDefinitions(fragmentSource).uniforms["view"];

export function createSphereViewPipeline(
    device: GPUDevice,
    format: GPUTextureFormat,
): Promise<GPURenderPipeline> {
    const label = "SphereViewPass.pipeline";
    const module = (code: string): GPUShaderModule => device.createShaderModule({ label, code });
    return device.createRenderPipelineAsync({
        label,
        layout: "auto",
        vertex: { module: module(vertexSource) },
        fragment: { module: module(fragmentSource), targets: [{ format }] },
    });
}

export class SphereViewPass {
    private readonly uniforms;
    private readonly uniformBuffer: GPUBuffer;
    private readonly bindGroup: GPUBindGroup;

    constructor(
        private readonly device: GPUDevice,
        private readonly pipeline: GPURenderPipeline,
    ) {
        assertPresent(viewDefinition, "The generated shader has no uniform block 'view'.");
        this.uniforms = makeStructuredView(viewDefinition);
        this.uniformBuffer = device.createBuffer({
            label: "SphereViewPass.uniformBuffer",
            size: this.uniforms.arrayBuffer.byteLength,
            usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST,
        });
        this.bindGroup = device.createBindGroup({
            label: "SphereViewPass.bindGroup",
            layout: pipeline.getBindGroupLayout(0),
            entries: [{ binding: 0, resource: { buffer: this.uniformBuffer } }],
        });
    }

    // Records the drawing of `view`, on a transparent background, over the whole of `target`.
    run(encoder: GPUCommandEncoder, target: GPUTexture, view: SphereView): void {
        const radius = Math.min(target.width, target.height) / (2 * view.halfExtent);
        this.uniforms.set({
            surface: view.surface,
            light_directions: view.lights.map((light) => [...light.direction, 0]),
            light_irradiances: view.lights.map((light) => [...light.irradiance, 0]),
            light_count: view.lights.length,
            background: [0, 0, 0, 0],
            half_extent: [target.width / (2 * radius), target.height / (2 * radius)],
            pixel: 1 / radius,
        });
        this.device.queue.writeBuffer(this.uniformBuffer, 0, this.uniforms.arrayBuffer);
        const pass = encoder.beginRenderPass({
            label: "SphereViewPass.run",
            colorAttachments: [
                {
                    view: target.createView({ label: "SphereViewPass.target" }),
                    loadOp: "clear",
                    storeOp: "store",
                },
            ],
        });
        pass.setPipeline(this.pipeline);
        pass.setBindGroup(0, this.bindGroup);
        pass.draw(3);
        pass.end();
    }
}
