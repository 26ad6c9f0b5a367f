// Makes the README's pictures anew, in this folder, by the built page and by reports:
//
//     ./dev build && cmake --build --preset release --target lacquer_web_demo
//     build/release/bin/lacquer compare --suite layered --report layered
//     build/release/bin/lacquer compare --suite diffuse-interfaces --report diffuse
//     node web_demo/pictures/make.mjs materials
//     node web_demo/pictures/make.mjs figure_13 layered
//     node web_demo/pictures/make.mjs figure_4 diffuse
//
// Needs Chromium (LACQUER_CHROMIUM names another than /usr/bin/chromium) and takes minutes without
// a GPU.
import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { launchBrowser, servePage } from "../../tests/web/browser.mjs";
import { shownMaterials } from "../../tests/web/materials.mjs";
import { PNG } from "../../tests/web/packages.mjs";

const FOLDER = import.meta.dirname;
const PROJECT = resolve(FOLDER, "../..");
const CHROMIUM = process.env.LACQUER_CHROMIUM ?? "/usr/bin/chromium";
const PATIENCE_MS = 300_000;

// Of the sheet of materials, in pixels; the README shows it at half its size.
const SPHERE = 164;
const SPACING = 172;
const COLUMNS = 10; // every other row has one sphere less and lies in the gaps of its neighbours

// The panel of a report that a picture shows, `width` pixels wide.
const FIGURES = {
    figure_4: { panel: "#figure-4 .panel", title: "eta 0.8, alpha 0.1", width: 846 },
    figure_13: { panel: "#figure-13 .panel", title: "In the studio", width: 760 },
};

// The sphere of `material` in the model that the page chooses, on nothing.
async function sphereOf(browser, address, material) {
    const page = await browser.newPage({ viewport: { width: SPHERE, height: SPHERE } });
    await page.goto(`${address}?material=${material}&size=${SPHERE}`);
    await page.waitForSelector("body[data-drawn]", { timeout: PATIENCE_MS });
    await page.addStyleTag({ content: "html, body, main { background: none !important; }" });
    const bytes = await page.locator("#stage").screenshot({ omitBackground: true });
    await page.close();
    return PNG.sync.read(bytes);
}

// The row and the place in it, in spheres, of sphere `index`.
function placeOf(index) {
    const ofTwoRows = 2 * COLUMNS - 1;
    const row = 2 * Math.floor(index / ofTwoRows);
    const rest = index % ofTwoRows;
    return rest < COLUMNS ? { row, column: rest } : { row: row + 1, column: rest - COLUMNS + 0.5 };
}

// Squares of neighbouring rows overlap where both are empty.
function paint(sheet, sphere, left, top) {
    for (let y = 0; y < SPHERE; y++) {
        for (let x = 0; x < SPHERE; x++) {
            const from = 4 * (y * SPHERE + x);
            const to = 4 * ((top + y) * sheet.width + left + x);
            if (sphere.data[from + 3] > sheet.data[to + 3]) {
                sphere.data.copy(sheet.data, to, from, from + 4);
            }
        }
    }
}

async function materialsSheet(browser) {
    const server = await servePage(join(PROJECT, "build/release/web"));
    const rowHeight = Math.round((SPACING * Math.sqrt(3)) / 2);
    const lastRow = placeOf(shownMaterials.length - 1).row;
    const sheet = new PNG({ width: COLUMNS * SPACING, height: lastRow * rowHeight + SPACING });
    const margin = (SPACING - SPHERE) / 2;
    for (const [index, material] of shownMaterials.entries()) {
        const { row, column } = placeOf(index);
        const sphere = await sphereOf(browser, server.address, material);
        paint(sheet, sphere, column * SPACING + margin, row * rowHeight + margin);
    }
    await server.close();
    return PNG.sync.write(sheet);
}

async function figurePicture(browser, { panel, title, width }, report) {
    const viewport = { width: width + 200, height: 1200 };
    const page = await browser.newPage({ viewport, colorScheme: "dark" });
    await page.goto(pathToFileURL(resolve(report, "report.html")).href);
    await page.addStyleTag({
        content: `.panel { width: ${width}px; margin: 0; padding: 18px; box-sizing: border-box; }`,
    });
    const heading = page.getByRole("heading", { name: title, exact: true });
    return page.locator(panel).filter({ has: heading }).screenshot();
}

const [name, report] = process.argv.slice(2);
if (name !== "materials" && !(name in FIGURES && report !== undefined)) {
    const names = Object.keys(FIGURES).join("|");
    console.error(`usage: make.mjs materials, or make.mjs ${names} REPORT_FOLDER`);
    process.exit(2);
}
const browser = await launchBrowser(CHROMIUM, { webgpu: true });
const picture = name === "materials"
    ? await materialsSheet(browser)
    : await figurePicture(browser, FIGURES[name], report);
await browser.close();
writeFileSync(join(FOLDER, `${name}.png`), picture);
