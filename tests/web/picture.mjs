// Pictures of the sphere and the difference between two of them.
import { PNG } from "./packages.mjs";

// Pixels whose centre is nearer the sphere's edge than this many pixels are not compared: the page
// smooths the edge over one pixel, the reference does not.
const EDGE_PIXELS = 1;

export function readPicture(bytes) {
    return PNG.sync.read(bytes);
}

// Luminance-like sum of the channels of pixel (x, y), 0 to 765.
export function brightness({ data, width }, x, y) {
    const first = 4 * (y * width + x);
    return data[first] + data[first + 1] + data[first + 2];
}

// The largest difference in any channel inside the sphere that fills the square pictures, in levels
// of 255, and where it is.
export function largestDifference(actual, expected) {
    if (actual.width !== expected.width || actual.height !== expected.height) {
        throw new Error(`sizes differ: ${actual.width} and ${expected.width}`);
    }
    const size = actual.width;
    let largest = { levels: 0, x: 0, y: 0, compared: 0 };
    for (let y = 0; y < size; y++) {
        for (let x = 0; x < size; x++) {
            if (Math.hypot(x + 0.5 - size / 2, y + 0.5 - size / 2) > size / 2 - EDGE_PIXELS) {
                continue;
            }
            largest.compared++;
            for (let channel = 0; channel < 3; channel++) {
                const index = 4 * (y * size + x) + channel;
                const levels = Math.abs(actual.data[index] - expected.data[index]);
                if (levels > largest.levels) {
                    largest = { ...largest, levels, x, y };
                }
            }
        }
    }
    return largest;
}
