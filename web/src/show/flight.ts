/**
 * Counts what was sent to the GPU and has not been taken by it. A browser has little room for that: once it is full, a
 * call waits until the GPU has done all before it, which can take many frames where a computer draws without a GPU.
 */

/** Bytes on their way, at most; Chromium waits from 16 MiB on. */
export const MOST_IN_FLIGHT = 2 ** 23;

export interface Flight {
  /** So many bytes are sent now. */
  send(bytes: number): void;
  /** Whether so many more may be sent. */
  hasRoom(bytes: number): boolean;
  /** All that was sent until now is known to be taken when the GPU comes to this point. */
  mark(): void;
  /** The graphics were lost: nothing is on its way. */
  forget(): void;
}

/** `gl` is null where nothing needs to be counted. */
export function createFlight(gl: WebGL2RenderingContext | null): Flight {
  let marks: { readonly sync: WebGLSync; readonly bytes: number }[] = [];
  let sent = 0;

  /** Marks that the GPU has passed go, from the first on. */
  function settle(context: WebGL2RenderingContext): void {
    for (let first = marks[0]; first; first = marks[0]) {
      if (context.getSyncParameter(first.sync, context.SYNC_STATUS) !== context.SIGNALED) return;
      context.deleteSync(first.sync);
      marks.shift();
    }
  }

  return {
    send(bytes) {
      sent += bytes;
    },
    hasRoom(bytes) {
      if (!gl || bytes === 0) return true;
      settle(gl);
      const flying = marks.reduce((sum, mark) => sum + mark.bytes, sent);
      // Nothing is too much for a GPU that has nothing to do.
      return flying === 0 || flying + bytes <= MOST_IN_FLIGHT;
    },
    mark() {
      if (gl && sent > 0) {
        const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync) marks.push({ sync, bytes: sent });
        gl.flush();
      }
      sent = 0;
    },
    forget() {
      marks = [];
      sent = 0;
    },
  };
}
