/** Card of the room: names of users, buttons that mute their pointers, state of the connection; arrivals of users. */
import { button, copyText, iconButton, make, toolButton, write } from '../ui/dom';
import { bytes, milliseconds } from '../ui/format';
import { displayName } from './address';
import type { State } from './connection';
import { cssOf } from './meshes';
import type { Guest } from './presence';

/** Icon outlines in a square of 24 units: an arrow, and a ray with its target. */
const ARROW_ICON = 'M5 4l6 15 2.2-6.3L19.5 10.5zM14 14l5 5';
const RAY_ICON = 'M4 20L13 11M17 9a2 2 0 1 0 0-4 2 2 0 0 0 0 4M12 4l1 1M21 11l1 1M20 2l-1 1';

export interface CardCommands {
  mute(number: number, isMuted: boolean): void;
  retry(): void;
  leave(): void;
  /** Link for other users. */
  link(): string;
  announce(text: string): void;
  /** Switches the exchange of files with others. */
  exchange(isOn: boolean): void;
}

/** Facts about the room that the card shows. */
export interface RoomSummary {
  readonly name: string;
  readonly group: number;
  readonly guests: readonly Guest[];
  /** Seconds; null if unknown. */
  readonly roundTrip: number | null;
  /** Bytes of files received from other pages and from the server; null if pages exchange none. */
  readonly files: { readonly others: number; readonly server: number } | null;
  /** Whether the user wants to exchange files; null if there is no choice. */
  readonly wantsExchange: boolean | null;
}

/** Builds the card in the element that holds the panel. */
export function createRoomCard(root: HTMLElement, commands: CardCommands) {
  const chip = make('button', { type: 'button', class: 'chip card here-chip', 'aria-controls': 'here' });
  const list = make('ul', { class: 'here-list' });
  const words = make('p', { class: 'here-words', role: 'status' });
  // Without the role `status`, because screen readers would announce each change.
  const [roundTripLine, sourceLine] = [make('p', { class: 'here-words' }), make('p', { class: 'here-words' })];
  const exchange = createExchange(commands.exchange);
  const joinButton = button('Join again', 'button-main', commands.retry);
  const copyButton = button('Copy link', 'button-main', () => void share());
  const leaveButton = button('Leave', 'button-main', () => {
    commands.leave();
    // The focused button is hidden now.
    chip.focus();
  });
  const card = make(
    'section',
    { class: 'card here', id: 'here', 'aria-label': 'Here', hidden: true },
    make('h2', {}, 'Here'),
    list,
    words,
    roundTripLine,
    sourceLine,
    exchange.element,
    make('div', { class: 'here-actions' }, copyButton, leaveButton, joinButton),
  );
  const corner = make('div', { class: 'here-corner' }, chip, card);
  const title = 'Hold to point at the middle of the picture (E at the cursor)';
  const pointButton = toolButton(ARROW_ICON, 'Point', title, 'E');
  root.querySelector('.top')?.append(corner);
  const bar = root.querySelector('.tools');
  bar?.append(pointButton);
  bar?.classList.add('tools-many');
  chip.addEventListener('click', () => open(card.hidden !== false));
  open(false);
  const rows = new Map<number, Row>();
  const ownRow = createRow();
  let lastState: State | null = null;

  function open(isOpen: boolean): void {
    card.hidden = !isOpen;
    chip.setAttribute('aria-expanded', String(isOpen));
  }

  async function share(): Promise<void> {
    const link = commands.link();
    commands.announce((await copyText(link)) ? 'Link to the room copied' : link);
  }

  function showState(state: State, { roundTrip, files, wantsExchange }: RoomSummary): void {
    write(words, wordsOf(state));
    const isKnown = state.kind === 'here' && roundTrip !== null;
    write(roundTripLine, isKnown ? `Round trip ${milliseconds(1000 * roundTrip)}` : '');
    write(sourceLine, files ? `${bytes(files.others)} from others, ${bytes(files.server)} from the server` : '');
    exchange.show(wantsExchange);
    words.dataset['wrong'] = String(state.kind === 'ended' || state.kind === 'waiting');
    joinButton.hidden = state.kind === 'here' || state.kind === 'joining';
    leaveButton.hidden = state.kind === 'ended';
    // Announced, because the user may not look at the card.
    const lastWords = lastState && 'words' in lastState ? lastState.words : null;
    if (state !== lastState && 'words' in state && state.words !== lastWords) commands.announce(state.words);
    if (state.kind !== 'joining') lastState = state;
  }

  return {
    /** Button that is held to point at the middle of the picture. */
    button: pointButton,
    /** Updates the card, a few times a second. */
    update(state: State, room: RoomSummary): void {
      const isHere = state.kind === 'here';
      write(chip, isHere ? `${room.guests.length + 1} here` : state.kind === 'joining' ? 'Joining' : 'Not connected');
      chip.dataset['wrong'] = String(!isHere && state.kind !== 'joining');
      showState(state, room);
      const numbers = new Set(room.guests.map(({ number }) => number));
      for (const number of rows.keys()) if (!numbers.has(number)) rows.delete(number);
      ownRow.show(`${room.name} (you)`, isHere ? cssOf(state.user) : '', null);
      const guestElements = room.guests.map((guest) => {
        const guestRow = rows.get(guest.number) ?? createRow((isMuted) => commands.mute(guest.number, isMuted));
        rows.set(guest.number, guestRow);
        const suffix = guest.group === room.group ? '' : ' (other group)';
        guestRow.show(`${displayName(guest.name, guest.number)}${suffix}`, cssOf(guest.number), guest.isMuted);
        return guestRow.element;
      });
      arrange(list, [ownRow.element, ...guestElements]);
    },
    /** Shows the reason why there is no room. */
    refuse(reason: string): void {
      write(chip, 'No room');
      write(words, reason);
      chip.dataset['wrong'] = words.dataset['wrong'] = 'true';
      for (const each of [joinButton, leaveButton, copyButton, pointButton]) each.hidden = true;
      commands.announce(reason);
      open(true);
    },
  };
}

type Row = ReturnType<typeof createRow>;

function createRow(mute?: (isMuted: boolean) => void) {
  const dot = make('span', { class: 'here-dot', 'aria-hidden': 'true' });
  const name = make('span', { class: 'here-name' });
  const button = iconButton(RAY_ICON, '', '', () => mute?.(button.getAttribute('aria-pressed') !== 'true'));
  return {
    element: make('li', {}, dot, name, ...(mute ? [button] : [])),
    /** Updates the row; `isMuted` is null for users who cannot be muted. */
    show(text: string, color: string, isMuted: boolean | null): void {
      write(name, text);
      dot.style.setProperty('--color', color);
      const title = `${isMuted ? 'Show' : 'Mute'} the pointer of ${text}`;
      if (isMuted === null || button.title === title) return;
      button.setAttribute('aria-pressed', String(isMuted));
      button.setAttribute('aria-label', title);
      button.title = title;
    },
  };
}

/** Creates the switch for the exchange of files, with its label. */
function createExchange(set: (isOn: boolean) => void) {
  const box = make('input', { type: 'checkbox' });
  const text = make('span', {});
  const element = make('label', { class: 'here-words here-exchange', hidden: true }, box, text);
  let needsReload = false;
  box.addEventListener('change', () => {
    needsReload = box.checked;
    set(box.checked);
  });
  return {
    element,
    /** Shows the state; null hides the element. */
    show(isOn: boolean | null): void {
      element.hidden = isOn === null;
      if (isOn === null) return;
      box.checked = isOn;
      const condition = isOn && needsReload ? ', after the page is reloaded' : '';
      write(text, `Exchange files with other users of the room, who see the address of this device${condition}`);
    },
  };
}

function wordsOf(state: State): string {
  if (state.kind === 'here') return '';
  if (state.kind === 'joining') return 'Joining the room';
  return state.kind === 'waiting' ? `${state.words} Trying again in ${state.seconds} s.` : state.words;
}

/** Reorders children; does not touch children that are in place, so that they keep the focus. */
function arrange(list: HTMLElement, children: readonly HTMLElement[]): void {
  for (const child of [...list.children]) if (!children.some((other) => other === child)) child.remove();
  children.forEach((child, index) => {
    if (list.children[index] !== child) list.insertBefore(child, list.children[index] ?? null);
  });
}

/** Seconds between the first arrival and its announcement, and between two announcements. */
const [GATHER_SECONDS, PAUSE_SECONDS] = [1, 5] as const;

/** Announces arriving users for screen readers; users who arrive together are announced together. */
export function createArrivals(announce: (text: string) => void) {
  const pending = new Map<number, string>();
  let presentCount = 0;
  let [since, last]: [number | null, number] = [null, -Infinity];

  return {
    /** Records a user who has arrived, or who was present when the connection began. */
    add(number: number, name: string): void {
      if (presentCount > 0) presentCount -= 1;
      else pending.set(number, name);
    },
    remove(number: number): void {
      pending.delete(number);
    },
    /** Announces arrivals that are due; called often. */
    announceDue(now: number): void {
      const [name] = pending.values();
      if (name === undefined) {
        since = null;
        return;
      }
      since ??= now;
      if (now < Math.max(since + GATHER_SECONDS, last + PAUSE_SECONDS)) return;
      announce(pending.size === 1 ? `${name} has joined` : `${pending.size} more have joined`);
      pending.clear();
      [since, last] = [null, now];
    },
    /** Begins a new connection; the next `others` users were present before. */
    begin(others: number): void {
      presentCount = others;
      pending.clear();
    },
  };
}
