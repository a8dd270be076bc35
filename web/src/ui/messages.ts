/** Error messages: over the whole page, or in a banner above the picture. */
import { button, find, iconButton, ICONS, make } from './dom';

/** Greatest number of problems that a banner lists; it says how many others there are. */
const MAX_PROBLEMS = 3;

/** For each kind of error without a picture: a title, and advice to the user. */
export const FATAL = {
  scene: {
    title: 'The server cannot load the scene',
    text:
      'Send the message below to the person who runs the server. The page shows the scene when the server has ' +
      'loaded it.',
  },
  place: {
    title: 'The server cannot show this place',
    text:
      'Remove the place from the address of this page, or send the message below to the person who sent you the ' +
      'link.',
  },
  webgl: {
    title: 'This browser cannot draw the scene',
    text:
      'The page needs WebGL 2. Switch on hardware acceleration in the settings of the browser, or open the page in a ' +
      'current Chrome, Edge, Firefox or Safari.',
  },
  damaged: {
    title: 'The scene is damaged',
    text: 'A file does not match the manifest. Export the scene again, or tell the person who sent you the link.',
  },
  newer: {
    title: 'The scene needs a newer nearfar',
    text: 'Its format is newer than this page can read. Update nearfar and reload the page.',
  },
  network: {
    title: 'The scene cannot be reached',
    text: 'The server does not answer, or does not have the scene. Check the connection and the address, and try again.',
  },
  address: {
    title: 'The address has an invalid parameter',
    text: 'Correct or remove the parameters behind the question mark in the address of this page.',
  },
  other: {
    title: 'The scene cannot be shown',
    text: 'Reload the page. If that does not help, send the message below to the person who sent you the link.',
  },
} as const satisfies Readonly<Record<string, { readonly title: string; readonly text: string }>>;

/** Shows over the whole page why there is no picture. `detail` is the exact error; `retry` is what a button does. */
export function showFatal(title: string, text: string, { detail, retry }: { detail: string; retry?: () => void }): void {
  const heading = make('h1', { tabindex: '-1', id: 'message-title' }, title);
  const card = make('div', { class: 'fatal-card' }, make('p', { class: 'fatal-brand' }, 'nearfar'), heading);
  card.append(make('p', {}, text));
  if (detail !== '') card.append(make('p', { class: 'fatal-detail' }, detail));
  if (retry) card.append(button('Try again', 'button-main', retry));
  const element = messageElement();
  element.replaceChildren(card);
  element.dataset['kind'] = 'fatal';
  // The page behind the message takes no clicks and no keys.
  for (const other of document.querySelectorAll('canvas, [data-behind]')) other.setAttribute('inert', '');
  heading.focus({ preventScroll: true });
}

/** Shows problems in a banner above the picture; an empty list removes the banner. */
export function showProblems(problems: readonly string[], retry: () => void): void {
  const element = messageElement();
  if (element.dataset['kind'] === 'fatal') return;
  const list = make('ul', {}, ...problems.slice(0, MAX_PROBLEMS).map((problem) => make('li', {}, problem)));
  if (problems.length > MAX_PROBLEMS) list.append(make('li', {}, `and ${problems.length - MAX_PROBLEMS} more`));
  const close = iconButton(ICONS.close, 'Dismiss', 'Dismiss', clearMessage);
  const text = make('div', { class: 'banner-text' }, make('strong', {}, 'Not all of the scene is shown'), list);
  if (problems.length === 0) clearMessage();
  else {
    element.replaceChildren(text, button('Try again', 'button-main', retry), close);
    element.dataset['kind'] = 'banner';
  }
}

export function clearMessage(): void {
  const element = messageElement();
  element.replaceChildren();
  delete element.dataset['kind'];
  for (const other of document.querySelectorAll('canvas, [data-behind]')) other.removeAttribute('inert');
}

/** Returns the element of messages, which is always in the page, so that screen readers announce its changes. */
function messageElement(): HTMLElement {
  return find('#message', HTMLElement);
}
