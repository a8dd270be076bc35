/** Reads files from Python through the notebook, because Python may run on a machine that this page cannot reach. */
import { abortable } from '../base/errors';
import { BundleError } from '../bundle/error';
import { parseManifest } from '../bundle/parse';
import { shareRequests } from '../bundle/requests';
import { type Received, serveListed, type Source } from '../bundle/source';
import type { Model } from './model';

/** Greatest number of concurrent requests; Python answers them one after the other. */
const MAX_REQUESTS = 2;
const MANIFEST = 'manifest.json';

/** Python's answer: the size of a file, with a piece of the file in a buffer; or an error. */
type Answer = { readonly id: string; readonly bytes: number } | { readonly id: string; readonly problem: string };

interface Piece {
  readonly data: Uint8Array<ArrayBuffer>;
  /** Size of the whole file. */
  readonly bytes: number;
}

export interface KernelSource extends Source {
  dispose(): void;
}

/** Opens the bundle of a model; calls `onBytes` with the number of bytes that arrive of any file. */
export async function openKernel(model: Model, onBytes: Received, signal: AbortSignal): Promise<KernelSource> {
  const pendingPieces = new Map<string, { done(piece: Piece): void; fail(reason: Error): void }>();
  // All views of the model receive all answers, so that ids must be unique among views.
  const viewId = Math.random().toString(36).slice(2);
  let requestCount = 0;

  const onAnswer = (answer: Answer, buffers: readonly DataView[]): void => {
    const pending = pendingPieces.get(answer?.id);
    if (!pending) return;
    pendingPieces.delete(answer.id);
    const [buffer] = buffers;
    // The buffer of a copy can be transferred to a worker.
    const copy = buffer && new Uint8Array(buffer.buffer, buffer.byteOffset, buffer.byteLength).slice();
    if ('problem' in answer) pending.fail(new BundleError(answer.problem));
    else if (!copy) pending.fail(new BundleError('the kernel answers without a file'));
    else pending.done({ data: copy as Uint8Array<ArrayBuffer>, bytes: answer.bytes });
  };
  model.on('msg:custom', onAnswer);

  /** Requests the piece of a file from byte `start` on; without a timeout, because a busy kernel answers late. */
  function requestPiece(name: string, start: number, stop: AbortSignal): Promise<Piece> {
    const id = `${viewId}-${++requestCount}`;
    return abortable<Piece>(stop, (done, fail) => {
      pendingPieces.set(id, { done, fail });
      model.send({ kind: 'read', id, name, start });
      return () => pendingPieces.delete(id);
    });
  }

  async function load(name: string, bytes: number | null, stop: AbortSignal, onFileBytes: Received) {
    const parts: Uint8Array<ArrayBuffer>[] = [];
    let size = 0;
    for (;;) {
      const piece = await requestPiece(name, size, stop);
      parts.push(piece.data);
      size += piece.data.length;
      onBytes(piece.data.length);
      onFileBytes(piece.data.length);
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
    fetch: (name, stop, onFileBytes = () => undefined) => shared(name, stop, onFileBytes),
    // There is no cache between Python and the page.
    distrust: () => undefined,
    dispose() {
      model.off('msg:custom', onAnswer);
      pendingPieces.clear();
    },
  };
}
