/** Reads a manifest: everything that the page uses is checked, so that damage is a sentence and nothing else. */
import { fileName, integer, list, number, object, optional, text } from './checks';
import { BundleError } from './error';
import type { Manifest, MapEntry, MovingEntry, Point, RegionEntry, RingEntry } from './manifest';

const FORMAT = 'nearfar.bundle';
const VERSION = 1;
const MOST_FACE = 4096;
/** Greatest coordinate, metres, and greatest radius. */
const FARTHEST = 1e12;

export function parseManifest(source: string): Manifest {
  let parsed: unknown;
  try {
    parsed = JSON.parse(source);
  } catch {
    throw new BundleError('manifest.json: expected JSON, got something else');
  }
  const all = object('manifest', parsed);
  if (all['format'] !== FORMAT) throw new BundleError(`manifest.json: expected the format ${FORMAT}, got another one`);
  const version = integer('version', all['version'], 1);
  if (version > VERSION) {
    throw new BundleError(`this bundle has version ${version}; this page reads ${VERSION}: it needs a newer nearfar`);
  }
  const [morph, growth, map] = (['morph', 'growth', 'map'] as const).map((name) => object(name, all[name]));
  const face = integer('map.face_size', map?.['face_size'], 1, MOST_FACE);
  const tile = integer('map.tile', map?.['tile'], 1, face);
  if (face % tile !== 0) throw new BundleError(`manifest.json: map.tile: expected a divisor of ${face}, got ${tile}`);
  if (text('morph.kind', morph?.['kind']) !== 'cylinder') {
    throw new BundleError('manifest.json: morph.kind: expected cylinder, got another one');
  }
  const tiles = 6 * (face / tile) ** 2;
  const files = object('files', all['files']);
  const manifest: Manifest = {
    version,
    morph: { kind: 'cylinder', near_share: number('morph.near_share', morph?.['near_share'], 1e-3, 0.999) },
    growth: {
      speed: number('growth.speed', growth?.['speed'], 1e-9),
      reach: number('growth.reach', growth?.['reach'], 1e-9),
      fade: number('growth.fade', growth?.['fade'], 0),
    },
    triangles: integer('triangles', all['triangles'], 0),
    bounds: list('bounds', all['bounds'], point, 2) as [Point, Point],
    map: { face_size: face, tile, across: integer('map.across', map?.['across'], 1, 16383) },
    regions: list('regions', all['regions'], (place, value) => region(place, value, tiles)),
    dynamic: optional('dynamic', all['dynamic'], moving),
    notes: list('notes', all['notes'], text),
    files: Object.fromEntries(Object.entries(files).map(([name, value]) => [fileName('files', name), described(name, value)])),
  };
  if (manifest.regions.length === 0) throw new BundleError('manifest.json: regions: expected at least one, got none');
  return manifest;
}

function described(place: string, value: unknown): { bytes: number; sha256: string } {
  const entry = object(place, value);
  return { bytes: integer(`${place}.bytes`, entry['bytes'], 0), sha256: text(`${place}.sha256`, entry['sha256']) };
}

function point(place: string, value: unknown): Point {
  return list(place, value, (name, item) => number(name, item, -FARTHEST, FARTHEST), 3) as unknown as Point;
}

function region(place: string, value: unknown, tiles: number): RegionEntry {
  const entry = object(place, value);
  const range = object(`${place}.range`, entry['range']);
  const rings = list(`${place}.rings`, entry['rings'], (name, item) => ring(name, item, tiles));
  if (rings.length < 2 || rings.some(({ radius }, n) => n > 0 && radius <= (rings[n - 1]?.radius ?? 0))) {
    throw new BundleError(`manifest.json: ${place}.rings: expected radii that ascend`);
  }
  return {
    center: point(`${place}.center`, entry['center']),
    fold_margin: number(`${place}.fold_margin`, entry['fold_margin'], 0),
    neighbours: list(`${place}.neighbours`, entry['neighbours'], (name, item) => integer(name, item, 0)),
    range: {
      least: number(`${place}.range.least`, range['least'], Number.MIN_VALUE),
      step: number(`${place}.range.step`, range['step'], Number.MIN_VALUE, 700 / 65535),
    },
    rings,
  };
}

function ring(place: string, value: unknown, tiles: number): RingEntry {
  const entry = object(place, value);
  return {
    radius: number(`${place}.radius`, entry['radius'], 0, FARTHEST),
    objects: integer(`${place}.objects`, entry['objects'], 0),
    triangles: integer(`${place}.triangles`, entry['triangles'], 0),
    geometry: optional(`${place}.geometry`, entry['geometry'], fileName),
    parts: list(`${place}.parts`, entry['parts'], fileName),
    map: mapOf(`${place}.map`, entry['map'], tiles),
  };
}

function mapOf(place: string, value: unknown, tiles: number): MapEntry {
  const entry = object(place, value);
  const names = (name: string, item: unknown): string | string[] =>
    Array.isArray(item) ? list(name, item, fileName, 6) : fileName(name, item);
  return {
    tiles: list(`${place}.tiles`, entry['tiles'] ?? [], (name, item) => integer(name, item, 0, tiles - 1)),
    color: optional(`${place}.color`, entry['color'], names),
    range: optional(`${place}.range`, entry['range'], names),
  };
}

function moving(place: string, value: unknown): NonNullable<Manifest['dynamic']> {
  const entry = object(place, value);
  return {
    geometry: fileName(`${place}.geometry`, entry['geometry']),
    parts: list(`${place}.parts`, entry['parts'], fileName),
    triangles: integer(`${place}.triangles`, entry['triangles'], 0),
    instances: list(`${place}.instances`, entry['instances'], movingEntry),
  };
}

function movingEntry(place: string, value: unknown): MovingEntry {
  const entry = object(place, value);
  const row = (name: string, item: unknown): number[] =>
    list(name, item, (column, cell) => number(column, cell, -FARTHEST, FARTHEST), 4);
  return {
    object: text(`${place}.object`, entry['object']),
    transform: optional(`${place}.transform`, entry['transform'], (name, item) => list(name, item, row, 4)),
  };
}
