/** What a bundle has that cannot be shown, in a sentence. */
export class BundleError extends Error {
  override readonly name = 'BundleError';
}
