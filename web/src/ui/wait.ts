/** Status line before there is a picture or a panel. */
import { make } from './dom';

export interface Wait {
  readonly begin: () => void;
  readonly end: () => void;
}

export function createWait(root: HTMLElement): Wait {
  const line = make('p', { class: 'wait card', role: 'status' }, 'The server loads the scene…');
  return {
    begin: () => root.append(line),
    end: () => line.remove(),
  };
}
