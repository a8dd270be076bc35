/** Input of the shaders for a picture: views, their visible parts, and the calls that draw the parts. */
import { type Part, WORDS } from '../../decode/pack';
import type { Layout } from '../../store/layout';
import type { Item } from '../drawer';
import type { Model, PartBounds, Projector } from '../projection';
import { boundsOf, boxFunctionsOf, mayLieIn, projectView, VECTORS_PER_VIEW, writeView } from '../projection';

/** 32-bit words per part. */
export const PART_WORDS = 8;
/** Shares of a picture's splats after which the depths of tiles are updated. */
const BATCH_SHARES = [1 / 16, 1 / 8, 1 / 4, 1 / 2] as const;

/** Layer of a view in a page of words. */
export interface PagedLayer<Page> {
  readonly model: Model;
  readonly parts: readonly Part[];
  readonly page: Page;
  /** Index of the layer's first word in the page. */
  readonly first: number;
}

/** Draws the parts [first, first + count), whose splats lie in one page. */
export interface Call<Page> {
  readonly page: Page;
  readonly first: number;
  readonly count: number;
  /** Whether a batch begins with this call. */
  readonly startsBatch: boolean;
}

export interface Work<Page> {
  readonly views: Float32Array<ArrayBuffer>;
  /** Parts in the layout of the shaders, in the order of the calls. */
  readonly parts: Uint32Array<ArrayBuffer>;
  /** Indices of the parts, sorted by their first splats. */
  readonly partOrder: Uint32Array<ArrayBuffer>;
  readonly pages: readonly Page[];
  readonly calls: readonly Call<Page>[];
  readonly splats: number;
}

/** Part that is at least partly in the picture. */
interface VisiblePart<Page> {
  readonly view: number;
  readonly firstWord: number;
  /** Index of the part's first splat among those of all parts. */
  readonly firstSplat: number;
  readonly count: number;
  readonly bounds: PartBounds;
  readonly page: Page;
}

/** Work of a picture, nearest parts first; `nearest` is the near distance, metres. */
export function workOf<Page>(
  items: readonly Item<PagedLayer<Page>>[],
  projector: Projector,
  layout: Layout,
  nearest: number,
): Work<Page> {
  const views: number[] = [];
  const visible: VisiblePart<Page>[] = [];
  const numbers = new Float32Array(4 * VECTORS_PER_VIEW);
  let splats = 0;
  for (const { layer, box } of items) {
    const projected = projectView(layer.model, projector);
    const boxFunctions = boxFunctionsOf(layer.model, layout, box);
    const view = views.length / (4 * VECTORS_PER_VIEW);
    const countBefore = visible.length;
    for (const part of layer.parts) {
      const bounds = boundsOf(projected, part, projector.width, projector.height);
      if (!bounds || (box && !mayLieIn(boxFunctions, part))) continue;
      const firstWord = layer.first + WORDS * part.first;
      visible.push({ view, firstWord, firstSplat: splats, count: part.count, bounds, page: layer.page });
      splats += part.count;
    }
    if (visible.length === countBefore) continue;
    writeView(numbers, layer.model, projected, boxFunctions);
    views.push(...numbers);
  }
  return { views: new Float32Array(views), splats, ...assignCalls(visible, splats, nearest) };
}

const [FLOATS, BITS] = ((buffer) => [new Float32Array(buffer), new Uint32Array(buffer)] as const)(new ArrayBuffer(4));

/** Bits of a float32 just above a depth; depths of at least 0 compare like their bits. */
function upperBitsOf(depth: number): number {
  FLOATS[0] = depth;
  return (BITS[0] as number) + (Number.isFinite(depth) ? 1 : 0);
}

/** Distributes parts among calls; `visible` is in the order of the splats' indices. */
function assignCalls<Page>(visible: readonly VisiblePart<Page>[], splats: number, nearest: number) {
  const sorted = [...visible].sort((a, b) => compareNumbers(b.bounds.nearness, a.bounds.nearness));
  const pages = [...new Set(visible.map(({ page }) => page))];
  const parts = new Uint32Array(PART_WORDS * visible.length);
  const indices = new Map<VisiblePart<Page>, number>();
  const calls: Call<Page>[] = [];
  for (const batch of batchesOf(sorted, splats)) {
    let startsBatch = true;
    for (const page of pages) {
      const pageParts = batch.filter((part) => part.page === page);
      if (pageParts.length === 0) continue;
      calls.push({ page, startsBatch, first: indices.size, count: pageParts.length });
      startsBatch = false;
      for (const part of pageParts) {
        parts.set(wordsOf(part, pages.indexOf(page), nearest), PART_WORDS * indices.size);
        indices.set(part, indices.size);
      }
    }
  }
  const partOrder = new Uint32Array(visible.map((part) => indices.get(part) as number));
  return { parts, partOrder, pages, calls };
}

/** Compares two numbers, also infinite ones, whose difference may be NaN. */
function compareNumbers(a: number, b: number): number {
  return Number(a > b) - Number(a < b);
}

/** Part in the layout of the shaders. */
function wordsOf<Page>(part: VisiblePart<Page>, page: number, nearest: number): number[] {
  const { view, firstWord, firstSplat, count, bounds } = part;
  const [low, high] = [bounds.low, bounds.high].map(([column, row]) => column | (row << 16)) as [number, number];
  return [view, firstWord, count, firstSplat, upperBitsOf(nearest * bounds.nearness), low, high, page];
}

/** Splits parts into batches; each has about as many splats as all batches before it. */
export function batchesOf<P extends { readonly count: number }>(parts: readonly P[], splats: number): P[][] {
  const batches: P[][] = [[]];
  let [drawn, sharesBefore] = [0, 0];
  for (const part of parts) {
    // A new batch begins when the splats so far have reached the next share.
    const sharesReached = BATCH_SHARES.filter((share) => drawn >= splats * share).length;
    if (sharesReached > sharesBefore) batches.push([]);
    sharesBefore = sharesReached;
    batches.at(-1)?.push(part);
    drawn += part.count;
  }
  return batches.filter((batch) => batch.length > 0);
}
