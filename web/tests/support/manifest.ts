/** A manifest for tests, which alter it. */

export const FILE = 'files/0123456789abcdef.webp';
export const FACES = Array.from({ length: 6 }, () => FILE);

/** Manifest of one region with three rings; `sizes` adds files. */
export function manifest(sizes: Readonly<Record<string, number>> = {}): Record<string, unknown> {
  const sha256 = 'a'.repeat(64);
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
          { ...ring, radius: 0, map: { color: FACES } },
          { ...ring, radius: 10, map: { color: FILE, tiles: [0, 3], range: FACES } },
          { ...ring, radius: 22, map: { color: null, tiles: [], range: null } },
        ],
      },
    ],
    dynamic: null,
    notes: [],
    files: {
      [FILE]: { bytes: 3, sha256 },
      ...Object.fromEntries(Object.entries(sizes).map(([name, bytes]) => [name, { bytes, sha256 }])),
    },
  };
}

/** Manifest as text; Infinity becomes a number that is too large for a double. */
export function asManifest(value: unknown): string {
  const text = JSON.stringify(value, (_, item: unknown) => (item === Infinity ? 'HUGE' : item));
  return text.replaceAll('"HUGE"', '1e999');
}

/** Copies a value and replaces the value at a path; undefined removes it. */
export function replaceAt(value: unknown, path: readonly (string | number)[], to: unknown): unknown {
  const [first, ...rest] = path;
  if (first === undefined) return to;
  const copy = (Array.isArray(value) ? [...value] : { ...(value as object) }) as Record<string | number, unknown>;
  copy[first] = replaceAt(copy[first], rest, to);
  return copy;
}
