/** Parses a manifest and checks everything that the page uses, so that damaged ones cause only an error message. */
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
/** Greatest size of a file, bytes: the limit of arrays in browsers. */
const MAX_BYTES = 2 ** 31 - 1;
/** Code of the greatest range; greatest absolute value of a range's natural logarithm. */
const [LAST_CODE, MAX_EXPONENT] = [65534, 600] as const;
/** Greatest coordinate, and greatest radius, metres. */
const MAX_COORDINATE = 1e12;

/** Reads the entry of a ring. */
type RingReader = (path: string, value: unknown, order: number) => RingEntry;

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

/** Reads a manifest; `readRingOf` reads each of its rings, which have no files in the outline of a region. */
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
      const path = `regions[${number}]`;
      const ringOf: RingReader = (name, item, order) => readRingOf(name, item, order, tiles);
      return withCut(unit, path, readRegion(path, entry, number, entries.length, ringOf));
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

export function point(path: string, value: unknown): Point {
  return list(path, value, (name, item) => number(name, item, -MAX_COORDINATE, MAX_COORDINATE), 3) as unknown as Point;
}

function readRegion(path: string, value: Fields, regionNumber: number, count: number, ringOf: RingReader): RegionEntry {
  const range = object(`${path}.range`, value['range']);
  const rings = list(`${path}.rings`, value['rings'], ringOf);
  const radii = rings.map(({ radius }) => radius);
  const isAscending = radii[0] === 0 && radii.every((radius, number) => number === 0 || radius > (radii[number - 1] ?? 0));
  if (rings.length < 2 || rings.length > MAX_RINGS || !isAscending)
    throw new BundleError(`manifest.json: ${path}.rings: expected radii that ascend from 0`);
  const readNumber = (name: string, item: unknown): number => integer(name, item, 0, count - 1);
  const neighbours = list(`${path}.neighbours`, value['neighbours'], readNumber);
  if (neighbours.includes(regionNumber))
    throw new BundleError(`manifest.json: ${path}.neighbours: expected other regions`);
  const least = number(`${path}.range.least`, range['least'], Number.MIN_VALUE);
  const step = number(`${path}.range.step`, range['step'], Number.MIN_VALUE);
  if (!(Math.abs(Math.log(least)) + LAST_CODE * step <= MAX_EXPONENT))
    throw new BundleError(`manifest.json: ${path}.range: expected ranges that are finite`);
  return {
    center: point(`${path}.center`, value['center']),
    fold_margin: number(`${path}.fold_margin`, value['fold_margin'], 0),
    neighbours,
    range: { least, step },
    rings,
    cut: Infinity,
    by_footprint: optional(`${path}.by_footprint`, value['by_footprint'], readFootprints),
  };
}

/** Sets the radius at which geometry is cut in each pixel: the only ring's for unit "triangle", none for "object". */
function withCut(unit: 'object' | 'triangle', path: string, entry: RegionEntry): RegionEntry {
  if (unit === 'object') return entry;
  if (entry.rings.length !== 2) throw new BundleError(`manifest.json: ${path}.rings: expected two with unit triangle`);
  return { ...entry, cut: entry.rings[1]?.radius ?? Infinity };
}

/** Reads the entry of a ring; `tiles` is the number of tiles in a map. */
export function readRing(path: string, value: unknown, order: number, tiles: number): RingEntry {
  const entry = object(path, value);
  return {
    ...readGroup(path, entry),
    radius: number(`${path}.radius`, entry['radius'], 0, MAX_COORDINATE),
    map: readMap(`${path}.map`, entry['map'], order, tiles),
  };
}

/** Reads the entry of a ring in an outline, which has no files yet. */
export function readRingOutline(path: string, value: unknown): RingEntry {
  const { objects, triangles } = readGroup(path, value);
  const radius = number(`${path}.radius`, object(path, value)['radius'], 0, MAX_COORDINATE);
  return { objects, triangles, geometry: null, parts: [], radius, map: null };
}

function readGroup(path: string, value: unknown): GroupEntry {
  const entry = object(path, value);
  return {
    objects: integer(`${path}.objects`, entry['objects'], 0),
    triangles: integer(`${path}.triangles`, entry['triangles'], 0),
    geometry: optional(`${path}.geometry`, entry['geometry'], fileName),
    parts: list(`${path}.parts`, entry['parts'], fileName),
  };
}

function readFootprints(path: string, value: unknown): FootprintEntry {
  const entry = object(path, value);
  const map = object(`${path}.map`, entry['map']);
  const faces = (name: string): string[] => list(`${path}.map.${name}`, map[name], fileName, FACES);
  return {
    portions: list(`${path}.portions`, entry['portions'], readGroup),
    map: { tiles: [], color: faces('color'), range: faces('range') },
  };
}

function readMap(path: string, value: unknown, order: number, tiles: number): MapEntry {
  const entry = object(path, value);
  const names = (name: string, item: unknown): string | string[] =>
    Array.isArray(item) ? list(name, item, fileName, FACES) : fileName(name, item);
  const map = {
    tiles: list(`${path}.tiles`, entry['tiles'] ?? [], (name, item) => integer(name, item, 0, tiles - 1)),
    color: optional(`${path}.color`, entry['color'], names),
    range: optional(`${path}.range`, entry['range'], names),
  };
  const errorOf = (expected: string): BundleError => new BundleError(`manifest.json: ${path}: expected ${expected}`);
  if (order === 0) {
    if (!Array.isArray(map.color)) throw errorOf('six pictures for ring 0');
    return map;
  }
  if (map.tiles.some((tile, number) => number > 0 && tile <= (map.tiles[number - 1] ?? 0)))
    throw errorOf('numbers of tiles that ascend');
  const changesTiles = map.tiles.length > 0;
  if (changesTiles !== (typeof map.color === 'string')) throw errorOf('a picture if tiles change, and none otherwise');
  if (order === 1 && !Array.isArray(map.range)) throw errorOf('six files of ranges for ring 1');
  if (order > 1 && changesTiles !== (typeof map.range === 'string'))
    throw errorOf('a range file if tiles change, and none otherwise');
  return map;
}

function readDynamic(path: string, value: unknown): NonNullable<Manifest['dynamic']> {
  const entry = object(path, value);
  return {
    geometry: fileName(`${path}.geometry`, entry['geometry']),
    parts: list(`${path}.parts`, entry['parts'], fileName),
    triangles: integer(`${path}.triangles`, entry['triangles'], 0),
    instances: list(`${path}.instances`, entry['instances'], readInstance),
  };
}

function readInstance(path: string, value: unknown): MovingEntry {
  const entry = object(path, value);
  const row = (name: string, item: unknown): number[] =>
    list(name, item, (column, cell) => number(column, cell, -MAX_COORDINATE, MAX_COORDINATE), 4);
  return {
    object: text(`${path}.object`, entry['object']),
    transform: optional(`${path}.transform`, entry['transform'], (name, item) => list(name, item, row, 4)),
  };
}
