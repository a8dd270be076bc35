/** Commands by key, which the panel runs, and the help with all keys, touch gestures and gamepad controls. */
import { hasOtherPurpose, isMovementKey } from '../control/drive';
import { iconButton, ICONS, make } from './dom';

/** Keys or gestures, and their effect. */
export type Row = readonly [keys: readonly string[], does: string];

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

/** Creates a dialog in `root`; `absent` returns the names of unavailable commands. */
export function createHelp(root: HTMLElement, absent: () => readonly Name[]) {
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
    // Only a click on the backdrop hits the dialog itself.
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
      const missing = absent();
      const names = (Object.keys(SHORTCUTS) as Name[]).filter((name) => !missing.includes(name));
      const rows = names.map((name): Row => [[SHORTCUTS[name].label], SHORTCUTS[name].effect]);
      commands.replaceChildren(...section('Commands', rows).childNodes);
      dialog.showModal();
      dialog.scrollTop = 0;
    },
    add(title: string, rows: readonly Row[]): void {
      last.append(section(title, rows));
    },
  };
}

function section(title: string, rows: readonly Row[]): HTMLElement {
  const list = make('dl', {});
  for (const [keys, does] of rows)
    list.append(make('dt', {}, ...keys.map((key) => make('kbd', {}, key))), make('dd', {}, does));
  return make('section', {}, make('h2', {}, title), list);
}

export type Name = 'walk' | 'orbit' | 'split' | 'photo' | 'link' | 'home' | 'next' | 'look' | 'panel' | 'retry' | 'headset' | 'help';

/** Keys as labelled on the user's keyboard, in lower case; their labels; and the effects. */
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

export function listen(run: (name: Name) => void, keys: EventTarget = window): void {
  const names = new Map(Object.entries(SHORTCUTS).map(([name, { key }]) => [key, name as Name]));
  keys.addEventListener('keydown', (event) => {
    const pressed = event as KeyboardEvent;
    // On some keyboards a command's letter is on a key that moves the user.
    if (hasOtherPurpose(pressed) || pressed.repeat || isMovementKey(pressed.code)) return;
    const name = names.get(pressed.key.toLowerCase());
    if (!name) return;
    pressed.preventDefault();
    run(name);
  });
}
