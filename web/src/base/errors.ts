/** Messages of errors, and promises that reject when a signal aborts. */

/** Message of anything that was thrown. */
export function messageOf(reason: unknown): string {
  return reason instanceof Error ? reason.message : String(reason);
}

/**
 * Creates a promise that also rejects, with the signal's reason, when the signal aborts. `begin` receives the functions
 * that fulfil and reject the promise, and may return a function to call on abort.
 */
export function abortable<T>(
  signal: AbortSignal,
  begin: (fulfil: (value: T) => void, fail: (reason: unknown) => void) => (() => void) | void,
): Promise<T> {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const abort = (): void => {
      reject(signal.reason as Error);
      stop?.();
    };
    const detached = <Argument>(settle: (argument: Argument) => void) => (argument: Argument): void => {
      signal.removeEventListener('abort', abort);
      settle(argument);
    };
    signal.addEventListener('abort', abort, { once: true });
    const stop = begin(detached(resolve), detached(reject));
  });
}
