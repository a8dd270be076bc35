/** The widget's state, which Python shares, as anywidget hands it to a view. */
export interface Model {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  /** Send what was set to Python. */
  save_changes(): void;
  on(event: string, callback: (...args: never[]) => void): void;
  off(event: string, callback: (...args: never[]) => void): void;
  /** Send a message of its own to Python. */
  send(content: unknown): void;
}
