/** Messages between the page and the workers that read views. */
import type { Failure } from '../store/error';
import type { Layout } from '../store/layout';
import type { Piece } from './leaf';
import type { Splats } from './pack';
import type { Wanted } from './reader';

export type ToReader =
  | { readonly kind: 'open'; readonly base: string; readonly layout: Layout }
  | { readonly kind: 'read'; readonly id: number; readonly wanted: Wanted }
  | { readonly kind: 'cancel'; readonly id: number };

export type FromReader =
  | { readonly kind: 'view'; readonly id: number; readonly layers: readonly Splats[] }
  | { readonly kind: 'leaf'; readonly id: number; readonly pieces: readonly Piece[] }
  | { readonly kind: 'failed'; readonly id: number; readonly failure: Failure }
  | { readonly kind: 'cancelled'; readonly id: number }
  | { readonly kind: 'received'; readonly bytes: number };
