/** Keeps the widget's state equal in the page and in Python, without a message in each frame. */

/** The widget's state, shared with Python; the interface is that of anywidget. */
export interface Model {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  /** Sends changed values to Python. */
  save_changes(): void;
  on(event: string, callback: (...args: never[]) => void): void;
  off(event: string, callback: (...args: never[]) => void): void;
  /** Sends a custom message to Python. */
  send(content: unknown): void;
}

/** Least milliseconds between two messages to Python. */
export const MIN_INTERVAL = 100;

/** Creates an object that sends changes of a view to Python, and passes changes by Python or other views to it. */
export function createMirror(model: Model) {
  const listeners: [event: string, callback: () => void][] = [];
  let lastSent = Number.NEGATIVE_INFINITY;
  let isSending = false;

  return {
    /** Sends the values that differ from Python's; to be called in each frame. */
    send(values: Readonly<Record<string, unknown>>, now: number): void {
      const changed = Object.entries(values).filter(([name, value]) => !isSame(model.get(name), value));
      if (changed.length === 0 || now - lastSent < MIN_INTERVAL) return;
      lastSent = now;
      isSending = true;
      for (const [name, value] of changed) model.set(name, value);
      isSending = false;
      model.save_changes();
    },
    /** Calls `onChange` once for all of these values that Python or another view has changed at the same time. */
    listen(names: readonly string[], onChange: () => void): void {
      let isScheduled = false;
      const callback = (): void => {
        if (isSending || isScheduled) return;
        isScheduled = true;
        queueMicrotask(() => {
          isScheduled = false;
          onChange();
        });
      };
      for (const name of names) {
        listeners.push([`change:${name}`, callback]);
        model.on(`change:${name}`, callback);
      }
    },
    dispose(): void {
      for (const [event, callback] of listeners) model.off(event, callback);
      listeners.length = 0;
    },
  };
}

/** Whether two numbers, texts, or lists of them are equal. */
function isSame(a: unknown, b: unknown): boolean {
  if (!Array.isArray(a) || !Array.isArray(b)) return Object.is(a, b);
  return a.length === b.length && a.every((item, index) => isSame(item, b[index]));
}
