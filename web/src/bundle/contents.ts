/** File names of parts of a bundle. */
import type { GroupEntry, Manifest, MapEntry, RegionEntry, RingEntry } from './manifest';

export function filesOfGeometry({ geometry, parts }: Pick<GroupEntry, 'geometry' | 'parts'>): string[] {
  return geometry === null ? [] : [geometry, ...parts];
}

export function filesOfMap(map: MapEntry | null): string[] {
  return map ? [map.color, map.range].flat().filter((name) => name !== null) : [];
}

export function filesOfRing(ring: RingEntry): string[] {
  return [...filesOfGeometry(ring), ...filesOfMap(ring.map), ...(ring.sharper?.maps ?? []).flatMap(filesOfMap)];
}

/** All files of a region, each once, including those of dynamic objects. */
export function filesOfRegion({ dynamic }: Manifest, { rings }: RegionEntry): Set<string> {
  const moving = dynamic ? filesOfGeometry(dynamic) : [];
  return new Set([...moving, ...rings.flatMap(filesOfRing)]);
}

export function bytesOf({ files }: Manifest, names: Iterable<string>): number {
  let sum = 0;
  for (const name of names) sum += files[name]?.bytes ?? 0;
  return sum;
}
