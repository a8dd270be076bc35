import assert from 'node:assert/strict';
import { test } from 'node:test';
import { startDecoder } from '../src/show/decoder';

/** A worker that receives messages and never answers by itself. */
class SilentWorker {
  static last: SilentWorker | null = null;
  readonly heard: unknown[] = [];
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onerror: ((event: { message: string }) => void) | null = null;

  constructor() {
    SilentWorker.last = this;
  }

  postMessage(message: unknown): void {
    this.heard.push(message);
  }
}

const FORGET = { kind: 'forget', buffers: [], region: 0 } as const;

test('stopping a decoder ends all waiting', async () => {
  Object.assign(globalThis, { Worker: SilentWorker });
  const { decode } = startDecoder(new URL('https://example.org/worker.js'), () => undefined);
  const before = decode(FORGET);
  const worker = SilentWorker.last as SilentWorker;
  worker.onerror?.({ message: 'no such script' });
  await assert.rejects(before, /the decoder stopped: no such script/);
  await assert.rejects(decode(FORGET), /the decoder stopped: no such script/);
  assert.equal(worker.heard.length, 1);
});
