/** Files that parts of a bundle need. */
import type { Manifest, RegionEntry, RingEntry } from './manifest';

export function filesOfRing({ geometry, parts, map }: RingEntry): string[] {
  return [geometry, ...parts, map.color, map.range].flat().filter((name) => name !== null);
}

/** All files of a region up to a ring, each once; those of what moves are among them. */
export function filesOfRegion({ dynamic }: Manifest, { rings }: RegionEntry, last: number): Set<string> {
  const moving = dynamic ? [dynamic.geometry, ...dynamic.parts] : [];
  return new Set([...moving, ...rings.slice(0, last + 1).flatMap(filesOfRing)]);
}

export function bytesOf({ files }: Manifest, names: Iterable<string>): number {
  let sum = 0;
  for (const name of names) sum += files[name]?.bytes ?? 0;
  return sum;
}
