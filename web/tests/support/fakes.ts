/** Stand-ins for parts of a browser that Node lacks, as far as controls use them. */

/** An element of 800 × 600 pixels that records pointer events and captured pointers. */
export interface FakeElement extends HTMLElement {
  readonly held: Set<number>;
}

export function fakeElement(): FakeElement {
  const held = new Set<number>();
  const document = { pointerLockElement: null as unknown, exitPointerLock: () => undefined };
  const element = Object.assign(new EventTarget(), {
    held,
    clientHeight: 600,
    ownerDocument: document,
    setPointerCapture: (id: number) => held.add(id),
    requestPointerLock: () => {
      document.pointerLockElement = element;
    },
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 800, height: 600 }),
  });
  return element as unknown as FakeElement;
}

/** An event with the properties of its type in a browser. */
export function send(target: EventTarget, name: string, properties: object = {}): Event {
  const event = Object.assign(new Event(name, { cancelable: true }), properties);
  target.dispatchEvent(event);
  return event;
}

export function press(target: EventTarget, code: string, modifiers: object = {}): Event {
  const usual = { code, key: code, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };
  return send(target, 'keydown', { ...usual, ...modifiers });
}

export function letGo(target: EventTarget, code: string, modifiers: object = {}): Event {
  return send(target, 'keyup', { code, key: code, shiftKey: false, ...modifiers });
}

/** A pointer event at a position; `pointerdown`, `pointermove` or `pointerup`. */
export function point(target: EventTarget, name: string, clientX: number, clientY: number, more: object = {}): Event {
  const usual = { pointerId: 1, pointerType: 'mouse', button: 0, shiftKey: false, movementX: 0, movementY: 0 };
  return send(target, name, { ...usual, clientX, clientY, ...more });
}
