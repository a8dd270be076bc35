/** Whether the user wants to exchange files with others, kept for all pages of this origin. */

/** Where the choice lies; without an entry the user exchanges files. */
const KEY = 'nearfar peers';

export interface Choice {
  readonly isOn: boolean;
  set(isOn: boolean): void;
}

export function createChoice(storage: () => Storage = () => localStorage): Choice {
  /** Browsers may forbid the storage: the choice holds for this page then. */
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
