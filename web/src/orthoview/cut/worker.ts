/** Worker that reads a store's records of cells, and cuts the tree for the viewer. */
import { failureOf, isPassing } from '../store/error';
import { createFiles } from '../store/files';
import { nameOf, type Triple } from '../store/layout';
import { openRecords, type Records } from '../store/records';
import type { Camera } from './camera';
import { Cells } from './cells';
import { cut, type Cut, type FromCutter, type Settings, type ToCutter } from './cut';

/** Factor by which the base cells, which are kept all around, are coarser. */
const COARSER = 6;
/** Milliseconds before a failed subtree is requested again. */
const AGAIN = 3000;

let records: Records | null = null;
let cells: Cells | null = null;
let looking: { camera: Camera; settings: Settings } | null = null;
/** Subtrees that are being read, or that failed. */
const requested = new Set<string>();

self.onmessage = ({ data }: MessageEvent<ToCutter>): void => {
  switch (data.kind) {
    case 'open':
      void open(new URL(data.base));
      break;
    case 'look':
      looking = { camera: data.camera, settings: data.settings };
      look();
      break;
    case 'retry':
      requested.clear();
      look();
  }
};

async function open(base: URL): Promise<void> {
  try {
    records = await openRecords(createFiles(base, (bytes) => post({ kind: 'received', bytes })));
    cells = new Cells(records.layout);
    const { layout, generation, shards, geometry } = records;
    post({ kind: 'opened', layout, generation, shards, geometry });
    look();
  } catch (reason) {
    post({ kind: 'failed', failure: failureOf(reason), isFatal: true });
  }
}

function look(): void {
  if (!looking || !cells) return;
  const { camera, settings } = looking;
  const base = baseOf(cells, camera, settings);
  post({ kind: 'base', cut: base });
  const found = cut(cells, camera, settings);
  post({ kind: 'cut', cut: found });
  requestUnknown(base);
  requestUnknown(found);
}

/** Coarse cells all around, from the coarsest level down. */
function baseOf(known: Cells, camera: Camera, settings: Settings): Cut {
  const cuts = Array.from({ length: known.layout.levels }, (_, finer) => {
    const error = settings.error * COARSER * 2 ** (known.layout.levels - 1 - finer);
    return cut(known, camera, { ...settings, error, isAround: true, geometry: false });
  });
  // With this error only the root cell is drawn.
  const whole = cut(known, camera, { ...settings, error: Number.MAX_VALUE, isAround: true, geometry: false });
  const finest = cuts.at(-1) ?? whole;
  return { ...finest, cells: [whole, ...cuts].flatMap(({ cells: drawn }) => drawn) };
}

function requestUnknown({ unknown }: Cut): void {
  for (const { tier, place } of unknown) {
    const name = nameOf(tier, place);
    if (requested.has(name)) continue;
    requested.add(name);
    void learn(tier, place, name);
  }
}

async function learn(tier: number, place: Triple, name: string): Promise<void> {
  if (!records || !cells) return;
  try {
    const subtree = await records.subtree(tier, place);
    cells.add(subtree);
    post({ kind: 'learned', subtree });
    look();
  } catch (reason) {
    const failure = failureOf(reason);
    post({ kind: 'failed', failure, isFatal: false });
    if (!isPassing(failure)) return;
    setTimeout(() => {
      requested.delete(name);
      look();
    }, AGAIN);
  }
}

function post(message: FromCutter): void {
  self.postMessage(message);
}
