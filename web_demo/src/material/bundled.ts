// The materials that the project ships, by the names of their files.
import opticalConstants from "@tables/optical_constants.json?raw";
import type { Material } from "./material";
import { parseMaterial, parseMetals } from "./parse";
import { MaterialError } from "./place";

const texts = import.meta.glob<string>("@tables/materials/*.json", {
    eager: true,
    query: "?raw",
    import: "default",
});

const files = new Map(
    Object.entries(texts).map(([path, text]) => [path.replace(/^.*\/|\.json$/g, ""), text]),
);

export const metals = parseMetals(opticalConstants, "optical_constants.json");

export const bundledNames: readonly string[] = [...files.keys()].sort();

// Read afresh at each call, so that it may be edited. Throws MaterialError for an unknown name.
export function bundledMaterial(name: string): Material {
    const text = files.get(name);
    if (text === undefined) {
        throw new MaterialError(`the material '${name}' is not one of: ${bundledNames.join(", ")}`);
    }
    return parseMaterial(text, `${name}.json`, metals);
}
