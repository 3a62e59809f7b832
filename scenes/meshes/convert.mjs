// SPDX-License-Identifier: MIT

// Writes every OBJ below scenes/: README.md beside this file says from what and how to run it.
import {createRequire} from 'node:module';
import {writeFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {join, resolve} from 'node:path';

const scenes = fileURLToPath(new URL('..', import.meta.url));
const require = createRequire(join(resolve(process.argv[2] ?? '.'), 'package.json'));

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const normalize = (a) => a.map((x) => x / Math.hypot(...a));
const cross = (a, b) =>
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/// A mesh is {positions: [[x, y, z]], cells: [[i, j, k]], uvs: [[[u, v] per corner]] or none};
/// merges vertices at the same place and drops triangles that thereby lose their area.
function weld({positions, cells, uvs}) {
    const first = new Map();
    const merged = Array.from(positions, (p) => {
        const key = Array.from(p, (x) => Math.fround(x)).join();
        return first.get(key) ?? first.set(key, first.size).get(key);
    });
    const triangles = cells.map((cell) => Array.from(cell, (i) => merged[i]));
    const keep = triangles.map((t) => new Set(t).size === 3);
    return {
        positions: [...first.keys()].map((key) => key.split(',').map(Number)),
        cells: triangles.filter((_, f) => keep[f]),
        uvs: uvs?.filter((_, f) => keep[f]),
    };
}

/// Keeps the connected parts of at least `minimum` triangles, and the vertices that they use.
function dropCrumbs({positions, cells}, minimum) {
    const parent = positions.map((_, i) => i);
    const root = (i) => {
        while (parent[i] !== i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const [a, b, c] of cells) parent[root(a)] = parent[root(b)] = root(c);
    const size = new Map();
    for (const [a] of cells) size.set(root(a), (size.get(root(a)) ?? 0) + 1);

    const renumbered = new Map();
    const number = (i) => renumbered.get(i) ?? renumbered.set(i, renumbered.size).get(i);
    const kept = cells.filter(([a]) => size.get(root(a)) >= minimum).map((c) => c.map(number));
    return {positions: [...renumbered.keys()].map((i) => positions[i]), cells: kept};
}

/// Unit normal per corner, shape [cells][3]: the mean of the faces around the vertex, weighted by
/// their angle there, over those that meet this face at less than `creaseDegrees`.
function cornerNormals({positions, cells}, creaseDegrees) {
    const limit = Math.cos((creaseDegrees * Math.PI) / 180);
    const around = positions.map(() => []);
    const faceNormals = cells.map((cell, f) => {
        const p = cell.map((i) => positions[i]);
        const normal = normalize(cross(subtract(p[1], p[0]), subtract(p[2], p[0])));
        cell.forEach((vertex, c) => {
            const to = (k) => normalize(subtract(p[(c + k) % 3], p[c]));
            const angle = Math.acos(Math.max(-1, Math.min(1, dot(to(1), to(2)))));
            around[vertex].push({normal, angle});
        });
        return normal;
    });
    return cells.map((cell, f) => cell.map((vertex) => normalize(
        around[vertex].filter(({normal}) => dot(normal, faceNormals[f]) >= limit)
            .reduce((sum, {normal, angle}) => sum.map((x, i) => x + angle * normal[i]), [0, 0, 0]))));
}

/// Writes `mesh` with smooth normals, and with texture coordinates where it has them.
function writeObj(name, origin, mesh, {creaseDegrees = 60, decimals = 5} = {}) {
    const format = (values, digits) => values.map((x) => String(+x.toFixed(digits) + 0)).join(' ');
    const table = () => ({lines: new Map(), index(line) {
        return this.lines.get(line) ?? this.lines.set(line, this.lines.size + 1).get(line);
    }});
    const [normals, uvs] = [table(), table()];
    const corners = cornerNormals(mesh, creaseDegrees);
    const faces = mesh.cells.map((cell, f) => 'f ' + cell.map((vertex, c) => [vertex + 1,
        mesh.uvs ? uvs.index(format(mesh.uvs[f][c], 5)) : '',
        normals.index(format(corners[f][c], 3))].join('/')).join(' '));
    const text = [`# ${origin}; made by scenes/meshes/convert.mjs`,
        ...mesh.positions.map((p) => `v ${format(p, decimals)}`),
        ...[...uvs.lines.keys()].map((line) => `vt ${line}`),
        ...[...normals.lines.keys()].map((line) => `vn ${line}`), ...faces, ''].join('\n');
    writeFileSync(join(scenes, name), text);
    console.log(`${name}: ${mesh.positions.length} vertices, ${mesh.cells.length} triangles, ` +
        `${Math.round(text.length / 1024)} KiB`);
}

/// Grid of quads over the unit square, `at(u, v)` giving positions; faces wind along u, then v.
function grid(columns, rows, at) {
    const mesh = {positions: [], cells: [], uvs: []};
    for (let j = 0; j <= rows; ++j)
        for (let i = 0; i <= columns; ++i) mesh.positions.push(at(i / columns, j / rows));
    const corner = (i, j) => ({index: j * (columns + 1) + i, uv: [i / columns, j / rows]});
    for (let j = 0; j < rows; ++j)
        for (let i = 0; i < columns; ++i) {
            const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            for (const triangle of [[a, b, c], [a, c, d]]) {
                mesh.cells.push(triangle.map(({index}) => index));
                mesh.uvs.push(triangle.map(({uv}) => uv));
            }
        }
    return weld(mesh);
}

/// Turns `profile`, points (radius, height) with the outside on its right hand, about the y axis.
function lathe(profile, segments) {
    const rows = profile.length - 1;
    return grid(segments, rows, (u, v) => {
        const [radius, height] = profile[Math.round(v * rows)];
        const turn = 2 * Math.PI * (Math.round(u * segments) % segments) / segments;
        return [radius * Math.sin(turn), height, radius * Math.cos(turn)];
    });
}

/// Cube from -1 to 1 with the whole texture on each face.
function cube() {
    const faces = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]].map((n) => {
        const s = n[1] ? [1, 0, 0] : [n[2], 0, -n[0]];
        const t = cross(n, s);
        return grid(1, 1, (u, v) => n.map((x, i) => x + (2 * u - 1) * s[i] + (2 * v - 1) * t[i]));
    });
    return weld({
        positions: faces.flatMap((face) => face.positions),
        cells: faces.flatMap((face, k) => face.cells.map((cell) => cell.map((i) => i + 4 * k))),
        uvs: faces.flatMap((face) => face.uvs),
    });
}

const semicircle = Array.from({length: 33}, (_, i) => {
    const theta = (Math.PI * i) / 32;
    return i % 32 ? [Math.sin(theta), -Math.cos(theta)] : [0, i ? 1 : -1];
});
const cup = [[0, 0], [2.6, 0], [3, 0.4], [3.9, 4], [4.4, 8], [4.3, 8.2], [4.1, 8], [3.6, 4], [2.7, 0.9], [0, 0.7]];

writeObj('meshes/quad.obj', 'square from -1 to 1 in the plane z = 0, facing +z',
    grid(1, 1, (u, v) => [2 * u - 1, 2 * v - 1, 0]));
writeObj('meshes/cube.obj', 'cube from -1 to 1', cube());
writeObj('meshes/sphere.obj', 'unit sphere', lathe(semicircle, 64));
writeObj('meshes/cup.obj', 'cup without a handle, 8.2 tall', lathe(cup, 48));
writeObj('meshes/bunny.obj', 'Stanford bunny, npm package bunny 1.0.1', weld(require('bunny')), {creaseDegrees: 180});
writeObj('meshes/teapot.obj', 'Utah teapot, npm package teapot 1.0.0', weld(require('teapot')));

// The bust: half a turn, so that it looks to -z, then to the size and place that the course's own
// serapis scenes point their camera at.
const bust = dropCrumbs(weld(require('snowden/lo')), 100);
const bounds = [0, 1, 2].map((i) => bust.positions.map((p) => p[i]))
    .map((values) => [Math.min(...values), Math.max(...values)]);
const scale = 0.75 / (bounds[1][1] - bounds[1][0]);
const centre = bounds.map(([low, high]) => (low + high) / 2);
bust.positions = bust.positions.map((p) => subtract(p, centre))
    .map(([x, y, z]) => [-0.3 - scale * x, -0.4 + scale * y, -scale * z]);
writeObj('assignment-2/serapis/serapis.obj', 'bust, npm package snowden 1.0.1, MIT', bust);
