/** Arrays and materials of the primitives of a GLB. */
import { entryAt, type Glb, type MaterialEntry, type Numbers, type Primitive } from './glb';
import type { Material, Piece, Sampler } from './messages';

/** Folder of the files of a bundle; URIs within files are relative to it. */
export const FOLDER = 'files/';

/** Arrays and material of a piece, without its placements. */
export type Arrays = Omit<Piece, 'name' | 'placements' | 'sharedKey'>;

export async function primitiveOf(glb: Glb, { attributes = {}, indices, material }: Primitive): Promise<Arrays> {
  const optional = (name: string, width: number): Promise<Numbers> | null =>
    attributes[name] === undefined ? null : glb.read(attributes[name], width);
  const [positions, normals, uvs, colors, corners] = await Promise.all([
    glb.read(attributes['POSITION'], 3),
    optional('NORMAL', 3),
    optional('TEXCOORD_0', 2),
    optional('COLOR_0', 4),
    glb.read(indices, 1),
  ]);
  const vertices = positions.length / 3;
  if (!(corners instanceof Uint16Array || corners instanceof Uint32Array) || corners.length % 3 !== 0)
    throw new Error('expected triangles as indices of 16 or 32 bits');
  if (corners.some((vertex) => vertex >= vertices)) throw new Error(`expected indices below ${vertices}`);
  const counts = [[normals, 3], [uvs, 2], [colors, 4]] as const;
  if (counts.some(([rows, width]) => rows && rows.length !== width * vertices))
    throw new Error(`expected attributes of ${vertices} vertices`);
  if (colors && !(colors instanceof Uint16Array)) throw new Error('expected colours of 16 bits');
  return {
    positions: checkFinite(positions, 'positions'),
    normals: normals && unitVectors(normals),
    uvs: uvs && checkFinite(uvs, 'texture coordinates'),
    colors,
    indices: corners,
    material: materialOf(glb, entryAt(glb.document.materials, material, 'material')),
  };
}

/** Key of a primitive's arrays: the files and positions of their bytes; `name` is the name of the GLB. */
export function arraysKey(glb: Glb, { attributes = {}, indices }: Primitive, name: string): string {
  const locations = Object.entries({ ...attributes, indices }).map(([attribute, accessor]) => {
    const place = accessor === undefined ? '' : glb.placeOf(accessor);
    return `${attribute}=${place.startsWith(':') ? name : ''}${place}`;
  });
  return locations.sort().join(' ');
}

function checkFinite(rows: Numbers, what: string): Float32Array {
  if (rows instanceof Float32Array && rows.every(Number.isFinite)) return rows;
  throw new Error(`expected ${what} that are finite numbers of 32 bits`);
}

/** Converts normals of bytes or float32 to unit vectors. */
function unitVectors(rows: Numbers): Float32Array {
  if (!(rows instanceof Int8Array)) checkFinite(rows, 'normals');
  const unit = new Float32Array(rows.length);
  for (let n = 0; n < rows.length; n += 3) {
    const [x, y, z] = [rows[n] as number, rows[n + 1] as number, rows[n + 2] as number];
    const size = Math.sqrt(x * x + y * y + z * z) || 1;
    unit[n] = x / size;
    unit[n + 1] = y / size;
    unit[n + 2] = z / size;
  }
  return unit;
}

function materialOf(glb: Glb, entry: MaterialEntry): Material {
  const { pbrMetallicRoughness: surface = {}, alphaMode, alphaCutoff = 0.5 } = entry;
  const [red, green, blue, alpha, ...more] = surface.baseColorFactor ?? [1, 1, 1, 1];
  const color = [Number(red), Number(green), Number(blue), Number(alpha)] as const;
  if (more.length > 0 || !color.every(Number.isFinite) || !Number.isFinite(alphaCutoff))
    throw new Error('expected materials of finite numbers');
  const emission = emissionOf(entry);
  return {
    color,
    image: surface.baseColorTexture ? imageOf(glb, surface.baseColorTexture.index) : null,
    imageSampler: samplerOf(glb, surface.baseColorTexture?.index),
    cutoff: alphaMode === 'MASK' ? alphaCutoff : null,
    emission,
    glow: emission && entry.emissiveTexture ? imageOf(glb, entry.emissiveTexture.index) : null,
    glowSampler: samplerOf(glb, entry.emissiveTexture?.index),
    isUnlit: entry.extensions?.KHR_materials_unlit !== undefined,
  };
}

/** Light that a material emits; null if it emits none or is unlit. */
function emissionOf({ emissiveFactor = [0, 0, 0], extensions }: MaterialEntry): Material['emission'] {
  const strength = extensions?.KHR_materials_emissive_strength?.emissiveStrength ?? 1;
  const [red, green, blue, ...more] = emissiveFactor;
  const emission = [Number(red) * strength, Number(green) * strength, Number(blue) * strength] as const;
  if (more.length > 0 || !emission.every((part) => Number.isFinite(part) && part >= 0))
    throw new Error('expected emission of three finite numbers of at least 0');
  return extensions?.KHR_materials_unlit === undefined && emission.some((part) => part > 0) ? emission : null;
}

function imageOf({ document }: Glb, texture: number): string {
  const entry = entryAt(document.textures, texture, 'texture');
  return pictureName(entryAt(document.images, entry.extensions?.EXT_texture_webp?.source ?? entry.source, 'image'));
}

const [REPEAT, MIRRORED, CLAMPED, NEAREST, LINEAR] = [10497, 33648, 33071, 9728, 9729] as const;
/** Sampler of textures without one. */
export const REPEATED: Sampler = [REPEAT, REPEAT, LINEAR];

/** Sampler of a texture; the default for no texture or no sampler. */
function samplerOf({ document }: Glb, texture: number | undefined): Sampler {
  const number = texture === undefined ? undefined : entryAt(document.textures, texture, 'texture').sampler;
  if (number === undefined) return REPEATED;
  const { wrapS = REPEAT, wrapT = REPEAT, magFilter = LINEAR } = entryAt(document.samplers, number, 'sampler');
  const isKnown = (code: number, ...known: readonly number[]): boolean => known.includes(code);
  if (![wrapS, wrapT].every((wrap) => isKnown(wrap, REPEAT, MIRRORED, CLAMPED)) || !isKnown(magFilter, NEAREST, LINEAR))
    throw new Error("expected samplers with glTF's codes");
  return [wrapS, wrapT, magFilter];
}

/** Name of a picture in the bundle. */
export function pictureName({ uri }: { readonly uri: string }): string {
  if (typeof uri !== 'string' || !/^[0-9a-f]{16}\.[a-z]+$/.test(uri))
    throw new Error('expected pictures that are files of the bundle');
  return FOLDER + uri;
}
