// Runs WGSL compute kernels for the program that started it: in Deno (wgpu) or in Node (Dawn).
// Its first message tells the adapter; then each request gets one answer, which holds `error` where
// it failed. Ends with its input.
import process from 'node:process';
import { Input, writeAnswer, writeBytes } from './messages.mjs';

const SMALLEST_CAPACITY = 256;
const ERROR_FILTERS = ['internal', 'out-of-memory', 'validation'];

async function findGpu() {
    if (globalThis.Deno) return navigator.gpu;
    const { create, globals } = await import('webgpu');
    Object.assign(globalThis, globals);
    return create(['backend=vulkan']);
}

function kindOfBinding(kind) {
    if (kind === 'uniform') return 'uniform';
    return kind === 'read' ? 'read-only-storage' : 'storage';
}

function usageOf(kind) {
    if (kind === 'uniform') return GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
    if (kind === 'read') return GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST;
    return GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC;
}

class Runner {
    constructor(gpu, device) {
        this.gpu = gpu; // Dawn ends with its instance, even while a device is in use.
        this.device = device;
        this.kernels = new Map();
        this.buffers = new Map();
        this.problems = [];
        device.addEventListener('uncapturederror', (event) => {
            event.preventDefault();
            this.problems.push(event.error.message);
        });
    }

    // A buffer that grows as needed, one for each label.
    buffer(label, size, usage) {
        const kept = this.buffers.get(label);
        if (kept && kept.size >= size && kept.usage === usage) return kept;
        kept?.destroy();
        const capacity = 2 ** Math.ceil(Math.log2(Math.max(size, SMALLEST_CAPACITY)));
        const buffer = this.device.createBuffer({ label, size: capacity, usage });
        this.buffers.set(label, buffer);
        return buffer;
    }

    // Performs `action`; every error of WebGPU during it is thrown.
    async checked(action) {
        for (const filter of ERROR_FILTERS) this.device.pushErrorScope(filter);
        let result;
        try {
            result = await action();
        } catch (error) {
            this.problems.push(error.message);
        }
        const scopes = ERROR_FILTERS.map(() => this.device.popErrorScope());
        for (const error of await Promise.all(scopes))
            if (error) this.problems.push(error.message);
        if (this.problems.length > 0) throw new Error(this.problems.splice(0).join('\n'));
        return result;
    }

    compile({ kernel, source, entry_point, kinds }) {
        const { device } = this;
        const module = device.createShaderModule({ label: kernel, code: source });
        const layout = device.createBindGroupLayout({
            label: kernel,
            entries: kinds.map((kind, binding) => ({
                binding,
                visibility: GPUShaderStage.COMPUTE,
                buffer: { type: kindOfBinding(kind) },
            })),
        });
        const pipeline = device.createComputePipeline({
            label: kernel,
            layout: device.createPipelineLayout({ bindGroupLayouts: [layout] }),
            compute: { module, entryPoint: entry_point },
        });
        this.kernels.set(kernel, { layout, pipeline });
    }

    // The buffers of a request as the entries of a bind group.
    upload(buffers) {
        return buffers.map(({ kind, size, data }, binding) => {
            const buffer = this.buffer(`binding ${binding}`, size, usageOf(kind));
            if (data) this.device.queue.writeBuffer(buffer, 0, data);
            return { binding, resource: { buffer, size } };
        });
    }

    // Returns the results, mapped; unmap() them.
    async run({ kernel, groups, buffers }) {
        const { device } = this;
        const { layout, pipeline } = this.kernels.get(kernel);
        const entries = this.upload(buffers);
        const results = buffers.findIndex(({ kind }) => kind === 'write');
        const { size } = buffers[results];
        const readback = this.buffer(
            'results', size, GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST);
        const encoder = device.createCommandEncoder({ label: kernel });
        const pass = encoder.beginComputePass({ label: kernel });
        pass.setPipeline(pipeline);
        pass.setBindGroup(0, device.createBindGroup({ label: kernel, layout, entries }));
        pass.dispatchWorkgroups(groups);
        pass.end();
        encoder.copyBufferToBuffer(entries[results].resource.buffer, 0, readback, 0, size);
        device.queue.submit([encoder.finish()]);
        await readback.mapAsync(GPUMapMode.READ, 0, size);
        return { readback, size };
    }
}

async function answer(runner, request) {
    try {
        if (request.operation === 'compile') {
            await runner.checked(() => runner.compile(request));
            await writeAnswer({});
        } else {
            const { readback, size } = await runner.checked(() => runner.run(request));
            await writeAnswer({ size });
            await writeBytes(new Uint8Array(readback.getMappedRange(0, size)));
            readback.unmap();
        }
    } catch (error) {
        await writeAnswer({ error: error.message });
    }
}

async function start() {
    const gpu = await findGpu();
    const adapter = await gpu?.requestAdapter();
    if (!adapter) throw new Error('WebGPU offers no adapter');
    const device = await adapter.requestDevice({ label: 'lacquer' });
    await writeAnswer({ adapter: adapter.info.description });
    return new Runner(gpu, device);
}

try {
    const runner = await start();
    const input = new Input();
    for (;;) await answer(runner, await input.request());
} catch (error) {
    await writeAnswer({ error: error.message });
    process.exit(1);
}
