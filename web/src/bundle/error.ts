/**
 * Cause of an error: damaged bundle, newer bundle, network, address parameters, WebGL, a scene that the server cannot
 * load, a place whose region it cannot make.
 */
export type Kind = 'damaged' | 'newer' | 'network' | 'address' | 'webgl' | 'scene' | 'place' | 'other';

/** An error whose message explains why something cannot be shown. */
export class BundleError extends Error {
  override readonly name = 'BundleError';

  constructor(message: string, readonly kind: Kind = 'damaged') {
    super(message);
  }
}

/** Name of the file at the beginning of a message about damage; null for other messages. */
export function damagedFile({ message }: Error): string | null {
  return /^(files\/[\w.]+):/.exec(message)?.[1] ?? null;
}
