/** Interface of anywidget to the widget's state, which Python shares. */
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
