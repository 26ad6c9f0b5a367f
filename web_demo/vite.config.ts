// The page is built from what the project generates and ships: the WGSL and tables of the share folder
// (of the release build, unless LACQUER_SHARE names another) and the bundled materials.
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { defineConfig } from "vite";

const project = resolve(import.meta.dirname, "..");
const share = process.env["LACQUER_SHARE"] ?? resolve(project, "build/release/share/lacquer");
const exported = resolve(share, "shaders");
const shaders = resolve(exported, "wgsl/kernel");
if (!existsSync(shaders)) {
    throw new Error(`${shaders} is missing: build Lacquer first, or set LACQUER_SHARE`);
}

export default defineConfig({
    base: "./",
    resolve: {
        alias: {
            "@exported": exported,
            "@shaders": shaders,
            "@tables": resolve(project, "tables"),
        },
    },
    server: { fs: { allow: [import.meta.dirname, share, resolve(project, "tables")] } },
    build: { target: "es2022", chunkSizeWarningLimit: 1000 },
});
