/** Errors of a store. */
import { messageOf } from '../../base/errors';

/** `gone`: the server has no such file. `refused`: it returns an error. `unreachable`: it does not answer. */
export type Kind = 'gone' | 'refused' | 'unreachable' | 'damaged' | 'newer';

export class StoreError extends Error {
  constructor(readonly kind: Kind, message: string) {
    super(message);
    this.name = 'StoreError';
  }
}

export function damagedError(file: string, reason: string): StoreError {
  return new StoreError('damaged', `${file}: ${reason}`);
}

/** Error as plain data for messages of workers, which cannot clone classes. */
export interface Failure {
  readonly kind: Kind | 'other';
  readonly message: string;
}

export function failureOf(reason: unknown): Failure {
  if (reason instanceof StoreError) return { kind: reason.kind, message: reason.message };
  return { kind: 'other', message: messageOf(reason) };
}

/** Whether a retry may help. */
export function canRetry({ kind }: Failure): boolean {
  return kind === 'refused' || kind === 'unreachable';
}
