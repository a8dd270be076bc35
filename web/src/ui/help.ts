/** Keys of the panel's commands, and the help, which lists all keys, touch gestures and gamepad controls. */
import { hasOtherPurpose, isMovementKey } from '../control/drive';
import { iconButton, ICONS, make } from './dom';

/** Line of the help: keys or gestures, and what they do. */
export type Row = readonly [keys: readonly string[], effect: string];

const WALK: readonly Row[] = [
  [['W', 'A', 'S', 'D'], 'walk'],
  [['↑', '↓'], 'walk ahead and back'],
  [['←', '→'], 'turn'],
  [['Page ↑', 'Page ↓'], 'look up and down'],
  [['Shift'], 'run'],
  [['Drag'], 'look around'],
  [['Double click'], 'go to a place'],
];

const ORBIT: readonly Row[] = [
  [['Drag'], 'orbit'],
  [['Shift', 'Drag'], 'move; so does the right button'],
  [['Wheel'], 'nearer and farther'],
  [['W', 'S'], 'nearer and farther'],
  [['A', 'D', '←', '→'], 'orbit'],
  [['Shift', 'WASD'], 'move'],
];

const TOUCH: readonly Row[] = [
  [['Left thumb'], 'walk'],
  [['Right thumb'], 'look around'],
  [['Two taps'], 'go to a place'],
  [['One finger'], 'orbit mode: orbit'],
  [['Two fingers'], 'orbit mode: pinch for the distance, drag to move'],
];

const PAD: readonly Row[] = [
  [['Left stick'], 'walk; press it to run'],
  [['Right stick'], 'look around'],
];

/** Creates the help, a dialog in `root`; `unavailable` returns the commands that the help does not list. */
export function createHelp(root: HTMLElement, unavailable: () => readonly Name[]) {
  const close = iconButton(ICONS.close, 'Close', 'Close (Esc)', () => dialog.close());
  const commands = make('section', {});
  const last = make('div', { class: 'help-touch' }, section('Touch', TOUCH), section('Gamepad', PAD));
  const dialog = make(
    'dialog',
    { class: 'help', 'aria-labelledby': 'help-title', tabindex: '-1' },
    make('header', {}, make('h1', { id: 'help-title' }, 'How to move'), close),
    make('div', { class: 'help-parts' }, section('Walk', WALK), section('Orbit', ORBIT), commands, last),
  );
  dialog.addEventListener('click', (event) => {
    // A click inside the dialog has one of its elements as target; a click beside it has the dialog.
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener('keydown', (event) => {
    if (event.key !== '?') return;
    dialog.close();
    event.preventDefault();
  });
  root.append(dialog);

  return {
    toggle(): void {
      if (dialog.open) return dialog.close();
      const omitted = unavailable();
      const names = (Object.keys(SHORTCUTS) as Name[]).filter((name) => !omitted.includes(name));
      const rows = names.map((name): Row => [[SHORTCUTS[name].label], SHORTCUTS[name].effect]);
      commands.replaceChildren(...section('Commands', rows).childNodes);
      dialog.showModal();
      dialog.scrollTop = 0;
    },
    /** Adds a section. */
    add(title: string, rows: readonly Row[]): void {
      last.append(section(title, rows));
    },
  };
}

function section(title: string, rows: readonly Row[]): HTMLElement {
  const list = make('dl', {});
  for (const [keys, effect] of rows)
    list.append(make('dt', {}, ...keys.map((key) => make('kbd', {}, key))), make('dd', {}, effect));
  return make('section', {}, make('h2', {}, title), list);
}

export type Name = 'walk' | 'orbit' | 'split' | 'photo' | 'link' | 'home' | 'next' | 'look' | 'panel' | 'retry' | 'headset' | 'help';

/** For each command: its key on the user's keyboard, in lower case; the label of the key; and what the command does. */
export const SHORTCUTS: Readonly<Record<Name, { readonly key: string; readonly label: string; readonly effect: string }>> = {
  walk: { key: '1', label: '1', effect: 'walk' },
  orbit: { key: '2', label: '2', effect: 'orbit around the point ahead' },
  split: { key: 'c', label: 'C', effect: 'compare with the conventional picture' },
  photo: { key: 'p', label: 'P', effect: 'save the picture' },
  link: { key: 'l', label: 'L', effect: 'copy a link to this view' },
  home: { key: 'home', label: 'Home', effect: 'go back to the centre' },
  next: { key: 'n', label: 'N', effect: 'go to the next place' },
  look: { key: 'f', label: 'F', effect: 'look around with the mouse without a button, until Esc' },
  panel: { key: 'i', label: 'I', effect: 'show or hide the figures' },
  retry: { key: 'r', label: 'R', effect: 'reload what failed' },
  headset: { key: 'v', label: 'V', effect: 'enter the headset, and leave it' },
  help: { key: '?', label: '?', effect: 'show or hide this help' },
};

/** Calls `run` with the command of each key that is pressed. */
export function listenToKeys(run: (name: Name) => void, keys: EventTarget = window): void {
  const names = new Map(Object.entries(SHORTCUTS).map(([name, { key }]) => [key, name as Name]));
  keys.addEventListener('keydown', (event) => {
    const pressed = event as KeyboardEvent;
    // On some keyboards, the letter of a command is on a key that moves the user.
    if (hasOtherPurpose(pressed) || pressed.repeat || isMovementKey(pressed.code)) return;
    const name = names.get(pressed.key.toLowerCase());
    if (!name) return;
    pressed.preventDefault();
    run(name);
  });
}
