// Debian's Chromium with and without WebGPU, and a server for the page.
import { chromium, preview } from "./packages.mjs";

// Nothing that the browser does by itself disturbs the test, and colours are shown as they are.
const QUIET = [
    "--no-sandbox",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-quic",
    "--no-first-run",
    "--force-color-profile=srgb",
];

// WebGPU on the CPU (SwiftShader). The last three are for the canvas: without them only compute works.
const WEBGPU = [
    "--enable-unsafe-webgpu",
    "--use-webgpu-adapter=swiftshader",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=vulkan",
];
const NO_WEBGPU = ["--disable-features=WebGPU", "--disable-blink-features=WebGPU"];

export function launchBrowser(executablePath, { webgpu }) {
    const args = [...QUIET, ...(webgpu ? WEBGPU : NO_WEBGPU)];
    return chromium.launch({ executablePath, headless: true, args });
}

// Serves the built page in `folder`; returns its address and what ends it.
export async function servePage(folder) {
    const server = await preview({
        configFile: false,
        logLevel: "warn",
        build: { outDir: folder },
        preview: { host: "127.0.0.1", port: 0 },
    });
    return { address: server.resolvedUrls.local[0], close: () => server.close() };
}
