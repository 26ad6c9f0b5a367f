// The web page in a real browser: its pictures against the C++ reference's, its controls, and what
// it says where it cannot work.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { launchBrowser, servePage } from "./browser.mjs";
import { blendedMaterials, shownMaterials } from "./materials.mjs";
import { brightness, largestDifference, readPicture } from "./picture.mjs";

const { LACQUER_PROGRAM, LACQUER_PAGE, LACQUER_CHROMIUM, LACQUER_SCREENSHOT } = process.env;

const SIZE = 128; // of pictures: a processor draws them, and takes its time for stacks
const PATIENCE_MS = 120_000;
// One level for the rounding of either side, which may fall on different sides of a half.
const TOLERANCE_LEVELS = 2;

// Unit directions: every material is lit from the left, and some from behind.
const FROM_THE_LEFT = "-0.48,0.64,0.6";
const FROM_BEHIND = "0.8,-0.36,-0.48";
const PICTURES = [
    ...shownMaterials.map((material) => [material, "plain", FROM_THE_LEFT]),
    ...["aluminium", "gold", "porcelain"].map((material) => [material, "plain", FROM_BEHIND]),
    ["red_plastic", "clearcoat", FROM_THE_LEFT],
    ["blue_lacquer", "weidlich-wilkie", FROM_THE_LEFT],
    ["lacquered_wood", "openpbr-coat", FROM_THE_LEFT],
    ["celadon", "coated-exact", FROM_THE_LEFT],
    ["amber_varnish", "coated-exact", FROM_BEHIND],
    ["air_film_underwater", "coated-exact", FROM_THE_LEFT],
    ["porcelain", "coated-ggx", FROM_THE_LEFT],
    ["two_tone_car_paint", "stack", FROM_THE_LEFT],
    ["lacquered_copper", "stack", FROM_THE_LEFT],
    ["frosted_metal", "stack", FROM_BEHIND],
    ["tinted_glass", "stack", FROM_THE_LEFT],
    ["frosted_glass", "stack", FROM_BEHIND],
    ["air_film_underwater", "stack", FROM_THE_LEFT],
    ["varnished_wood", "stack", FROM_BEHIND],
    ["five_layer_furnace", "stack", FROM_THE_LEFT],
    ["pearl_over_gold", "stack", FROM_THE_LEFT],
];

// What the page says instead of shading, as the C++ side does.
const UNSHADEABLE = [
    [
        "gold",
        "coated-exact",
        "satin gold: /layers: the model 'coated-exact' shades one layer over a Lambertian base, " +
            "and there is none.",
    ],
    [
        "gold",
        "stack",
        "satin gold: /layers: the model 'stack' needs at least one layer.",
    ],
    [
        "pearl_over_gold",
        "coated-exact",
        "pearl over gold: /layers/0/medium/sigma_s: the model 'coated-exact' cannot shade a " +
            "medium that scatters.",
    ],
];

const DESKTOP = { width: 1280, height: 800 };
const SMALL = { width: 960, height: 480 }; // for stacks

const server = await servePage(LACQUER_PAGE);
after(() => server.close());

// Opens the page with the parameters `query` and waits until it has drawn.
async function load(page, query) {
    await page.goto(server.address + query);
    await page.waitForSelector("body[data-drawn], #failure:not([hidden])", {
        timeout: PATIENCE_MS,
    });
    const failure = page.locator("#failure");
    assert.equal(await failure.isVisible(), false, await failure.innerText());
}

async function openPage(browser, query, viewport) {
    const page = await browser.newPage({ viewport, deviceScaleFactor: 1 });
    await load(page, query);
    return page;
}

// Opens `material` as a file of that name.
async function openMaterial(page, name, material) {
    const buffer = Buffer.from(JSON.stringify(material));
    await page.locator("#open").setInputFiles({ name, mimeType: "application/json", buffer });
}

// The reference's picture of `material`.
function referencePicture(material, model, light, folder) {
    const file = join(folder, "reference.png");
    const what = ["--material", material, "--model", model, "--light", light];
    const how = ["--backend", "reference", "--size", `${SIZE}`, "-o", file];
    execFileSync(LACQUER_PROGRAM, ["sphere", ...what, ...how]);
    return readPicture(readFileSync(file));
}

describe("with WebGPU", () => {
    let browser;
    const folder = mkdtempSync(join(tmpdir(), "lacquer-web-"));
    before(async () => {
        browser = await launchBrowser(LACQUER_CHROMIUM, { webgpu: true });
    });
    after(async () => {
        await browser.close();
        rmSync(folder, { recursive: true });
    });

    describe("the picture is the reference's", () => {
        let page;
        before(async () => {
            page = await browser.newPage({ viewport: { width: SIZE, height: SIZE } });
        });
        after(() => page.close());

        for (const [material, model, light] of PICTURES) {
            test(`${material} as ${model} lit from ${light}`, async (context) => {
                const what = `?material=${material}&model=${model}&light=${light}`;
                await load(page, `${what}&studio=0&size=${SIZE}`);
                const actual = readPicture(await page.locator("#stage").screenshot());
                const expected = referencePicture(material, model, light, folder);
                const { levels, x, y, compared } = largestDifference(actual, expected);
                context.diagnostic(`largest difference: ${levels} of 255`);
                assert.ok(compared > 0.75 * SIZE * SIZE, `compared only ${compared} pixels`);
                assert.ok(levels <= TOLERANCE_LEVELS, `differs by ${levels} at (${x}, ${y})`);
            });
        }
    });

    test("the highlight follows the pointer", async () => {
        const page = await openPage(browser, "?material=gold&studio=0", { width: 1000, height: 800 });
        const { x, y, width, height } = await page.locator("#stage").boundingBox();
        const target = { x: Math.round(x + 0.58 * width), y: Math.round(y + 0.6 * height) };
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(target.x, target.y);
        await page.mouse.up();
        await page.waitForTimeout(200); // one frame and more
        const picture = readPicture(await page.screenshot());
        await page.close();
        const opposite = [Math.round(x + 0.42 * width), Math.round(y + 0.4 * height)];
        assert.ok(brightness(picture, target.x, target.y) > 600, "no highlight at the pointer");
        assert.ok(brightness(picture, ...opposite) < 400, "a highlight elsewhere");
    });

    test("choosing a material shows it and its numbers", async () => {
        const page = await openPage(browser, "?material=gold", DESKTOP);
        await page.getByRole("button", { name: "copper" }).first().click();
        assert.match(await page.locator("#material-name").innerText(), /copper/i);
        assert.match(await page.locator("#controls").innerText(), /kappa g/);
        await page.close();
    });

    test("the models offered are those that can shade the material", async () => {
        const page = await openPage(browser, "?material=celadon&model=plain", DESKTOP);
        const models = page.locator("#controls select").first();
        const offered = () => models.locator("option").allInnerTexts();
        assert.ok((await offered()).includes("coated-exact"));
        assert.match(await page.locator("#notice").innerText(), /“plain” leaves out/);
        await models.selectOption({ label: "coated-exact" });
        await page.locator("#notice:empty").waitFor({ state: "attached" });
        await page.getByRole("button", { name: "copper" }).first().click();
        assert.ok(!(await offered()).includes("coated-exact"));
        await page.close();
    });

    for (const [material, model, message] of UNSHADEABLE) {
        test(`${model} cannot shade ${material}: a clear message`, async () => {
            const page = await browser.newPage();
            await page.goto(`${server.address}?material=${material}&model=${model}`);
            const shown = page.locator("#failure-message:not(:empty)");
            await shown.waitFor();
            assert.equal(await shown.innerText(), message);
            await page.close();
        });
    }

    test("layers that the wanted model cannot shade are shaded as a stack", async () => {
        const page = await openPage(browser, "?material=two_tone_car_paint", SMALL);
        assert.equal(await page.locator("#controls select").first().inputValue(), "stack");
        assert.equal(await page.locator("#notice").innerText(), "");
        await page.close();
    });

    test("diffuse facets are left out by the models that are offered", async () => {
        const page = await openPage(browser, "", DESKTOP);
        await openMaterial(page, "facets.json", {
            layers: [{ interface: { ior: 1.5, alpha: 0.1 } }],
            base: { diffuse_facets: { albedo: [0.5, 0.5, 0.5], alpha: 0.3 } },
        });
        const notice = page.locator("#notice:not(:empty)");
        await notice.waitFor();
        assert.match(await notice.innerText(), /“plain” leaves out the roughness of the base/);
        const offered = await page.locator("#controls select").first().innerText();
        assert.ok(!offered.includes("stack"), offered);
        await page.close();
    });

    test("the index of a layer keeps the neighbours' within the ratios of the format", async () => {
        const page = await openPage(browser, "?material=wet_clay&model=plain", DESKTOP);
        await page.getByText("Layer 2").click();
        const index = page.locator("#controls .tp-lblv", { hasText: /^ior$/ }).locator("input");
        assert.equal(await index.count(), 2);
        await index.first().fill("3");
        await index.first().press("Enter");
        await index.last().fill("0.5");
        await index.last().press("Enter");
        assert.equal(await index.last().inputValue(), "1.000");
        await page.close();
    });

    test("a material file with an error is named, and the page goes on", async () => {
        const page = await openPage(browser, "", DESKTOP);
        await openMaterial(page, "bad.json", {
            layers: [{ interface: { ior: 9, alpha: 0.1 } }],
            base: { lambertian: { albedo: [0.5, 0.5, 0.5] } },
        });
        const notice = page.locator("#notice:not(:empty)");
        await notice.waitFor();
        assert.equal(
            await notice.innerText(),
            "bad.json: /layers/0/interface/ior: 9 is outside [0.3, 4]",
        );
        await page.close();
    });

    test("blended microsurfaces are offered to nobody, and asked for they are a clear message", async () => {
        assert.notEqual(blendedMaterials.length, 0);
        const page = await openPage(browser, "?material=gold", DESKTOP);
        assert.equal(await page.locator("#swatches button").count(), shownMaterials.length);
        for (const material of blendedMaterials) {
            await page.goto(`${server.address}?material=${material}`);
            const shown = page.locator("#failure-message:not(:empty)");
            await shown.waitFor();
            assert.match(
                await shown.innerText(),
                new RegExp(`^${material}.json: .*: this page does not show blended microsurfaces`),
            );
        }
        await page.close();
    });

    test("an unknown material in the address is a clear message", async () => {
        const page = await browser.newPage();
        await page.goto(`${server.address}?material=unobtainium`);
        const message = page.locator("#failure-message:not(:empty)");
        await message.waitFor();
        assert.match(await message.innerText(), /'unobtainium' is not one of: .*gold/);
        await page.close();
    });

    test("the page fits a desktop and a phone", async () => {
        const desktop = await openPage(browser, "", DESKTOP);
        await desktop.waitForSelector("#swatches[data-drawn]", { timeout: PATIENCE_MS });
        writeFileSync(LACQUER_SCREENSHOT, await desktop.screenshot());
        await desktop.close();
        const phone = await openPage(browser, "", { width: 390, height: 844 });
        const sideways = await phone.evaluate(() => document.body.scrollWidth - innerWidth);
        assert.ok(sideways <= 0, `the page is ${sideways} pixels too wide`);
        await phone.close();
    });
});

test("without WebGPU the page says so", async () => {
    const browser = await launchBrowser(LACQUER_CHROMIUM, { webgpu: false });
    try {
        const page = await browser.newPage();
        await page.goto(server.address);
        const message = page.locator("#failure-message:not(:empty)");
        await message.waitFor();
        assert.match(await message.innerText(), /no WebGPU|no graphics adapter/);
    } finally {
        await browser.close();
    }
});
