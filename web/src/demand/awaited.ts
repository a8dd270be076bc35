/** A value that arrives later, or has arrived. */

export interface Awaited<T> {
  readonly promise: Promise<T>;
  /** The value, once it has arrived. */
  readonly now: T | null;
  done(value: T): void;
  failed(reason: unknown): void;
}

export function createAwaited<T>(): Awaited<T> {
  let now: T | null = null;
  let [done, failed] = [(_: T): void => undefined, (_: unknown): void => undefined];
  const promise = new Promise<T>((resolve, reject) => {
    [done, failed] = [resolve, reject];
  });
  // A rejection without listeners is no unhandled error.
  promise.catch(() => undefined);
  return {
    promise,
    get now() {
      return now;
    },
    done(value) {
      now = value;
      done(value);
    },
    failed: (reason) => failed(reason),
  };
}
