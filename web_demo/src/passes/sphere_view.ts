// Draws the sphere with the generated shaders of the variant `sphere_view`.
import { makeShaderDataDefinitions, makeStructuredView } from "webgpu-utils";
import type { Vec3 } from "wgpu-matrix";
import { assertPresent } from "../fail";
import { loadTables } from "../gpu/tables";
import type { Rgb } from "../material/material";
import type { Row } from "../material/pack";

// A directional light: the unit direction towards it, and its irradiance across the beam.
export interface Light {
    direction: Vec3;
    irradiance: Rgb;
}

export interface SphereView {
    level: string; // of the shader source
    surface: Row[]; // at most LQ_VIEW_MAX_ROWS of shader_src/viewer/view.glsl
    lights: Light[]; // at most 4
    // From the centre of the picture to its nearest edge, in radii of the sphere.
    halfExtent: number;
}

const sources = import.meta.glob<string>("@shaders/*_sphere_view.{vert,frag}.wgsl", {
    eager: true,
    query: "?raw",
    import: "default",
});

function sourceOf(level: string, stage: "vert" | "frag"): string {
    const name = `${level}_sphere_view.${stage}.wgsl`;
    const found = Object.entries(sources).find(([path]) => path.endsWith(`/${name}`));
    assertPresent(found, `The generated shader ${name} is missing.`);
    return found[1];
}

// The block of uniforms, the same in all levels.
const viewDefinition = makeShaderDataDefinitions(sourceOf("plain", "frag")).uniforms["view"];

// Columns of the texture of the tables, as the shaders have them.
function tableColumns(): number {
    const found = /LQ_TABLE_COLUMNS: i32 = (\d+)/.exec(sourceOf("coated", "frag"));
    assertPresent(found, "The generated shader does not say how wide the tables are.");
    return Number(found[1]);
}

// The pipelines of all levels, and what all drawings bind.
export class SphereViewPipelines {
    private readonly pipelines = new Map<string, Promise<GPURenderPipeline>>();

    private constructor(
        readonly device: GPUDevice,
        readonly format: GPUTextureFormat,
        readonly bindings: GPUBindGroupLayout,
        readonly tables: GPUTexture,
    ) {}

    static async create(
        device: GPUDevice,
        format: GPUTextureFormat,
    ): Promise<SphereViewPipelines> {
        const bindings = device.createBindGroupLayout({
            label: "SphereViewPipelines.bindings",
            entries: [
                {
                    binding: 0,
                    visibility: GPUShaderStage.VERTEX | GPUShaderStage.FRAGMENT,
                    buffer: {},
                },
                {
                    binding: 1,
                    visibility: GPUShaderStage.FRAGMENT,
                    texture: { sampleType: "uint" },
                },
            ],
        });
        const tables = await loadTables(device, tableColumns());
        return new SphereViewPipelines(device, format, bindings, tables);
    }

    // Made when it is first asked for.
    get(level: string): Promise<GPURenderPipeline> {
        const made = this.pipelines.get(level) ?? this.make(level);
        this.pipelines.set(level, made);
        return made;
    }

    private make(level: string): Promise<GPURenderPipeline> {
        const label = `SphereViewPipelines.${level}`;
        const module = (stage: "vert" | "frag"): GPUShaderModule =>
            this.device.createShaderModule({ label, code: sourceOf(level, stage) });
        return this.device.createRenderPipelineAsync({
            label,
            layout: this.device.createPipelineLayout({ label, bindGroupLayouts: [this.bindings] }),
            vertex: { module: module("vert") },
            fragment: { module: module("frag"), targets: [{ format: this.format }] },
        });
    }
}

export class SphereViewPass {
    private readonly uniforms;
    private readonly uniformBuffer: GPUBuffer;
    private readonly bindGroup: GPUBindGroup;

    constructor(private readonly pipelines: SphereViewPipelines) {
        assertPresent(viewDefinition, "The generated shader has no uniform block 'view'.");
        this.uniforms = makeStructuredView(viewDefinition);
        this.uniformBuffer = pipelines.device.createBuffer({
            label: "SphereViewPass.uniformBuffer",
            size: this.uniforms.arrayBuffer.byteLength,
            usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST,
        });
        this.bindGroup = pipelines.device.createBindGroup({
            label: "SphereViewPass.bindGroup",
            layout: pipelines.bindings,
            entries: [
                { binding: 0, resource: { buffer: this.uniformBuffer } },
                { binding: 1, resource: pipelines.tables.createView({ label: "tables" }) },
            ],
        });
    }

    // Records the drawing of `view` by the pipeline of its level, on a transparent background, over
    // the whole of `target`.
    run(
        encoder: GPUCommandEncoder,
        target: GPUTexture,
        view: SphereView,
        pipeline: GPURenderPipeline,
    ): void {
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
        this.pipelines.device.queue.writeBuffer(this.uniformBuffer, 0, this.uniforms.arrayBuffer);
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
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, this.bindGroup);
        pass.draw(3);
        pass.end();
    }
}
