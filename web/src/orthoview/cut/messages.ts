/** Messages between the page and the worker that cuts the tree. */
import type { Failure } from '../store/error';
import type { Layout } from '../store/layout';
import type { Shard, Subtree } from '../store/records';
import type { Camera } from './camera';
import type { Cut, Settings } from './cut';

export type ToCutter =
  | { readonly kind: 'open'; readonly base: string }
  /** Sets the camera: the cut is sent at once, and again whenever more of the tree is known. */
  | { readonly kind: 'look'; readonly camera: Camera; readonly settings: Settings }
  /** Retries failed reads. */
  | { readonly kind: 'retry' };

export type FromCutter =
  | {
      readonly kind: 'opened';
      readonly layout: Layout;
      readonly generation: number;
      readonly shards: readonly Shard[];
      readonly geometry: readonly Shard[];
    }
  | { readonly kind: 'learned'; readonly subtree: Subtree }
  | { readonly kind: 'cut'; readonly cut: Cut }
  /** Coarse cells all around the viewer, which are few: shown first when a viewer turns. */
  | { readonly kind: 'base'; readonly cut: Cut }
  | { readonly kind: 'received'; readonly bytes: number }
  /** `isFatal` if nothing can be shown. */
  | { readonly kind: 'failed'; readonly failure: Failure; readonly isFatal: boolean };
