import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BundleError } from '../src/bundle/error';
import { parseManifest } from '../src/bundle/parse';

const file = 'files/0123456789abcdef.webp';
const faces = Array.from({ length: 6 }, () => file);

function manifest(): Record<string, unknown> {
  const ring = { objects: 0, triangles: 0, geometry: null, parts: [] };
  return {
    format: 'nearfar.bundle',
    version: 1,
    morph: { kind: 'cylinder', near_share: 0.7 },
    growth: { speed: 0.7, reach: 1, fade: 0.5 },
    triangles: 12,
    bounds: [[0, 0, 0], [1, 1, 1]],
    map: { face_size: 64, tile: 64, across: 16 },
    regions: [
      {
        center: [0, 1.7, 0],
        fold_margin: 7,
        neighbours: [],
        range: { least: 0.5, step: 0.001 },
        rings: [
          { ...ring, radius: 0, map: { color: faces } },
          { ...ring, radius: 10, map: { color: file, tiles: [0], range: faces } },
        ],
      },
    ],
    dynamic: null,
    notes: [],
    files: { [file]: { bytes: 3, sha256: 'a'.repeat(64) } },
  };
}

test('a manifest is read', () => {
  const read = parseManifest(JSON.stringify(manifest()));
  assert.equal(read.regions[0]?.rings[1]?.radius, 10);
  assert.equal(read.files[file]?.bytes, 3);
});

test('damage is named', () => {
  const changes: [string, unknown, RegExp][] = [
    ['format', 'other', /format/],
    ['version', 2, /newer nearfar/],
    ['map', { face_size: 64, tile: 48, across: 1 }, /tile/],
    ['map', { face_size: 1e9, tile: 1, across: 1 }, /face_size/],
    ['regions', [], /regions/],
    ['regions', {}, /regions/],
    ['growth', { speed: '<img>', reach: 1, fade: 0 }, /growth.speed/],
    ['files', { '../../secret': { bytes: 1, sha256: '' } }, /file of the bundle/],
    ['notes', [1], /notes\[0\]/],
  ];
  for (const [name, value, message] of changes) {
    assert.throws(() => parseManifest(JSON.stringify({ ...manifest(), [name]: value })), (error: Error) => {
      assert.ok(error instanceof BundleError, `${name}: ${error}`);
      assert.match(error.message, message);
      return true;
    });
  }
  assert.throws(() => parseManifest('{'), BundleError);
});
