// Translates SPIR-V to WGSL and checks WGSL. Reads a JSON list of jobs from standard input, writes
// a list of answers: {spirv: words} gives {wgsl: text}, {wgsl: text} gives {spirv: words}; either
// gives {error} where naga refuses.
import { readFileSync } from 'node:fs';
import { parseSpirv, parseWgsl, validate, writeSpirv, writeWgsl } from 'naga-wasm';

function answer(job) {
    try {
        const module = job.spirv ? parseSpirv(Uint32Array.from(job.spirv)) : parseWgsl(job.wgsl);
        const info = validate(module);
        const reply = job.spirv
            ? { wgsl: writeWgsl(module, info) }
            : { spirv: Array.from(writeSpirv(module, info)) };
        info.free();
        module.free();
        return reply;
    } catch (error) {
        return { error: error.formatted ?? String(error) };
    }
}

const jobs = JSON.parse(readFileSync(0, 'utf8'));
process.stdout.write(JSON.stringify(jobs.map(answer)));
