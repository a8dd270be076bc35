/** Commands by key; the panel runs them and the help lists them. */
import { isElsewhere, isMoving } from '../control/keys';

export type Name = 'walk' | 'orbit' | 'split' | 'photo' | 'link' | 'home' | 'next' | 'look' | 'panel' | 'retry' | 'headset' | 'help';

export interface Shortcut {
  /** Key in lower case, and its label. */
  readonly key: string;
  readonly label: string;
  readonly does: string;
}

/** Keys as labelled on the user's keyboard. */
export const SHORTCUTS: Readonly<Record<Name, Shortcut>> = {
  walk: { key: '1', label: '1', does: 'walk' },
  orbit: { key: '2', label: '2', does: 'orbit around what lies ahead' },
  split: { key: 'c', label: 'C', does: 'compare with the conventional picture' },
  photo: { key: 'p', label: 'P', does: 'save the picture' },
  link: { key: 'l', label: 'L', does: 'copy a link to this view' },
  home: { key: 'home', label: 'Home', does: 'go back to the centre' },
  next: { key: 'n', label: 'N', does: 'go to the next place' },
  look: { key: 'f', label: 'F', does: 'look around with the mouse without a button, until Esc' },
  panel: { key: 'i', label: 'I', does: 'show or hide the figures' },
  retry: { key: 'r', label: 'R', does: 'load again what failed' },
  headset: { key: 'v', label: 'V', does: 'enter the headset, and leave it' },
  help: { key: '?', label: '?', does: 'show or hide this help' },
};

/** Runs commands by key until the signal aborts. */
export function listen(source: EventTarget, run: (name: Name) => void, signal: AbortSignal): void {
  const names = new Map(Object.entries(SHORTCUTS).map(([name, { key }]) => [key, name as Name]));
  source.addEventListener('keydown', (event) => {
    const pressed = event as KeyboardEvent;
    // On some keyboards a command's letter is on a key that moves the user.
    if (isElsewhere(pressed) || pressed.repeat || isMoving(pressed.code)) return;
    const name = names.get(pressed.key.toLowerCase());
    if (!name) return;
    pressed.preventDefault();
    run(name);
  }, { signal });
}
