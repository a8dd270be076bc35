/** Loss of the graphics context: browsers may destroy it with all uploads, and restore it empty. */

export interface Loss {
  readonly isLost: boolean;
  /** Stops watching. */
  dispose(): void;
}

/** Watches a canvas; to be called after three.js has registered its own listeners. */
export function watchLoss(canvas: HTMLCanvasElement, lost: () => void, restored: () => void): Loss {
  let isLost = false;
  const stop = new AbortController();
  const { signal } = stop;
  const went = (event: Event): void => {
    // Otherwise the browser does not restore the context.
    event.preventDefault();
    isLost = true;
    lost();
  };
  const came = (): void => {
    isLost = false;
    restored();
  };
  canvas.addEventListener('webglcontextlost', went, { signal });
  canvas.addEventListener('webglcontextrestored', came, { signal });
  return {
    get isLost() {
      return isLost;
    },
    dispose: () => stop.abort(),
  };
}
