/** Browsers may take the graphics away, with all that was uploaded, and give them back empty. */

export interface Loss {
  readonly isLost: boolean;
}

/** Watch a canvas; to be called after three.js does, which makes itself ready first. */
export function watchLoss(canvas: HTMLCanvasElement, lost: () => void, restored: () => void): Loss {
  let isLost = false;
  canvas.addEventListener('webglcontextlost', (event) => {
    // Else the browser gives nothing back.
    event.preventDefault();
    isLost = true;
    lost();
  });
  canvas.addEventListener('webglcontextrestored', () => {
    isLost = false;
    restored();
  });
  return {
    get isLost() {
      return isLost;
    },
  };
}
