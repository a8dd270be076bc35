/** Foresees how long steps take, from those of the same kind before. */

/** Steps of a kind take a time of their own and one that grows with their bytes. */
export type StepKind = 'map' | 'picture' | 'arrays' | 'mesh' | 'program';

interface Sized {
  readonly kind: StepKind;
  readonly bytes: number;
}

export interface Costs {
  /** Milliseconds that a step will take. */
  expected(step: Sized): number;
  /** A step took so many milliseconds. */
  learn(step: Sized, milliseconds: number): void;
}

/** Bytes whose sending costs as much as a step without any. */
const UNIT = 2 ** 16;
/** Milliseconds a unit, before anything is known: those of a slow computer. */
const FIRST: Readonly<Record<StepKind, number>> = { map: 0.2, picture: 0.2, arrays: 0.1, mesh: 0.5, program: 2.5 };
/** Share of a surprise that is learnt. */
const LEARNT = 0.15;
/** A step that takes many times as long was interrupted, which says nothing of the next one. */
const MOST = 4;

export function createCosts(): Costs {
  const known = new Map<StepKind, number>();
  const unit = (kind: StepKind): number => known.get(kind) ?? FIRST[kind];
  const units = (bytes: number): number => 1 + bytes / UNIT;
  return {
    expected: ({ kind, bytes }) => unit(kind) * units(bytes),
    learn({ kind, bytes }, milliseconds) {
      const before = unit(kind);
      const seen = Math.min(milliseconds / units(bytes), MOST * before);
      known.set(kind, before + LEARNT * (seen - before));
    },
  };
}
