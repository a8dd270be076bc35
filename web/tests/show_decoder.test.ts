import assert from 'node:assert/strict';
import { test } from 'node:test';
import { startDecoder } from '../src/show/decoder';

/** A worker that never answers. */
class SilentWorker {
  static last: SilentWorker | null = null;
  readonly messages: unknown[] = [];
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onerror: ((event: { message: string }) => void) | null = null;

  constructor() {
    SilentWorker.last = this;
  }

  postMessage(message: unknown): void {
    this.messages.push(message);
  }
}

const FORGET = { kind: 'forget', buffers: [], region: 0 } as const;

test('when a decoder stops, all requests fail, also later ones', async () => {
  Object.assign(globalThis, { Worker: SilentWorker });
  const { decode } = startDecoder(new URL('https://example.org/worker.js'), () => undefined);
  const request = decode(FORGET);
  const worker = SilentWorker.last as SilentWorker;
  worker.onerror?.({ message: 'no such script' });
  await assert.rejects(request, /the decoder stopped: no such script/);
  await assert.rejects(decode(FORGET), /the decoder stopped: no such script/);
  assert.equal(worker.messages.length, 1);
});
