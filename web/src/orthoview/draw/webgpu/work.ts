/** Work of a picture as numbers for the shaders: views, their parts, and the call that draws each part. */
import { type Part, WORDS } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import type { Item } from '../drawer';
import { isIn, type Model, type Projector, rowsOf, type Seen, seenOf, sightOf, VECTORS, writeView } from '../sight';

/** 32-bit words per part. */
export const PART = 8;
/** Shares of a picture's splats after which the depths of tiles are updated; the last call draws the rest. */
const BATCHES = [1 / 16, 1 / 8, 1 / 4, 1 / 2] as const;

/** Layer of a view in a page of words. */
export interface Placed<Page> {
  readonly model: Model;
  readonly parts: readonly Part[];
  readonly page: Page;
  /** Index of its first word in the page. */
  readonly first: number;
}

/** Range [first, first + count) of parts whose splats lie in one page. */
export interface Call<Page> {
  readonly page: Page;
  readonly first: number;
  readonly count: number;
  /** Whether a batch begins with this call. */
  readonly begins: boolean;
}

export interface Work<Page> {
  readonly views: Float32Array<ArrayBuffer>;
  /** Parts in the layout of the shaders, in the order of the calls. */
  readonly parts: Uint32Array<ArrayBuffer>;
  /** Indices of the parts, sorted by their first splats. */
  readonly listed: Uint32Array<ArrayBuffer>;
  readonly pages: readonly Page[];
  readonly calls: readonly Call<Page>[];
  readonly splats: number;
}

/** Part that is visible in the picture. */
interface Shown<Page> {
  /** Index of its view, its first word, and the index of its first splat among all parts. */
  readonly view: number;
  readonly first: number;
  readonly number: number;
  readonly count: number;
  readonly place: Seen;
  readonly page: Page;
}

/** Work of a picture, nearest parts first; depths are `nearest` times nearness. */
export function workOf<Page>(
  items: readonly Item<Placed<Page>>[],
  projector: Projector,
  layout: Layout,
  nearest: number,
): Work<Page> {
  const views: number[] = [];
  const seen: Shown<Page>[] = [];
  const numbers = new Float32Array(4 * VECTORS);
  let number = 0;
  for (const { layer, box } of items) {
    const sight = sightOf(layer.model, projector);
    const rows = rowsOf(layer.model, layout, box);
    const view = views.length / (4 * VECTORS);
    const before = seen.length;
    for (const part of layer.parts) {
      const place = seenOf(sight, part, projector.width, projector.height);
      if (!place || (box && !isIn(rows, part))) continue;
      const { count } = part;
      seen.push({ view, first: layer.first + WORDS * part.first, number, count, place, page: layer.page });
      number += count;
    }
    if (seen.length === before) continue;
    writeView(numbers, layer.model, sight, rows);
    views.push(...numbers);
  }
  return { views: new Float32Array(views), splats: number, ...assignCalls(seen, number, nearest) };
}

const [FLOATS, BITS] = ((buffer) => [new Float32Array(buffer), new Uint32Array(buffer)] as const)(new ArrayBuffer(4));

/** Bits of the float32 above a depth; their order is the order of depths of at least 0. */
function orderOf(depth: number): number {
  FLOATS[0] = depth;
  return (BITS[0] as number) + (Number.isFinite(depth) ? 1 : 0);
}

/** Distributes parts among calls; `seen` is in the order of the splats' indices. */
function assignCalls<Page>(
  seen: readonly Shown<Page>[],
  splats: number,
  nearest: number,
): Omit<Work<Page>, 'views' | 'splats'> {
  const sorted = [...seen].sort((a, b) => compareNumbers(b.place.nearness, a.place.nearness));
  const pages = [...new Set(seen.map(({ page }) => page))];
  const parts = new Uint32Array(PART * seen.length);
  const places = new Map<Shown<Page>, number>();
  const calls: Call<Page>[] = [];
  for (const batch of batchesOf(sorted, splats)) {
    let begins = true;
    for (const page of pages) {
      const own = batch.filter((part) => part.page === page);
      if (own.length === 0) continue;
      calls.push({ page, begins, first: places.size, count: own.length });
      begins = false;
      for (const part of own) {
        parts.set(numbersOf(part, pages.indexOf(page), nearest), PART * places.size);
        places.set(part, places.size);
      }
    }
  }
  const listed = new Uint32Array(seen.map((part) => places.get(part) as number));
  return { parts, listed, pages, calls };
}

/** Compares two numbers, also infinite ones. */
function compareNumbers(a: number, b: number): number {
  return Number(a > b) - Number(a < b);
}

/** Part in the layout of the shaders. */
function numbersOf<Page>({ view, first, number, count, place }: Shown<Page>, page: number, nearest: number): number[] {
  const { low, high, nearness } = place;
  const order = orderOf(nearest * nearness);
  return [view, first, count, number, order, low[0] | (low[1] << 16), high[0] | (high[1] << 16), page];
}

/** Splits parts into batches, each with about as many splats as all before it. */
export function batchesOf<Each extends { readonly count: number }>(
  parts: readonly Each[],
  splats: number,
): readonly (readonly Each[])[] {
  const batches: Each[][] = [];
  let [batch, drawn, next]: [Each[], number, number] = [[], 0, 0];
  for (const part of parts) {
    batch.push(part);
    drawn += part.count;
    if (next >= BATCHES.length || drawn < splats * (BATCHES[next] as number)) continue;
    while (next < BATCHES.length && drawn >= splats * (BATCHES[next] as number)) next += 1;
    batches.push(batch);
    batch = [];
  }
  if (batch.length > 0) batches.push(batch);
  return batches;
}
