/** Creates elements and icons without parsing HTML, so that no text of a bundle becomes markup; saves and copies. */

type Attributes = Readonly<Record<string, string | boolean | undefined>>;
type Child = Node | string;

/** Creates an element. The value `true` sets an attribute without a value; strings among the children become text. */
export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  setAttributes(element, attributes);
  element.append(...children);
  return element;
}

export function button(label: string, className: string, action: () => void): HTMLButtonElement {
  const element = make('button', { type: 'button', class: className }, label);
  element.addEventListener('click', action);
  return element;
}

/** Creates a button with an icon; the label is for screen readers. */
export function iconButton(path: string, label: string, title: string, action: () => void): HTMLButtonElement {
  const element = make('button', { type: 'button', class: 'button-icon', 'aria-label': label, title }, icon(path));
  element.addEventListener('click', action);
  return element;
}

/** Creates a button of the bar; the title says what the button does, and its key. */
export function toolButton(path: string, label: string, title: string, key: string): HTMLButtonElement {
  const text = make('span', { class: 'tool-label' }, label);
  return make('button', { type: 'button', class: 'tool', title, 'aria-keyshortcuts': key }, icon(path), text);
}

/** Finds an element of the page; throws an error if there is none of this kind. */
export function find<T extends HTMLElement>(selector: string, kind: abstract new () => T): T {
  const element = document.querySelector(selector);
  if (!(element instanceof kind)) throw new Error(`the page has no ${selector}`);
  return element;
}

const SVG = 'http://www.w3.org/2000/svg';

/** Creates an icon from a path in a square of 24 units, in the colour of the text around it. */
export function icon(path: string): SVGSVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  setAttributes(svg, { viewBox: '0 0 24 24', class: 'icon', 'aria-hidden': 'true', focusable: 'false' });
  const line = document.createElementNS(SVG, 'path');
  setAttributes(line, { d: path });
  svg.append(line);
  return svg;
}

/** Sets a text if it differs; otherwise screen readers would repeat it, and the browser would lay it out again. */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

function setAttributes(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes))
    if (value !== undefined && value !== false) element.setAttribute(name, value === true ? '' : value);
}

export function saveFile(content: Blob, name: string): void {
  const address = URL.createObjectURL(content);
  make('a', { href: address, download: name }).click();
  // The browser reads the address after this call.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Copies a text; returns false if the browser does not allow it. */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text);
  }
}

/** Copies a text by a selection, which also works without https. */
function copyBySelection(text: string): boolean {
  const field = make('textarea', { class: 'unseen', 'aria-hidden': 'true', tabindex: '-1' });
  field.value = text;
  const focusedElement = document.activeElement;
  document.body.append(field);
  field.select();
  const isCopied = document.execCommand('copy');
  field.remove();
  if (focusedElement instanceof HTMLElement) focusedElement.focus({ preventScroll: true });
  return isCopied;
}

/** Paths of the icons, in a square of 24 units. */
export const ICONS = {
  walk: 'M13 4.5a1.5 1.5 0 1 0 0-.01M9.5 21l2-5.5-2-3 1-4.5 3 .5 2 3 2.5 1M7 12.5l.5-3 3-1.5M12.5 13l2.5 3.5.5 4.5',
  orbit: 'M12 14a2 2 0 1 0 0-4 2 2 0 0 0 0 4M17 8c2.5.8 4 2.2 4 4 0 2.8-4 5-9 5s-9-2.2-9-5 4-5 9-5M9.5 4L13 7l-3.5 3',
  split: 'M12 3v18M4 6h5M4 6v12h5M20 6h-5M20 6v12h-5',
  photo: 'M4 8h3.5L9 5.5h6L16.5 8H20v11H4zM12 16.5a3.25 3.25 0 1 0 0-6.5 3.25 3.25 0 0 0 0 6.5',
  link: 'M10 14a4 4 0 0 0 5.7 0l3-3a4 4 0 0 0-5.7-5.7l-1 1M14 10a4 4 0 0 0-5.7 0l-3 3a4 4 0 0 0 5.7 5.7l1-1',
  home: 'M4 11.5L12 5l8 6.5M6 10v9h4v-5h4v5h4v-9',
  next: 'M12 21c-4-4.6-6-7.9-6-10.5a6 6 0 0 1 12 0C18 13.1 16 16.4 12 21M10 8.5l2.5 2-2.5 2',
  panel: 'M4 5h16v14H4zM7 9h6M7 12h10M7 15h8',
  help: 'M9 9a3 3 0 1 1 4.5 2.6c-1 .6-1.5 1.2-1.5 2.4M12 17.5v.01M12 21a9 9 0 1 0 0-18 9 9 0 0 0 0 18',
  headset: 'M3 8.5h18v8h-5.5L13.5 14h-3l-2 2.5H3zM7.5 12v.01M16.5 12v.01',
  close: 'M6 6l12 12M18 6L6 18',
  grip: 'M9 7l-5 5 5 5M15 7l5 5-5 5',
} as const;
