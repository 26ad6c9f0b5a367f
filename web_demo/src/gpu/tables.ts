// The baked tables as a texture: the file beside the page that `lacquer export` writes too.
import tablesAddress from "@exported/tables/lacquer_tables.rgba32ui?url";
import { fail } from "../fail";

const BYTES_PER_TEXEL = 16;

// `columns` wide, as the shaders read it.
export async function loadTables(device: GPUDevice, columns: number): Promise<GPUTexture> {
    const response = await fetch(tablesAddress);
    if (!response.ok) {
        fail(`The tables could not be loaded: ${tablesAddress}: ${response.statusText}.`);
    }
    const bytes = await response.arrayBuffer();
    const bytesPerRow = columns * BYTES_PER_TEXEL;
    const size = [columns, bytes.byteLength / bytesPerRow];
    const texture = device.createTexture({
        label: "tables",
        size,
        format: "rgba32uint",
        usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
    });
    device.queue.writeTexture({ texture }, bytes, { bytesPerRow }, size);
    return texture;
}
