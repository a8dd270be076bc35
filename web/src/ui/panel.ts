/** The panel of figures, the bar of buttons, and their keys. */
import { messageOf } from '../base/errors';
import type { Mode } from '../control/pointers';
import { copyText, iconButton, ICONS, make, saveFile, toolButton, write } from './dom';
import { createHelp, listenToKeys, type Name, SHORTCUTS } from './help';
import { showProblems } from './messages';
import { MIDDLE } from './overlays';
import type { Commands, HeadsetCommand, Status } from './status';
import { createFigures, isComplete, isDelayed, progressText, summaryOf } from './status';

const NOTE_SECONDS = 3;
/** Media query for large screens, where the panel is open at first and still leaves most of the picture free. */
const LARGE_SCREEN = '(min-width: 48rem) and (min-height: 34rem)';

/** Creates the panel in an element that covers the picture; buttons and keys call `commands`. */
export function createPanel(root: HTMLElement, commands: Commands) {
  let isDivided = false;
  let lastRing = -1;
  let wasComplete = false;
  let lastProgress: string | null = null;
  let problems = '';
  let noteTimer = 0;

  const buttons = {
    walk: tool('walk', 'Walk', ICONS.walk),
    orbit: tool('orbit', 'Orbit', ICONS.orbit),
    split: tool('split', 'Split', ICONS.split),
    home: tool('home', 'Home', ICONS.home),
    next: tool('next', 'Next', ICONS.next),
    photo: tool('photo', 'Photo', ICONS.photo),
    link: tool('link', 'Link', ICONS.link),
    panel: tool('panel', 'Info', ICONS.panel),
    help: tool('help', 'Help', ICONS.help),
    headset: tool('headset', 'Enter VR', ICONS.headset),
  };
  const { headset, ...common } = buttons;
  headset.classList.add('tool-main');
  headset.hidden = true;
  buttons.next.hidden = !commands.next;
  const bar = make('div', { class: 'tools', role: 'group', 'aria-label': 'Commands' }, ...Object.values(common));
  bar.classList.toggle('tools-many', commands.next !== undefined);
  const figures = createFigures();
  const close = iconButton(ICONS.close, 'Hide the figures', 'Hide the figures (I)', () => {
    run('panel');
    buttons.panel.focus({ preventScroll: true });
  });
  const headsetNote = make('p', { class: 'quiet', hidden: true });
  const panel = make(
    'section',
    { class: 'panel card', id: 'panel', 'aria-label': 'Figures' },
    make('header', {}, make('h1', {}, 'nearfar'), close),
    figures.element,
    headsetNote,
  );
  const chip = make('button', { type: 'button', class: 'chip card', title: 'Show the figures (I)', hidden: true });
  chip.addEventListener('click', () => run('panel'));
  const loadBar = make('div', {
    class: 'load', role: 'progressbar', 'aria-label': 'Loading', 'aria-valuemin': '0', 'aria-valuemax': '100',
  }, make('span', {}));
  const note = make('p', { class: 'note card', hidden: true });
  const statusLine = make('p', { class: 'unseen', role: 'status' });
  const layer = make(
    'div',
    { class: 'frame', 'data-behind': true },
    make('div', { class: 'top' }, panel, chip),
    make('div', { class: 'bottom' }, note, headset, bar),
  );
  root.append(loadBar, layer, statusLine);
  const help = createHelp(root, () => [
    ...(headsetOf(commands) ? [] : (['headset'] as const)),
    ...(problems ? [] : (['retry'] as const)),
    ...(commands.next ? [] : (['next'] as const)),
  ]);
  panel.hidden = !window.matchMedia(LARGE_SCREEN).matches;
  for (const [name, button] of Object.entries(buttons)) button.addEventListener('click', () => run(name as Name));
  listenToKeys(run);
  updateButtons({ mode: 'walk' });

  function run(name: Name): void {
    // An error is announced, and later commands still work.
    perform(name).catch((reason: unknown) => announce(messageOf(reason)));
  }

  async function perform(name: Name): Promise<void> {
    if (name === 'walk' || name === 'orbit') {
      commands.setMode(name);
      updateButtons({ mode: name });
      speak(name === 'walk' ? 'Walking' : 'Orbiting');
    } else if (name === 'split') {
      updateButtons({ isDivided: !isDivided });
      commands.setDivider(isDivided ? MIDDLE : null);
      speak(isDivided ? 'Left conventional, right continuous' : 'Continuous');
    } else if (name === 'photo') {
      saveFile(await commands.screenshot(), `nearfar ${new Date().toISOString().slice(0, 19).replace(/\D/g, '-')}.png`);
      announce('Picture saved');
    } else if (name === 'link') {
      const link = commands.link();
      if (await copyText(link)) announce('Link copied');
      else {
        history.replaceState(null, '', link);
        announce('The link is in the address bar');
      }
    } else if (name === 'home') commands.home();
    else if (name === 'next') commands.next?.();
    else if (name === 'look') commands.lookAround();
    else if (name === 'panel') {
      panel.hidden = !panel.hidden;
      updateButtons({});
    } else if (name === 'help') help.toggle();
    else if (name === 'retry' && problems) {
      commands.retry();
      // The same error may return before the next update, and must then be shown again.
      problems = '';
      announce('Trying again');
    } else if (name === 'headset') await headsetOf(commands)?.toggle();
  }

  /** Shows the current state on the buttons, possibly with a new mode or divider. */
  function updateButtons({ mode, isDivided: divided }: { readonly mode?: Mode; readonly isDivided?: boolean }): void {
    if (mode) {
      setPressed(buttons.walk, mode === 'walk');
      setPressed(buttons.orbit, mode === 'orbit');
    }
    isDivided = divided ?? isDivided;
    setPressed(buttons.split, isDivided);
    setPressed(buttons.panel, !panel.hidden);
    chip.hidden = !panel.hidden || wasComplete || lastRing < 0;
  }

  /** Shows a short note, which screen readers speak after their current text. */
  function announce(text: string): void {
    write(note, text);
    speak(text);
    note.hidden = false;
    window.clearTimeout(noteTimer);
    noteTimer = window.setTimeout(() => {
      note.hidden = true;
      // Otherwise screen readers would not speak the same note again.
      speak('');
    }, 1000 * NOTE_SECONDS);
  }

  function speak(text: string): void {
    write(statusLine, text);
  }

  function announceChanges(status: Status): void {
    const complete = isComplete(status);
    if (complete && !wasComplete) speak('All rings are shown');
    else if (status.ring !== lastRing) speak(`Ring ${status.ring} of ${status.rings} is shown`);
    [lastRing, wasComplete] = [status.ring, complete];
    const progress = progressText(status);
    const isNewDelay = progress !== null && progress !== lastProgress && isDelayed(status);
    if (isNewDelay) announce(`The place is not ready yet: ${progress}`);
    lastProgress = progress;
    const lines = status.problems.join('\n');
    if (lines !== problems) showProblems(status.problems, () => run('retry'));
    problems = lines;
  }

  function showHeadset(): void {
    const command = headsetOf(commands);
    headset.hidden = !command;
    const label = headset.querySelector('.tool-label');
    if (label) write(label, command?.isPresenting ? 'Leave VR' : 'Enter VR');
    write(headsetNote, typeof commands.headset === 'string' ? commands.headset : '');
    headsetNote.hidden = typeof commands.headset !== 'string';
  }

  return {
    /** Updates the figures; to be called a few times a second. */
    update(status: Status): void {
      announceChanges(status);
      figures.update(status);
      const emptyShare = status.serverProgress ? 0 : 1;
      const loadedShare = status.expected > 0 ? Math.min(status.received / status.expected, 1) : emptyShare;
      loadBar.hidden = wasComplete;
      loadBar.dataset['stuck'] = String(problems !== '');
      loadBar.style.setProperty('--share', loadedShare.toFixed(4));
      loadBar.setAttribute('aria-valuenow', String(Math.floor(100 * loadedShare)));
      write(chip, summaryOf(status));
      showHeadset();
      updateButtons({});
    },
    announce,
    addHelp: help.add,
    updateButtons,
  };
}

/** Creates a button of the bar, with its effect and its key in the title. */
function tool(name: Name, label: string, path: string): HTMLButtonElement {
  const { label: key, effect } = SHORTCUTS[name];
  const title = `${effect.charAt(0).toUpperCase()}${effect.slice(1)} (${key})`;
  return toolButton(path, label, title, key);
}

function headsetOf({ headset }: Commands): HeadsetCommand | null {
  return typeof headset === 'object' ? headset : null;
}

function setPressed(button: HTMLButtonElement, isPressed: boolean): void {
  button.setAttribute('aria-pressed', String(isPressed));
}
