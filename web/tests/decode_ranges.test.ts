import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { basename, delimiter } from 'node:path';
import { test } from 'node:test';
import { inflateSync } from 'node:zlib';
import { parseManifest } from '../src/bundle/parse';
import { decodeRanges } from '../src/decode/ranges';

const folders = process.env['NEARFAR_BUNDLES']?.split(delimiter) ?? [];

for (const folder of folders) {
  /** Writes the codes of all rings' maps beside the bundle, for a comparison in Python. */
  test(`codes of a bundle: ${basename(folder)}`, async () => {
    const manifest = parseManifest(await readFile(`${folder}/manifest.json`, 'utf8'));
    const [region] = manifest.regions;
    assert.ok(region);
    const layout = { size: manifest.map.face_size, tile: manifest.map.tile, step: region.range.step };
    const area = layout.size ** 2;
    const perFace = (layout.size / layout.tile) ** 2;
    const inflateRanges = async (name: string) => new Uint8Array(inflateSync(await readFile(`${folder}/${name}`)));
    let codes = new Uint16Array(6 * area);
    for (const [number, { map }] of region.rings.entries()) {
      if (number === 0 || !map) continue;
      if (Array.isArray(map.range)) {
        for (const [face, name] of map.range.entries()) {
          const faceTiles = map.tiles.filter((tile) => Math.floor(tile / perFace) === face).map((tile) => tile % perFace);
          const faceCodes = codes.subarray(face * area, (face + 1) * area);
          decodeRanges(await inflateRanges(name), faceCodes, null, faceTiles, layout);
        }
      } else if (typeof map.range === 'string') {
        const before = codes;
        codes = before.slice();
        decodeRanges(await inflateRanges(map.range), codes, before, map.tiles, layout);
      }
      await writeFile(`${folder}.${number}.u16`, codes);
    }
  });
}

test('damaged ranges are rejected', () => {
  const layout = { size: 4, tile: 4, step: 0.001 };
  for (const raw of [new Uint8Array(3), new Uint8Array(36), new Uint8Array(36).fill(255), new Uint8Array(40)]) {
    assert.throws(() => decodeRanges(raw, new Uint16Array(96), null, [0], layout), /expected ranges/);
  }
});
