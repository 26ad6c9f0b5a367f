// The materials that the project ships, by the names of their files.
import opticalConstants from "@tables/optical_constants.json?raw";
import type { Material } from "./material";
import { parseMaterial, parseMetals } from "./parse";
import { MaterialError, NotShownError } from "./place";

const texts = import.meta.glob<string>("@tables/materials/*.json", {
    eager: true,
    query: "?raw",
    import: "default",
});

const files = new Map(
    Object.entries(texts).map(([path, text]) => [path.replace(/^.*\/|\.json$/g, ""), text]),
);

const allNames = [...files.keys()].sort();

export const metals = parseMetals(opticalConstants, "optical_constants.json");

// Read afresh at each call, so that it may be edited. Throws MaterialError for an unknown name, and
// NotShownError for a material that the page does not show.
export function bundledMaterial(name: string): Material {
    const text = files.get(name);
    if (text === undefined) {
        throw new MaterialError(`the material '${name}' is not one of: ${allNames.join(", ")}`);
    }
    return parseMaterial(text, `${name}.json`, metals);
}

function isShown(name: string): boolean {
    try {
        bundledMaterial(name);
        return true;
    } catch (error) {
        if (error instanceof NotShownError) {
            return false;
        }
        throw error;
    }
}

// Of those that the page shows.
export const bundledNames: readonly string[] = allNames.filter(isShown);
