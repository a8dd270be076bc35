import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { BundleError } from '../src/bundle/error';
import { openContent, type Content } from '../src/opened';
import { strategyOf } from '../src/show/stage';
import { FATAL } from '../src/ui/messages';
import { manifest } from './support/manifest';

const SITE = { format: 'nearfar.on_demand', version: 1, title: 'a city', grid: 2, scene: 'files/0123456789abcdef.json' };
const SCENE = { format: 'nearfar.scene', version: 1, failed: 'disk.glb: the disk is gone' };

/** Opens the content of a server that has these documents. */
async function open(query: string, documents: Readonly<Record<string, unknown>>): Promise<Content> {
  const realFetch = globalThis.fetch;
  globalThis.fetch = (async (url: URL) => {
    const document = documents[url.pathname.slice(1)];
    return document === undefined ? new Response(null, { status: 404 }) : new Response(JSON.stringify(document));
  }) as typeof fetch;
  try {
    const parameters = new URLSearchParams(query);
    const strategy = strategyOf(parameters.get('strategy'));
    return await openContent(new URL('http://h/'), parameters, strategy, () => undefined, () => undefined);
  } finally {
    globalThis.fetch = realFetch;
  }
}

/** Returns the title of the page's error message. */
async function titleOfFailure(query: string, documents: Readonly<Record<string, unknown>>, message: RegExp): Promise<string> {
  let title = '';
  await assert.rejects(open(query, documents), (error: BundleError) => {
    assert.match(error.message, message);
    title = FATAL[error.kind].title;
    return true;
  });
  return title;
}

test('a bundle begins at its first centre, with the rings that the address requests', async () => {
  const { start, world, isStatic, centers } = await open('rings=1', { 'manifest.json': manifest() });
  assert.deepEqual([start, isStatic, centers], [{ position: [0, 1.7, 0], yaw: 0, pitch: 0 }, true, [[0, 1.7, 0]]]);
  const { entry } = await world.open(0, new AbortController().signal);
  assert.deepEqual(entry.rings.map(({ radius }) => radius), [0, 10]);
});

test('errors have a title by kind', async () => {
  const site = { 'manifest.json': SITE, [SITE.scene]: SCENE };
  assert.match(await titleOfFailure('strategy=vis1', site, /^strategy: expected clovr or clovrd/), /invalid parameter/);
  assert.match(await titleOfFailure('', site, /disk\.glb: the disk is gone/), /cannot load the scene/);
  const newer = { 'manifest.json': { ...manifest(), version: 2 } };
  assert.match(await titleOfFailure('', newer, /newer nearfar/), /newer nearfar/);
  assert.match(await titleOfFailure('', {}, /answers 404/), /cannot be reached/);
  const bundle = { 'manifest.json': manifest() };
  assert.match(await titleOfFailure('rings=two', bundle, /number of a ring/), /invalid parameter/);
  assert.match(await titleOfFailure('strategy=vis1', bundle, /by_footprint=True/), /invalid parameter/);
});
