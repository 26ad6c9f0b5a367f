// Messages on standard input and output: a 32-bit little-endian length, as many bytes of JSON, and
// the bytes that the JSON announces.
import process from 'node:process';

// Standard input, by the number of bytes wanted. Ends the process where there are no more.
export class Input {
    constructor() {
        this.chunks = process.stdin[Symbol.asyncIterator]();
        this.chunk = new Uint8Array();
    }

    async bytes(size) {
        const bytes = new Uint8Array(size);
        for (let filled = 0; filled < size; ) {
            if (this.chunk.length === 0) await this.fetch();
            const part = this.chunk.subarray(0, size - filled);
            bytes.set(part, filled);
            filled += part.length;
            this.chunk = this.chunk.subarray(part.length);
        }
        return bytes;
    }

    async fetch() {
        const { value, done } = await this.chunks.next();
        if (done) process.exit(0);
        this.chunk = value;
    }

    // The next request; each of its buffers that the kernel reads holds its bytes as `data`.
    async request() {
        const [size] = new Uint32Array((await this.bytes(4)).buffer);
        const request = JSON.parse(new TextDecoder().decode(await this.bytes(size)));
        for (const buffer of request.buffers ?? [])
            if (buffer.kind !== 'write') buffer.data = await this.bytes(buffer.size);
        return request;
    }
}

export function writeBytes(bytes) {
    return new Promise((resolve) => process.stdout.write(bytes, resolve));
}

export async function writeAnswer(answer) {
    const json = new TextEncoder().encode(JSON.stringify(answer));
    await writeBytes(new Uint8Array(new Uint32Array([json.length]).buffer));
    await writeBytes(json);
}
