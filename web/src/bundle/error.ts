/**
 * Why nothing can be shown: the bundle, a newer one, the network, what the address asks for, the browser's graphics, a
 * scene that the server cannot load, a place whose region it cannot make.
 */
export type Kind = 'damaged' | 'newer' | 'network' | 'address' | 'webgl' | 'scene' | 'place' | 'other';

/** An error that says in a sentence why something cannot be shown. */
export class BundleError extends Error {
  override readonly name = 'BundleError';

  constructor(
    message: string,
    readonly kind: Kind = 'damaged',
  ) {
    super(message);
  }
}

/** The file that a sentence on damage begins with; null if it is about something else. */
export function damagedFile({ message }: Error): string | null {
  return /^(files\/[\w.]+):/.exec(message)?.[1] ?? null;
}
