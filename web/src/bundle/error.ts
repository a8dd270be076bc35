/**
 * Cause of an error. `address`: parameters of the page's address; `scene`: the server cannot load the scene; `place`:
 * the server cannot make the region of a place.
 */
export type Kind = 'damaged' | 'newer' | 'network' | 'address' | 'webgl' | 'scene' | 'place' | 'other';

/** An error whose message explains why something cannot be shown. */
export class BundleError extends Error {
  override readonly name = 'BundleError';

  constructor(message: string, readonly kind: Kind = 'damaged') {
    super(message);
  }
}

/** Name of the damaged file, with which a message about damage begins; null for other messages. */
export function damagedFile({ message }: Error): string | null {
  return /^(files\/[\w.]+):/.exec(message)?.[1] ?? null;
}
