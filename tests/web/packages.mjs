// The npm packages of web_demo, which the tests use too.
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const require = createRequire(new URL("../../web_demo/package.json", import.meta.url));

export const { chromium } = require("playwright-core");
export const { PNG } = require("pngjs");
export const { preview } = await import(pathToFileURL(require.resolve("vite")).href);
