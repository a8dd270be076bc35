/** Worker that reads a store's records of cells, and cuts the tree for the viewer. */
import { canRetry, failureOf } from '../store/error';
import { createFiles } from '../store/files';
import { nameOf, type Triple } from '../store/layout';
import { openRecords, type Records } from '../store/records';
import type { Camera } from './camera';
import { Cells, cut, type Cut, type FromCutter, type Settings, type ToCutter } from './cut';

/** Ratio of the error of the coarse cells, which lie all around the viewer, to the error of the cut. */
const COARSE_FACTOR = 6;
/** Milliseconds before a failed subtree is requested again. */
const RETRY_MS = 3000;

let records: Records | null = null;
let cells: Cells | null = null;
let view: { readonly camera: Camera; readonly settings: Settings } | null = null;
/** Names of the requested subtrees; a failed one is removed before its next request. */
const requested = new Set<string>();

self.onmessage = ({ data }: MessageEvent<ToCutter>): void => {
  switch (data.kind) {
    case 'open':
      void open(new URL(data.base));
      break;
    case 'look':
      view = data;
      sendCut();
      break;
    case 'retry':
      requested.clear();
      sendCut();
  }
};

async function open(base: URL): Promise<void> {
  try {
    records = await openRecords(createFiles(base, (bytes) => post({ kind: 'received', bytes })));
    cells = new Cells(records.layout);
    const { layout, shards, geometry } = records;
    post({ kind: 'opened', layout, shards, geometry });
    sendCut();
  } catch (reason) {
    post({ kind: 'failed', failure: failureOf(reason), isFatal: true });
  }
}

function sendCut(): void {
  if (!view || !cells) return;
  const { camera, settings } = view;
  const [coarse, fine] = [coarseCutOf(cells, camera, settings), cut(cells, camera, settings)];
  post({ kind: 'cut', cut: fine, coarse });
  requestUnknown(coarse);
  requestUnknown(fine);
}

/** Cut with coarse cells all around, coarsest first. */
function coarseCutOf(cells: Cells, camera: Camera, settings: Settings): Cut {
  const { levels } = cells.layout;
  const errors = Array.from({ length: levels }, (_, n) => settings.error * COARSE_FACTOR * 2 ** (levels - 1 - n));
  // With the greatest error only the root cell is drawn.
  const cuts = [Number.MAX_VALUE, ...errors].map((error) =>
    cut(cells, camera, { ...settings, error, includesOutside: true, geometry: false }),
  );
  return { ...(cuts.at(-1) as Cut), cells: cuts.flatMap((each) => each.cells) };
}

function requestUnknown({ unknown }: Cut): void {
  for (const { tier, place } of unknown) {
    const name = nameOf(tier, place);
    if (requested.has(name)) continue;
    requested.add(name);
    void readSubtree(tier, place, name);
  }
}

async function readSubtree(tier: number, place: Triple, name: string): Promise<void> {
  if (!records || !cells) return;
  try {
    const subtree = await records.subtree(tier, place);
    cells.add(subtree);
    post({ kind: 'subtree', subtree });
    sendCut();
  } catch (reason) {
    const failure = failureOf(reason);
    post({ kind: 'failed', failure, isFatal: false });
    if (!canRetry(failure)) return;
    setTimeout(() => {
      requested.delete(name);
      sendCut();
    }, RETRY_MS);
  }
}

function post(message: FromCutter): void {
  self.postMessage(message);
}
