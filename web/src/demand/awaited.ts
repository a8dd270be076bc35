/** A value that comes later, or has come. */

export interface Awaited<T> {
  readonly promise: Promise<T>;
  /** The value, once it is there. */
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
  // Nobody may wait for it.
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
