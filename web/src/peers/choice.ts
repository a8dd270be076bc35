/** User's choice whether to exchange files, stored for all pages of this origin. */

/** Key of the choice in the storage; without an entry files are exchanged. */
const KEY = 'nearfar peers';

export interface Choice {
  readonly isOn: boolean;
  set(isOn: boolean): void;
}

export function createChoice(storage: () => Storage = () => localStorage): Choice {
  /** Accesses the storage, which browsers may forbid; the choice then holds for this page only. */
  function attempt<Result>(action: (storage: Storage) => Result): Result | null {
    try {
      return action(storage());
    } catch {
      return null;
    }
  }

  let isOn = attempt((found) => found.getItem(KEY)) !== 'off';
  return {
    get isOn() {
      return isOn;
    },
    set(wanted) {
      isOn = wanted;
      attempt((found) => (wanted ? found.removeItem(KEY) : found.setItem(KEY, 'off')));
    },
  };
}
