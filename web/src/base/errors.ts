/** Messages of errors, and promises that an abort rejects. */

/** Message of anything that was thrown. */
export function messageOf(reason: unknown): string {
  return reason instanceof Error ? reason.message : String(reason);
}

/**
 * Creates a promise that rejects with the signal's reason when the signal aborts. `begin` gets the functions that
 * settle it, and returns the function that an abort calls.
 */
export function abortable<T>(
  signal: AbortSignal,
  begin: (done: (value: T) => void, failed: (reason: unknown) => void) => (() => void) | void,
): Promise<T> {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const abort = (): void => {
      end?.();
      reject(signal.reason as Error);
    };
    const settled = <Argument>(settle: (argument: Argument) => void) => (argument: Argument): void => {
      signal.removeEventListener('abort', abort);
      settle(argument);
    };
    signal.addEventListener('abort', abort, { once: true });
    const end = begin(settled(resolve), settled(reject));
  });
}
