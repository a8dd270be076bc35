import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { basename, delimiter } from 'node:path';
import { test } from 'node:test';
import { parseManifest } from '../src/bundle/parse';
import type { Buffers } from '../src/decode/geometry';
import { decodeGeometry } from '../src/decode/geometry';
import { NO_GROWTH } from '../src/decode/split/rule';
import type { FileData } from '../src/decode/messages';

const folders = process.env['NEARFAR_BUNDLES']?.split(delimiter) ?? [];

for (const folder of folders) {
  /** Writes all pieces of a bundle's geometry beside the bundle, for a comparison in Python. */
  test(`geometry of a bundle: ${basename(folder)}`, async () => {
    const manifest = parseManifest(await readFile(`${folder}/manifest.json`, 'utf8'));
    const [region] = manifest.regions;
    assert.ok(region);
    const cachedBuffers: Buffers = new Map();
    const sent = new Set<string>();
    const chunks: Uint8Array[] = [];
    let size = 0;
    const put = (rows: Float32Array | Uint16Array | Uint32Array | null) => {
      if (!rows) return null;
      const data = new Uint8Array(rows.buffer, rows.byteOffset, rows.byteLength);
      const place = { start: size, count: rows.length, type: rows.constructor.name };
      // Each array begins at a multiple of four bytes.
      chunks.push(data, new Uint8Array(-data.length & 3));
      size += data.length + (-data.length & 3);
      return place;
    };
    const fileOf = async (name: string): Promise<FileData> => {
      const data = Uint8Array.from(await readFile(`${folder}/${name}`));
      const entry = manifest.files[name];
      assert.ok(entry);
      return { name, data: data.buffer, ...entry };
    };
    const files: Record<string, unknown> = {};
    const { dynamic } = manifest;
    for (const entry of [...region.rings, ...(dynamic ? [dynamic] : [])]) {
      if (entry.geometry === null) continue;
      const buffers = entry.parts.filter((name) => name.endsWith('.bin') && !sent.has(name));
      for (const name of buffers) sent.add(name);
      const request = {
        kind: 'geometry' as const,
        glb: await fileOf(entry.geometry),
        parts: await Promise.all(buffers.map(fileOf)),
        known: entry.parts.filter((name) => name.endsWith('.webp')),
        center: region.center,
        growth: NO_GROWTH,
        isDynamic: entry === dynamic,
      };
      const { pieces, triangles } = await decodeGeometry(request, cachedBuffers);
      assert.deepEqual(triangles, { inFile: entry.triangles, drawn: entry.triangles });
      files[entry.geometry] = pieces.map((piece) => ({
        name: piece.name,
        material: piece.material,
        positions: put(piece.positions),
        normals: put(piece.normals),
        uvs: put(piece.uvs),
        colors: put(piece.colors),
        indices: put(piece.indices),
        placements: put(piece.placements),
      }));
    }
    await writeFile(`${folder}.geometry.json`, JSON.stringify(files));
    await writeFile(`${folder}.geometry.bin`, Buffer.concat(chunks));
  });
}
