/** Fakes of browser parts that `src/control` uses and that Node lacks. */

/** Element of 800 × 600 pixels that records captured pointers. */
export interface FakeElement extends HTMLElement {
  readonly captured: Set<number>;
}

export function fakeElement(): FakeElement {
  const captured = new Set<number>();
  const document = { pointerLockElement: null as unknown, exitPointerLock: () => undefined };
  const element = Object.assign(new EventTarget(), {
    captured,
    clientHeight: 600,
    ownerDocument: document,
    setPointerCapture: (id: number) => captured.add(id),
    requestPointerLock: () => {
      document.pointerLockElement = element;
    },
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 800, height: 600 }),
  });
  return element as unknown as FakeElement;
}

/** Dispatches an event with these properties. */
export function send(target: EventTarget, name: string, properties: object = {}): Event {
  const event = Object.assign(new Event(name, { cancelable: true }), properties);
  target.dispatchEvent(event);
  return event;
}

export function press(target: EventTarget, code: string, modifiers: object = {}): Event {
  const defaults = { code, key: code, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false };
  return send(target, 'keydown', { ...defaults, ...modifiers });
}

export function release(target: EventTarget, code: string, modifiers: object = {}): Event {
  return send(target, 'keyup', { code, key: code, shiftKey: false, ...modifiers });
}

/** Dispatches a pointer event at a position: `pointerdown`, `pointermove` or `pointerup`. */
export function point(target: EventTarget, name: string, clientX: number, clientY: number, properties: object = {}): Event {
  const defaults = { pointerId: 1, pointerType: 'mouse', button: 0, shiftKey: false, movementX: 0, movementY: 0 };
  return send(target, name, { ...defaults, clientX, clientY, ...properties });
}
