/** Browsers may take the graphics away, with all that was uploaded, and give them back empty. */

export interface Loss {
  readonly isLost: boolean;
  /** Watch no longer. */
  dispose(): void;
}

/** Watch a canvas; to be called after three.js does, which makes itself ready first. */
export function watchLoss(canvas: HTMLCanvasElement, lost: () => void, restored: () => void): Loss {
  let isLost = false;
  const stop = new AbortController();
  const { signal } = stop;
  const went = (event: Event): void => {
    // Else the browser gives nothing back.
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
