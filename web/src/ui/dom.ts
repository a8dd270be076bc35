/** Creation of elements without markup, so that no text of a bundle can become markup. */

type Attributes = Readonly<Record<string, string | boolean | undefined>>;
type Child = Node | string;

/** Creates an element with attributes (true for those without a value) and children; strings become text nodes. */
export function make<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  setAll(made, attributes);
  made.append(...children);
  return made;
}

const SVG = 'http://www.w3.org/2000/svg';

/** Icon of one path in a square of 24 units, in the colour of the surrounding text. */
export function icon(path: string): SVGSVGElement {
  const drawing = document.createElementNS(SVG, 'svg');
  setAll(drawing, { viewBox: '0 0 24 24', class: 'icon', 'aria-hidden': 'true', focusable: 'false' });
  const line = document.createElementNS(SVG, 'path');
  setAll(line, { d: path });
  drawing.append(line);
  return drawing;
}

/** Writes a text only if it differs, to avoid repeated speech of screen readers and new layouts. */
export function write(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

function setAll(element: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) element.setAttribute(name, value === true ? '' : value);
  }
}
