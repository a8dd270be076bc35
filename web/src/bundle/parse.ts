/** Parses a manifest and checks everything that the page uses, so that damage only causes an error message. */
import { choice, type Fields, fileName, hash, integer, list, number, object, optional, text } from './checks';
import { filesOfGeometry, filesOfMap, filesOfRing } from './contents';
import { BundleError } from './error';
import type {
  FileEntry,
  FootprintEntry,
  GroupEntry,
  Manifest,
  MapEntry,
  MapLayout,
  MovingEntry,
  Point,
  RegionEntry,
  RingEntry,
} from './manifest';

const FORMAT = 'nearfar.bundle';
const VERSION = 1;
const MAX_FACE_SIZE = 4096;
/** Greatest width and height of a WebP picture. */
const MAX_PIXELS = 16383;
const [FACES, MAX_REGIONS, MAX_RINGS] = [6, 1000, 1000] as const;
/** Greatest size of a file in bytes, limited by browsers' arrays. */
const MAX_BYTES = 2 ** 31 - 1;
/** Code of the greatest range, and greatest natural logarithm of a range. */
const [LAST_CODE, MAX_EXPONENT] = [65534, 600] as const;
/** Greatest coordinate, and greatest radius, metres. */
const MAX_COORDINATE = 1e12;

/** Reads the entry of a ring. */
type RingReader = (place: string, value: unknown, order: number) => RingEntry;

export function parseManifest(source: string): Manifest {
  return readManifest(parseJson('manifest.json', source));
}

export function parseJson(name: string, source: string): unknown {
  try {
    return JSON.parse(source) as unknown;
  } catch {
    throw new BundleError(`${name}: expected JSON, got something else`);
  }
}

/** Reads a manifest; `readRingOf` reads its rings, which are incomplete in the outline of a region. */
export function readManifest(parsed: unknown, readRingOf: typeof readRing = readRing): Manifest {
  const all = object('manifest', parsed);
  if (all['format'] !== FORMAT) throw new BundleError(`manifest.json: expected the format ${FORMAT}, got another one`);
  const version = integer('version', all['version'], 1);
  if (version > VERSION) {
    const versions = `it has version ${version}, this page reads ${VERSION}`;
    throw new BundleError(`this bundle was written by a newer nearfar (${versions}): update the page`, 'newer');
  }
  const [morph, growth] = [object('morph', all['morph']), object('growth', all['growth'])];
  const map = object('map', all['map']);
  const faceSize = integer('map.face_size', map['face_size'], 1, MAX_FACE_SIZE);
  const tile = integer('map.tile', map['tile'], 1, faceSize);
  if (faceSize % tile !== 0) throw new BundleError(`manifest.json: map.tile: expected a divisor of ${faceSize}, got ${tile}`);
  const kind = choice('morph.kind', morph['kind'], ['blend', 'cylinder'] as const);
  const unit = choice('unit', all['unit'] ?? 'object', ['object', 'triangle'] as const);
  const across = integer('map.across', map['across'], 1, Math.floor(MAX_PIXELS / tile));
  const tiles = tilesOf({ face_size: faceSize, tile, across });
  const files = object('files', all['files']);
  const entries = list('regions', all['regions'], object);
  if (entries.length === 0 || entries.length > MAX_REGIONS)
    throw new BundleError(`manifest.json: regions: expected 1 to ${MAX_REGIONS}, got ${entries.length}`);
  const manifest: Manifest = {
    version,
    morph: { kind, near_share: number('morph.near_share', morph['near_share'], 0, 1 - 1e-9) },
    growth: {
      speed: number('growth.speed', growth['speed'], 1e-9),
      reach: number('growth.reach', growth['reach'], 1e-9),
      fade: number('growth.fade', growth['fade'], 0),
    },
    triangles: integer('triangles', all['triangles'], 0),
    bounds: list('bounds', all['bounds'], point, 2) as [Point, Point],
    map: { face_size: faceSize, tile, across },
    regions: entries.map((entry, number) => {
      const place = `regions[${number}]`;
      const ringOf: RingReader = (name, item, order) => readRingOf(name, item, order, tiles);
      return cutBy(unit, place, readRegion(place, entry, number, entries.length, ringOf));
    }),
    dynamic: optional('dynamic', all['dynamic'], readDynamic),
    notes: list('notes', all['notes'], text),
    files: readFiles(files),
  };
  checkListed(manifest);
  return manifest;
}

export function readFiles(files: Fields): Record<string, FileEntry> {
  const entries = Object.entries(files).map(([name, value]) => {
    const [key, entry] = [fileName('files', name), object(name, value)];
    const bytes = integer(`${name}.bytes`, entry['bytes'], 0, MAX_BYTES);
    return [key, { bytes, sha256: hash(`${name}.sha256`, entry['sha256']) }] as const;
  });
  return Object.fromEntries(entries);
}

export function tilesOf({ face_size: faceSize, tile }: MapLayout): number {
  return FACES * (faceSize / tile) ** 2;
}

/** Checks that all files of rings, maps and dynamic objects have a size and a hash. */
function checkListed({ regions, dynamic, files }: Manifest): void {
  const names = [
    ...regions.flatMap(({ rings }) => rings.flatMap(filesOfRing)),
    ...regions.flatMap(({ by_footprint: footprint }) =>
      footprint ? [...footprint.portions.flatMap(filesOfGeometry), ...filesOfMap(footprint.map)] : [],
    ),
    ...(dynamic ? filesOfGeometry(dynamic) : []),
  ];
  for (const name of names) {
    if (!Object.hasOwn(files, name))
      throw new BundleError(`manifest.json: files: expected an entry for ${name}, which is used`);
  }
}

export function point(place: string, value: unknown): Point {
  return list(place, value, (name, item) => number(name, item, -MAX_COORDINATE, MAX_COORDINATE), 3) as unknown as Point;
}

function readRegion(place: string, value: Fields, regionNumber: number, count: number, ringOf: RingReader): RegionEntry {
  const range = object(`${place}.range`, value['range']);
  const rings = list(`${place}.rings`, value['rings'], ringOf);
  const radii = rings.map(({ radius }) => radius);
  const isAscending = radii[0] === 0 && radii.every((radius, number) => number === 0 || radius > (radii[number - 1] ?? 0));
  if (rings.length < 2 || rings.length > MAX_RINGS || !isAscending)
    throw new BundleError(`manifest.json: ${place}.rings: expected radii that ascend from 0`);
  const readNumber = (name: string, item: unknown): number => integer(name, item, 0, count - 1);
  const neighbours = list(`${place}.neighbours`, value['neighbours'], readNumber);
  if (neighbours.includes(regionNumber)) throw new BundleError(`manifest.json: ${place}.neighbours: expected other regions`);
  const least = number(`${place}.range.least`, range['least'], Number.MIN_VALUE);
  const step = number(`${place}.range.step`, range['step'], Number.MIN_VALUE);
  if (!(Math.abs(Math.log(least)) + LAST_CODE * step <= MAX_EXPONENT))
    throw new BundleError(`manifest.json: ${place}.range: expected ranges that are finite`);
  return {
    center: point(`${place}.center`, value['center']),
    fold_margin: number(`${place}.fold_margin`, value['fold_margin'], 0),
    neighbours,
    range: { least, step },
    rings,
    cut: Infinity,
    by_footprint: optional(`${place}.by_footprint`, value['by_footprint'], readFootprints),
  };
}

/** If the unit is "triangle", the only ring's geometry is cut at its radius in every pixel; objects are not cut. */
function cutBy(unit: 'object' | 'triangle', place: string, entry: RegionEntry): RegionEntry {
  if (unit === 'object') return entry;
  if (entry.rings.length !== 2) throw new BundleError(`manifest.json: ${place}.rings: expected two with unit triangle`);
  return { ...entry, cut: entry.rings[1]?.radius ?? Infinity };
}

/** Reads the entry of a ring; `tiles` is the number of tiles of a map. */
export function readRing(place: string, value: unknown, order: number, tiles: number): RingEntry {
  const entry = object(place, value);
  return {
    ...readGroup(place, entry),
    radius: number(`${place}.radius`, entry['radius'], 0, MAX_COORDINATE),
    map: readMap(`${place}.map`, entry['map'], order, tiles),
  };
}

/** A ring without files yet. */
export function outlinedRing(place: string, value: unknown): RingEntry {
  const { objects, triangles } = readGroup(place, value);
  const radius = number(`${place}.radius`, object(place, value)['radius'], 0, MAX_COORDINATE);
  return { objects, triangles, geometry: null, parts: [], radius, map: null };
}

function readGroup(place: string, value: unknown): GroupEntry {
  const entry = object(place, value);
  return {
    objects: integer(`${place}.objects`, entry['objects'], 0),
    triangles: integer(`${place}.triangles`, entry['triangles'], 0),
    geometry: optional(`${place}.geometry`, entry['geometry'], fileName),
    parts: list(`${place}.parts`, entry['parts'], fileName),
  };
}

function readFootprints(place: string, value: unknown): FootprintEntry {
  const entry = object(place, value);
  const map = object(`${place}.map`, entry['map']);
  const faces = (name: string): string[] => list(`${place}.map.${name}`, map[name], fileName, FACES);
  return {
    portions: list(`${place}.portions`, entry['portions'], readGroup),
    map: { tiles: [], color: faces('color'), range: faces('range') },
  };
}

function readMap(place: string, value: unknown, order: number, tiles: number): MapEntry {
  const entry = object(place, value);
  const names = (name: string, item: unknown): string | string[] =>
    Array.isArray(item) ? list(name, item, fileName, FACES) : fileName(name, item);
  const map = {
    tiles: list(`${place}.tiles`, entry['tiles'] ?? [], (name, item) => integer(name, item, 0, tiles - 1)),
    color: optional(`${place}.color`, entry['color'], names),
    range: optional(`${place}.range`, entry['range'], names),
  };
  const wrong = (expected: string): BundleError => new BundleError(`manifest.json: ${place}: expected ${expected}`);
  if (order === 0) {
    if (!Array.isArray(map.color)) throw wrong('six pictures for ring 0');
    return map;
  }
  if (map.tiles.some((tile, number) => number > 0 && tile <= (map.tiles[number - 1] ?? 0)))
    throw wrong('numbers of tiles that ascend');
  const changesTiles = map.tiles.length > 0;
  if (changesTiles !== (typeof map.color === 'string')) throw wrong('a picture if tiles change, and none otherwise');
  if (order === 1 && !Array.isArray(map.range)) throw wrong('six files of ranges for ring 1');
  if (order > 1 && changesTiles !== (typeof map.range === 'string')) throw wrong('a range file if tiles change, and none otherwise');
  return map;
}

function readDynamic(place: string, value: unknown): NonNullable<Manifest['dynamic']> {
  const entry = object(place, value);
  return {
    geometry: fileName(`${place}.geometry`, entry['geometry']),
    parts: list(`${place}.parts`, entry['parts'], fileName),
    triangles: integer(`${place}.triangles`, entry['triangles'], 0),
    instances: list(`${place}.instances`, entry['instances'], readInstance),
  };
}

function readInstance(place: string, value: unknown): MovingEntry {
  const entry = object(place, value);
  const row = (name: string, item: unknown): number[] =>
    list(name, item, (column, cell) => number(column, cell, -MAX_COORDINATE, MAX_COORDINATE), 4);
  return {
    object: text(`${place}.object`, entry['object']),
    transform: optional(`${place}.transform`, entry['transform'], (name, item) => list(name, item, row, 4)),
  };
}
