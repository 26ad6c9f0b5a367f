// The bundled materials, by name: those that the page shows, and those that it does not.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

const FOLDER = join(import.meta.dirname, "../../tables/materials");

const names = readdirSync(FOLDER)
    .filter((file) => file.endsWith(".json"))
    .map((file) => file.slice(0, -".json".length))
    .sort();

function isBlended(name) {
    return readFileSync(join(FOLDER, `${name}.json`), "utf8").includes('"blend":');
}

export const shownMaterials = names.filter((name) => !isBlended(name));
export const blendedMaterials = names.filter(isBlended);
