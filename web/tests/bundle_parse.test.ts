import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BundleError } from '../src/bundle/error';
import { parseManifest } from '../src/bundle/parse';
import { asManifest, FACES, FILE, manifest, replaceAt } from './support/manifest';

const OTHER = 'files/fedcba9876543210.glb';
const REGION = ['regions', 0] as const;
const RING = [...REGION, 'rings', 1] as const;

test('a manifest is parsed', () => {
  const read = parseManifest(asManifest(manifest()));
  assert.equal(read.regions[0]?.rings[1]?.radius, 10);
  assert.deepEqual(read.regions[0]?.rings[1]?.map?.tiles, [0, 3]);
  assert.equal(read.files[FILE]?.bytes, 3);
});

test('the geometry of a reduced scene is cut at the radius of its only ring', () => {
  const withOneRing = replaceAt(manifest(), [...REGION, 'rings'], (manifest() as any).regions[0].rings.slice(0, 2));
  const read = parseManifest(asManifest({ ...(withOneRing as object), unit: 'triangle', morph: { kind: 'blend', near_share: 0 } }));
  assert.deepEqual([read.morph.kind, read.morph.near_share], ['blend', 0]);
  assert.equal(read.regions[0]?.cut, 10);
  assert.equal(parseManifest(asManifest(withOneRing)).regions[0]?.cut, Infinity);
});

test('errors name the damaged field', () => {
  const changes: [path: (string | number)[], value: unknown, message: RegExp][] = [
    [[], [], /manifest: expected an object/],
    [['format'], 'other', /format/],
    [['version'], 2, /^this bundle was written by a newer nearfar .*: update the page$/],
    [['version'], 0.5, /version/],
    [['morph'], null, /morph: expected an object/],
    [['morph', 'kind'], 'none', /morph\.kind: expected blend or cylinder/],
    [['unit'], 'face', /unit: expected object or triangle/],
    [['unit'], 'triangle', /rings: expected two with unit triangle/],
    [['morph', 'near_share'], 1, /near_share: expected a number from 0 to 0\.9+, got 1/],
    [['growth', 'speed'], '<img>', /growth\.speed/],
    [['growth', 'speed'], 0, /growth\.speed/],
    [['growth', 'fade'], Infinity, /growth\.fade/],
    [['triangles'], 1e300, /triangles/],
    [['bounds', 1], [0, 0], /bounds\[1\]: expected a list of 3/],
    [['map', 'tile'], 48, /tile/],
    [['map', 'face_size'], 1e9, /face_size/],
    [['map', 'across'], 256, /across/],
    [['regions'], [], /regions/],
    [['regions'], {}, /regions/],
    [[...REGION, 'center', 2], Infinity, /regions\[0\]\.center\[2\]/],
    [[...REGION, 'center', 2], null, /regions\[0\]\.center\[2\]/],
    [[...REGION, 'fold_margin'], -1, /fold_margin/],
    [[...REGION, 'neighbours'], [1], /neighbours/],
    [[...REGION, 'neighbours'], [0], /other regions/],
    [[...REGION, 'range', 'step'], 1, /finite/],
    [[...REGION, 'range', 'least'], 0, /range\.least/],
    [[...REGION, 'rings', 2], undefined, /rings\[2\]/],
    [[...REGION, 'rings', 0, 'radius'], 1, /ascend from 0/],
    [[...REGION, 'rings', 2, 'radius'], 10, /ascend/],
    [[...REGION, 'rings', 0, 'map', 'color'], FILE, /six pictures/],
    [[...RING, 'objects'], -1, /objects/],
    [[...RING, 'parts'], ['files/../../x.bin'], /parts\[0\]: expected the name of a file/],
    [[...RING, 'geometry'], 'https://evil.example/', /geometry: expected the name of a file/],
    [[...RING, 'geometry'], OTHER, /expected an entry for files\/fedcba9876543210\.glb, which is used/],
    [[...RING, 'map', 'tiles'], [3, 3], /ascend/],
    [[...RING, 'map', 'tiles'], [0, 6], /tiles\[1\]/],
    [[...RING, 'map', 'color'], null, /a picture if tiles change/],
    [[...RING, 'map', 'range'], FACES.slice(1), /list of 6/],
    [[...RING, 'map', 'range'], FILE, /six files of ranges/],
    [[...REGION, 'rings', 2, 'map', 'range'], FILE, /a range file if tiles change/],
    [['dynamic'], { geometry: FILE, parts: [], triangles: 1, instances: [{ object: 1 }] }, /instances\[0\]\.object/],
    [['dynamic'], { geometry: OTHER, parts: [], triangles: 1, instances: [] }, /which is used/],
    [['notes'], [1], /notes\[0\]/],
    [['files'], { '../../secret': { bytes: 1, sha256: '' } }, /file of the bundle/],
    [['files', FILE, 'bytes'], 2 ** 40, /bytes/],
    [['files', FILE, 'sha256'], 'A'.repeat(64), /SHA-256/],
  ];
  for (const [path, value, message] of changes) {
    assert.throws(() => parseManifest(asManifest(replaceAt(manifest(), path, value))), (error: Error) => {
      assert.ok(error instanceof BundleError, `${path}: ${error.stack}`);
      assert.match(error.message, message);
      assert.ok(error.message.length < 250);
      return true;
    });
  }
  assert.throws(() => parseManifest('{'), BundleError);
  assert.throws(() => parseManifest('['.repeat(1e6)), BundleError);
});

test('fields are not inherited from JavaScript objects', () => {
  const text = asManifest(manifest()).replace('"notes":[]', '"notes":[],"__proto__":{"polluted":1},"constructor":2');
  parseManifest(text);
  assert.equal(({} as { polluted?: number }).polluted, undefined);
  const inherited = asManifest(replaceAt(manifest(), ['morph'], undefined)).replace(
    '{"format"',
    '{"__proto__":{"morph":{"kind":"cylinder","near_share":0.7}},"format"',
  );
  assert.throws(() => parseManifest(inherited), /morph/);
});
