// SPDX-License-Identifier: MIT

// Writes sky.exr, the environment of serapis_env.xml: `node scenes/assignment-2/serapis/sky.mjs`.
// Radiance of direction d (y up), before the colours: a sky that fades from the zenith to the
// horizon, a floor, and lobes strength * exp(sharpness * (d . axis - 1)) for a sun and a cool fill.
import {writeFileSync} from 'node:fs';

const [columns, rows] = [256, 128];
const zenith = [0.16, 0.30, 0.62];
const horizon = [0.80, 0.72, 0.62];
const floor = [0.20, 0.16, 0.13];
const lobes = [
    {axis: [0.65, 0.55, -0.52], sharpness: 30, strength: [13, 10.5, 7.5]},
    {axis: [-0.85, 0.25, -0.46], sharpness: 12, strength: [0.3, 0.6, 1.3]},
];

function radiance(d) {
    const fade = Math.min(1, Math.max(0, (d[1] + 0.04) / 0.08)); // over 5 degrees of horizon
    const height = Math.sqrt(Math.max(0, d[1]));
    return [0, 1, 2].map((c) => {
        const sky = horizon[c] + (zenith[c] - horizon[c]) * height;
        const lights = lobes.map(({axis, sharpness, strength}) => {
            const cosine = axis.reduce((sum, x, i) => sum + x * d[i], 0) / Math.hypot(...axis);
            return strength[c] * Math.exp(sharpness * (cosine - 1));
        });
        return floor[c] + (sky - floor[c]) * fade + lights.reduce((a, b) => a + b);
    });
}

/// Direction of a texel as Nori looks it up: column = (1 - u) columns, row = (1 - v) rows with
/// u = atan2(z, x) / 2 pi and v = acos(y) / pi, so that the last rows are the zenith.
function direction(column, row) {
    const phi = 2 * Math.PI * (1 - column / columns);
    const theta = Math.PI * (1 - row / rows);
    return [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)];
}

/// Bits of a positive normal number as a 16-bit float, rounded to nearest.
function half(value) {
    const exponent = Math.floor(Math.log2(value));
    return ((exponent + 15) << 10) + Math.round((value / 2 ** exponent - 1) * 1024);
}

// OpenEXR file layout: one uncompressed part of scan lines, channels in alphabetical order.
const bytes = (...parts) => Buffer.concat(parts.map((part) =>
    typeof part === 'string' ? Buffer.from(part + '\0') : Buffer.from(part)));
const int = (...values) => Buffer.from(Int32Array.from(values).buffer);
const float = (...values) => Buffer.from(Float32Array.from(values).buffer);
const attribute = (name, type, value) => bytes(name, type, int(value.length), value);
const channel = (name) => bytes(name, int(1), [0, 0, 0, 0], int(1, 1)); // 1: half; no subsampling
const window = int(0, 0, columns - 1, rows - 1);
const header = bytes(
    int(20000630, 2),
    attribute('channels', 'chlist', bytes(channel('B'), channel('G'), channel('R'), [0])),
    attribute('compression', 'compression', Buffer.from([0])),
    attribute('dataWindow', 'box2i', window),
    attribute('displayWindow', 'box2i', window),
    attribute('lineOrder', 'lineOrder', Buffer.from([0])),
    attribute('pixelAspectRatio', 'float', float(1)),
    attribute('screenWindowCenter', 'v2f', float(0, 0)),
    attribute('screenWindowWidth', 'float', float(1)),
    [0]);

const lineBytes = 3 * 2 * columns;
const offsets = Buffer.alloc(8 * rows);
const lines = Array.from({length: rows}, (_, row) => {
    offsets.writeBigUInt64LE(BigInt(header.length + 8 * rows + row * (8 + lineBytes)), 8 * row);
    const colours = Array.from({length: columns}, (_, column) => radiance(direction(column, row)));
    const halves = [2, 1, 0].flatMap((c) => colours.map((colour) => half(colour[c])));
    return bytes(int(row, lineBytes), Buffer.from(Uint16Array.from(halves).buffer));
});
writeFileSync(new URL('sky.exr', import.meta.url), Buffer.concat([header, offsets, ...lines]));
