/**
 * Counter of bytes that were sent to the GPU and not consumed. Browsers have little room for them: once it is full, a
 * call blocks until the GPU has finished all before it, which can take many frames with software rendering.
 */

/** Greatest number of bytes in flight; Chromium blocks from 16 MiB on. */
export const MAX_IN_FLIGHT = 2 ** 23;

export interface Flight {
  /** Adds sent bytes. */
  send(bytes: number): void;
  /** Whether this many more bytes may be sent. */
  hasRoom(bytes: number): boolean;
  /** Inserts a fence: bytes sent before it count as consumed when the GPU passes it. */
  mark(): void;
  /** Resets the counter after the graphics were lost. */
  forget(): void;
}

/** Creates the counter; `gl` is null if nothing needs to be counted. */
export function createFlight(gl: WebGL2RenderingContext | null): Flight {
  let marks: { readonly sync: WebGLSync; readonly bytes: number }[] = [];
  let sent = 0;

  /** Removes fences that the GPU has passed. */
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
      // An idle GPU takes any amount.
      return flying === 0 || flying + bytes <= MAX_IN_FLIGHT;
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
