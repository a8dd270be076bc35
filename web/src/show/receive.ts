/** Receiving of a file's geometry: requests its parts from a worker, and uploads each while the next one is decoded. */
import type { WebGLRenderer } from 'three';
import type { Geometry } from '../decode/messages';
import type { Decoder } from './decoder';
import { createPictures } from './pictures';
import type { PieceMesh } from './pieces';
import type { Programs } from './programs';
import { complete, partSteps, type Region } from './region';
import type { Store } from './store';
import type { Uploads } from './uploads';

/** Resources for receiving geometry. */
export interface Receiving {
  readonly renderer: WebGLRenderer;
  readonly store: Store;
  readonly uploads: Uploads;
  readonly geometry: Decoder;
  readonly programs: Programs;
  readonly warm: (meshes: readonly PieceMesh[]) => void;
}

/** Adds geometry to the group of a ring; it is shown when complete. */
export async function receiveParts(
  receiving: Receiving,
  region: Region,
  ring: number,
  { number, parts, samples, triangles }: Geometry,
  signal: AbortSignal,
): Promise<void> {
  const { renderer, store, uploads, geometry, programs, warm } = receiving;
  const making = { gl: renderer.getContext() as WebGL2RenderingContext, store, warm };
  const pictures = createPictures(renderer, (name, texture) => {
    // Another region may have loaded it meanwhile.
    if (store.textures.has(name)) texture.dispose();
    else store.textures.set(name, texture);
  });
  try {
    signal.throwIfAborted();
    await programs.ready(samples);
    let before = Promise.resolve();
    for (let next = 0; next < parts; next++) {
      const part = await geometry({ kind: 'part', of: number, part: next });
      const sent = uploads.add(partSteps(region, ring, part, making, pictures), signal);
      // Awaiting the promise reports the error.
      sent.catch(() => undefined);
      await before;
      before = sent;
    }
    await before;
    complete(region, ring, triangles);
  } finally {
    pictures.dispose();
    // The error of a stopped worker is reported to its pending requests.
    geometry({ kind: 'drop', of: number }).catch(() => undefined);
  }
}
