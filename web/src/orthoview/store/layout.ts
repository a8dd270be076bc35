/** Layout of a tree of orthoviews: its cells, directions and format, from the attributes of its store. */
import { damagedError } from './error';

export type Triple = readonly [number, number, number];

/** Number of lowest bits of a depth: connections with the right, lower, lower right and lower left neighbour. */
export const CONNECTION_BITS = 4;

/** Folder of a store for files that do not belong to Zarr. */
export const FOLDER = 'nearfar';

/** Direction that stands for the geometry of a leaf. */
export const GEOMETRY = -1;

/** Parsed JSON object. */
export type Fields = Readonly<Record<string, unknown>>;

export interface CellKey {
  readonly level: number;
  readonly place: Triple;
}

/** View of a cell or, with the direction `GEOMETRY`, the geometry of a leaf. */
export interface ViewKey extends CellKey {
  readonly direction: number;
}

export interface Layout {
  /** Least corner of leaf (0, 0, 0), metres. */
  readonly origin: Triple;
  /** Side of a leaf, metres. */
  readonly cell: number;
  /** Number of leaves along each axis. */
  readonly counts: Triple;
  /** Number of levels: level 0 has the leaves, the last one a single cell. */
  readonly levels: number;
  readonly directions: readonly Triple[];
  /** Names of the directions, such as `px_py`. */
  readonly names: readonly string[];
  /** Width and height of a view, pixels. */
  readonly size: number;
  readonly depthBits: number;
  /** Bits of both components of a normal. */
  readonly normalBits: number;
  /** Levels of a subtree. */
  readonly subtree: number;
  readonly color: 'zstd' | 'webp';
  readonly layers: number;
  /** Whether the store has the geometry of its leaves. */
  readonly geometry: boolean;
}

/** Parses the layout in a group's attributes; throws an error if the page cannot draw it. */
export function parseLayout(described: unknown): Layout {
  const from = fields(described, 'layout');
  const isSign = (value: number): boolean => isWhole(value, -1, 1);
  const layout: Layout = {
    origin: triple(from['origin'], 'origin', Number.isFinite),
    cell: number(from['cell'], 'cell', (value) => Number.isFinite(value) && value > 0),
    counts: triple(from['counts'], 'counts', (value) => isWhole(value, 1, 2 ** 31)),
    levels: number(from['levels'], 'levels', (value) => isWhole(value, 1, 32)),
    directions: list(from['directions'], 'directions').map((axes) => triple(axes, 'directions', isSign)),
    names: list(from['names'], 'names').map(String),
    size: number(from['size'], 'size', (value) => isWhole(value, 4, 4096) && value % 4 === 0),
    depthBits: number(from['depth_bits'], 'depth_bits', (value) => isWhole(value, 8, 16)),
    normalBits: number(from['normal_bits'], 'normal_bits', (value) => value === 16 || value === 24),
    subtree: number(from['subtree'], 'subtree', (value) => isWhole(value, 1, 8)),
    color: from['color'] === 'webp' ? 'webp' : 'zstd',
    layers: number(from['layers'], 'layers', (value) => isWhole(value, 1, 2)),
    geometry: from['geometry'] === true,
  };
  const { counts, levels, directions, names } = layout;
  const areDirections = isWhole(directions.length, 1, 26) && directions.every((axes) => axes.some((n) => n !== 0));
  const areNames = names.length === directions.length && names.every((name) => /^[a-z_]+$/.test(name));
  const isTree = areDirections && areNames && 2 ** (levels - 1) >= Math.max(...counts);
  if (!isTree) throw damagedError('zarr.json', 'its layout is inconsistent');
  return layout;
}

/** Number of depth steps of a view, a multiple of 6. */
export function stepsOf({ depthBits }: Layout): number {
  return Math.floor((2 ** depthBits - 1) / 6) * 6;
}

/** Side of the cells of a level, metres. */
export function sideAt({ cell }: Layout, level: number): number {
  return cell * 2 ** level;
}

/** Least corner of a cell, metres. */
export function cornerOf(layout: Layout, level: number, [x, y, z]: Triple): Triple {
  const [side, [a, b, c]] = [sideAt(layout, level), layout.origin];
  return [a + x * side, b + y * side, c + z * side];
}

/** Number of cells along each axis of a shard. */
export function shardSide({ subtree }: Layout, level: number): number {
  return 2 ** (subtree - (level % subtree));
}

/** Tier and place of the subtree that contains a cell; the cell's shards have the same place. */
export function subtreeOf(layout: Layout, level: number, [x, y, z]: Triple): { tier: number; place: Triple } {
  const side = shardSide(layout, level);
  const place: Triple = [Math.floor(x / side), Math.floor(y / side), Math.floor(z / side)];
  return { tier: Math.floor(level / layout.subtree), place };
}

/** Number of cells in each level of a subtree, lowest level first. */
export function cellCounts(layout: Layout, tier: number): number[] {
  const lowest = tier * layout.subtree;
  const count = Math.min(layout.subtree, layout.levels - lowest);
  return Array.from({ length: count }, (_, level) => shardSide(layout, lowest + level) ** 3);
}

/** Name of a cell. */
export function nameOf(level: number, [x, y, z]: Triple): string {
  return `${level}/${x}/${y}/${z}`;
}

export function viewName({ level, place, direction }: ViewKey): string {
  return `${nameOf(level, place)}/${direction}`;
}

/** Folder of a generation in the store, with a slash at its end; empty for the first generation. */
export function generationFolder(generation: number): string {
  return generation === 0 ? '' : `${FOLDER}/generations/${generation}/`;
}

/** Path of an array, with the folder of its generation. */
export function arrayOf({ names }: Layout, { level, direction }: ViewKey, generation: number): string {
  return `${generationFolder(generation)}${level}/${names[direction]}`;
}

/** Path in the store of the shard that has the chunk of a view. */
export function shardPath(layout: Layout, view: ViewKey, generation: number): string {
  const { place } = subtreeOf(layout, view.level, view.place);
  return `${arrayOf(layout, view, generation)}/c/${place.join('/')}/0`;
}

/** Number of a cell in its shard: x, y, z, with z fastest. */
export function cellInShard(layout: Layout, level: number, place: Triple): number {
  const side = shardSide(layout, level);
  const [x, y, z] = place.map((number) => number % side) as [number, number, number];
  return (x * side + y) * side + z;
}

/** Paths of a leaf's static and moving geometry in the folder of a generation. */
export function geometryPaths({ levels }: Layout, place: Triple): readonly string[] {
  return ['content', 'moving'].map((folder) => `geometry/${folder}/${levels - 1}/${place.join('/')}.glb`);
}

export function fields(value: unknown, file: string): Fields {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw damagedError(file, 'expected an object');
  return value as Fields;
}

function list(value: unknown, name: string): readonly unknown[] {
  if (!Array.isArray(value)) throw damagedError('zarr.json', `layout.${name} is not a list`);
  return value;
}

function number(value: unknown, name: string, isValid: (value: number) => boolean): number {
  if (typeof value !== 'number' || !isValid(value))
    throw damagedError('zarr.json', `layout.${name} cannot be ${JSON.stringify(value)}`);
  return value;
}

function triple(value: unknown, name: string, isValid: (value: number) => boolean): Triple {
  const [x, y, z, ...rest] = list(value, name);
  if (rest.length > 0) throw damagedError('zarr.json', `layout.${name} has more than three numbers`);
  return [number(x, name, isValid), number(y, name, isValid), number(z, name, isValid)];
}

function isWhole(value: number, least: number, greatest: number): boolean {
  return Number.isInteger(value) && value >= least && value <= greatest;
}
