/** Rendezvous hashing: all users agree on the one that requests a file from the server. */

/** Weight of a user for a file, whose key is a SHA-256 in hexadecimal digits; the greatest weight wins. */
export function weightOf(user: number, key: string): number {
  return mixed(mixed(user + 1) ^ parseInt(key.slice(0, 8), 16));
}

/** Whether one user precedes another one for a file. */
export function isBefore(one: number, other: number, key: string): boolean {
  const difference = weightOf(one, key) - weightOf(other, key);
  return difference > 0 || (difference === 0 && one < other);
}

/** Finalizer of MurmurHash3: each bit of the result depends on each bit of the number. */
function mixed(number: number): number {
  let hash = number >>> 0;
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return (hash ^ (hash >>> 16)) >>> 0;
}
