import assert from 'node:assert/strict';
import { test } from 'node:test';
import { filesOfRing } from '../src/bundle/contents';
import { parseManifest } from '../src/bundle/parse';
import { createStage, NOTHING_NEAR, strategyOf } from '../src/show/stage';
import { replaceAt, asManifest, FACES, FILE, manifest } from './support/manifest';

const GLB = 'files/0123456789abcdef.glb';
const PORTION = { objects: 2, triangles: 7, geometry: GLB, parts: [] };
const PATH = ['regions', 0, 'by_footprint'] as const;
const BY_FOOTPRINT = { portions: [PORTION, { ...PORTION, geometry: null }], map: { color: FACES, range: FACES } };

test('strategies with rings keep the bundle as it is', () => {
  const read = parseManifest(asManifest(manifest()));
  for (const name of [null, 'clovr', 'clovrd']) assert.equal(strategyOf(name).arrange(read), read);
});

test('strategies by footprint load the portions first, and the whole map of the last ring last', () => {
  const read = parseManifest(asManifest(replaceAt(manifest({ [GLB]: 5 }), PATH, BY_FOOTPRINT)));
  for (const name of ['vis0', 'vis1']) {
    const rings = strategyOf(name).arrange(read).regions[0]?.rings ?? [];
    assert.deepEqual(rings.map(filesOfRing), [[], [GLB], [], [...FACES, ...FACES]]);
    assert.deepEqual(rings.map(({ radius }) => radius), [0, 22, 22, 22]);
    assert.deepEqual(rings.map(({ map }) => map !== null), [false, false, false, true]);
  }
});

test('a bundle without portions by footprint, and an unknown strategy, are errors', () => {
  const read = parseManifest(asManifest(manifest()));
  assert.throws(() => strategyOf('vis1').arrange(read), /regions\[0\].by_footprint: .* by_footprint=True/);
  for (const name of ['vis2', '', 'toString', '__proto__']) {
    assert.throws(() => strategyOf(name), /strategy: expected clovr, clovrd, vis0, vis1, got/);
  }
});

test('errors name the wrong entry of the portions by footprint', () => {
  const damaged: [unknown, RegExp][] = [
    [{ ...BY_FOOTPRINT, portions: 3 }, /by_footprint.portions: expected a list/],
    [{ ...BY_FOOTPRINT, portions: [{ ...PORTION, objects: -1 }] }, /portions\[0\].objects/],
    [{ ...BY_FOOTPRINT, map: { color: FILE, range: FACES } }, /by_footprint.map.color: expected a list of 6/],
    [{ ...BY_FOOTPRINT, map: { color: FACES } }, /by_footprint.map.range/],
    [BY_FOOTPRINT, /files: expected an entry for files\/0123456789abcdef.glb, which is used/],
  ];
  for (const [value, message] of damaged) {
    const sizes = value === BY_FOOTPRINT ? {} : { [GLB]: 5 };
    assert.throws(() => parseManifest(asManifest(replaceAt(manifest(sizes), PATH, value))), message);
  }
});

test('vis0 shows nothing until everything is loaded, vis1 shows each portion at once, fully morphed', () => {
  const settings = { radii: [22, 22, 22], speed: 0.7, reach: 1, nearShare: 0.7, fade: 0.5 };
  const pictures = ['vis0', 'vis1'].map((name) => {
    const stage = createStage(settings, strategyOf(name));
    stage.enter(NOTHING_NEAR);
    return [0, 1, 2, 3].map((ring) => {
      stage.arrive(ring);
      const shown = stage.advance(1 / 72);
      assert.equal(shown?.fading ?? null, null);
      return shown && [shown.ring, shown.grown.radius, shown.grown.strength];
    });
  });
  assert.deepEqual(pictures, [
    [null, null, null, [3, 22, 1]],
    [[0, 0, 0], [1, 22, 1], [2, 22, 1], [3, 22, 1]],
  ]);
});
