/** Who of several users asks the server for a file, so that all find the same one (rendezvous hashing). */

/** A weight of a user for a file; who has the greatest one asks. Keys are SHA-256 in hexadecimal digits. */
export function weightOf(user: number, key: string): number {
  return mixed(mixed(user + 1) ^ parseInt(key.slice(0, 8), 16));
}

/** Whether one user comes before another one for a file. */
export function isBefore(one: number, other: number, key: string): boolean {
  const difference = weightOf(one, key) - weightOf(other, key);
  return difference > 0 || (difference === 0 && one < other);
}

/** The finalizer of MurmurHash3: each bit of the result depends on each bit of the number. */
function mixed(number: number): number {
  let hash = number >>> 0;
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return (hash ^ (hash >>> 16)) >>> 0;
}
