/** Source of files from Python, which may run on another machine that this page cannot reach. */
import { abortable } from '../base/errors';
import { BundleError } from '../bundle/error';
import { parseManifest } from '../bundle/parse';
import { shareRequests } from '../bundle/requests';
import { type Received, serveListed, type Source } from '../bundle/source';
import type { Model } from './model';

/** Concurrent requests: Python answers them one after the other. */
const MAX_REQUESTS = 2;
const MANIFEST = 'manifest.json';

/** Python's answer: the size of a file, with a piece of it in a buffer; or an error. */
type Answer = { readonly id: string; readonly bytes: number } | { readonly id: string; readonly problem: string };

interface Piece {
  readonly data: Uint8Array<ArrayBuffer>;
  /** Size of the whole file. */
  readonly bytes: number;
}

export interface KernelSource extends Source {
  dispose(): void;
}

/** Opens the bundle of a model; `received` is called with the bytes of all files. */
export async function openKernel(model: Model, received: Received, signal: AbortSignal): Promise<KernelSource> {
  const pendingPieces = new Map<string, { done(piece: Piece): void; failed(reason: Error): void }>();
  // Answers reach every view of the model, so that ids must be unique.
  const viewId = Math.random().toString(36).slice(2);
  let requestCount = 0;

  const onAnswer = (answer: Answer, buffers: readonly DataView[]): void => {
    const pending = pendingPieces.get(answer?.id);
    if (!pending) return;
    pendingPieces.delete(answer.id);
    const [buffer] = buffers;
    // A copy, whose buffer can be transferred to a worker.
    const copy = buffer && new Uint8Array(buffer.buffer, buffer.byteOffset, buffer.byteLength).slice();
    if ('problem' in answer) pending.failed(new BundleError(answer.problem));
    else if (!copy) pending.failed(new BundleError('the kernel answers without a file'));
    else pending.done({ data: copy as Uint8Array<ArrayBuffer>, bytes: answer.bytes });
  };
  model.on('msg:custom', onAnswer);

  /** Requests a piece of a file, without a timeout, because a busy kernel answers later. */
  function ask(name: string, start: number, stop: AbortSignal): Promise<Piece> {
    const id = `${viewId}-${++requestCount}`;
    return abortable<Piece>(stop, (done, failed) => {
      pendingPieces.set(id, { done, failed });
      model.send({ kind: 'read', id, name, start });
      return () => pendingPieces.delete(id);
    });
  }

  async function load(name: string, bytes: number | null, stop: AbortSignal, onBytes: Received): Promise<ArrayBuffer> {
    const parts: Uint8Array<ArrayBuffer>[] = [];
    let size = 0;
    for (;;) {
      const piece = await ask(name, size, stop);
      parts.push(piece.data);
      size += piece.data.length;
      received(piece.data.length);
      onBytes(piece.data.length);
      if (bytes !== null && piece.bytes !== bytes)
        throw new BundleError(`${name}: expected ${bytes} bytes, as the manifest lists it, got ${piece.bytes}`);
      if (size === piece.bytes) return await new Blob(parts).arrayBuffer();
      if (piece.data.length === 0 || size > piece.bytes) throw new BundleError(`${name}: expected ${piece.bytes} bytes`);
    }
  }

  const text = await load(MANIFEST, null, signal, () => undefined);
  const manifest = parseManifest(new TextDecoder().decode(text));
  const shared = shareRequests(serveListed((name) => manifest.files[name], MAX_REQUESTS, load));
  return {
    manifest,
    fetch: (name, stop, onBytes = () => undefined) => shared(name, stop, onBytes),
    // No cache lies in between.
    distrust: () => undefined,
    dispose() {
      model.off('msg:custom', onAnswer);
      pendingPieces.clear();
    },
  };
}
