/** Prediction of the duration of steps from earlier ones of the same kind. */

/** Kind of a step; its duration is a constant plus a term proportional to its bytes. */
export type StepKind = 'map' | 'picture' | 'arrays' | 'mesh' | 'program';

interface Sized {
  readonly kind: StepKind;
  readonly bytes: number;
}

export interface Costs {
  /** Expected duration of a step, milliseconds. */
  expected(step: Sized): number;
  /** Learns from the duration of a step. */
  learn(step: Sized, milliseconds: number): void;
}

/** Number of bytes whose upload takes as long as an empty step. */
const UNIT = 2 ** 16;
/** Initial milliseconds per unit: those of a slow computer. */
const FIRST: Readonly<Record<StepKind, number>> = { map: 0.2, picture: 0.2, arrays: 0.1, mesh: 0.5, program: 2.5 };
/** Learning rate of the estimate. */
const LEARNT = 0.15;
/** Greatest ratio to the estimate that is learned: longer steps were interrupted. */
const MAX = 4;

export function createCosts(): Costs {
  const known = new Map<StepKind, number>();
  const unit = (kind: StepKind): number => known.get(kind) ?? FIRST[kind];
  const units = (bytes: number): number => 1 + bytes / UNIT;
  return {
    expected: ({ kind, bytes }) => unit(kind) * units(bytes),
    learn({ kind, bytes }, milliseconds) {
      const before = unit(kind);
      const seen = Math.min(milliseconds / units(bytes), MAX * before);
      known.set(kind, before + LEARNT * (seen - before));
    },
  };
}
