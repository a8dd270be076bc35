/** The panel: what is loaded and shown, in a few lines that can be hidden. */
import { megabytes, thousands } from './format';

export interface Status {
  /** Last ring that is shown, and their number; ring 0 is the map alone. */
  readonly ring: number;
  readonly rings: number;
  /** R, metres. */
  readonly radius: number;
  /** Bytes that have come, and that the region takes. */
  readonly received: number;
  readonly expected: number;
  /** Triangles of the picture, and of the scene. */
  readonly triangles: number;
  readonly whole: number;
  /** Milliseconds from frame to frame. */
  readonly frame: number;
}

/** A function that fills the panel's lines; the elements are those of index.html. */
export function createPanel(panel: HTMLElement): (status: Status) => void {
  const lines = new Map([...panel.querySelectorAll('dd')].map((line) => [line.id, line]));
  const bar = panel.querySelector('progress');
  const put = (id: string, text: string): void => {
    const line = lines.get(id);
    // Screen readers speak of what changes, so only what changes is written.
    if (line && line.textContent !== text) line.textContent = text;
  };
  return (status) => {
    const { ring, rings, radius, received, expected, triangles, whole, frame } = status;
    put('rings', ring === 0 ? `the map; ${rings} rings follow` : `${ring} of ${rings}, to ${radius.toFixed(1)} m`);
    put('loaded', `${megabytes(received)} of ${megabytes(expected)}`);
    put('drawn', `${thousands(triangles)} of ${thousands(whole)} triangles`);
    put('frame', `${frame.toFixed(0)} ms`);
    if (bar) {
      bar.max = Math.max(expected, received, 1);
      bar.value = received;
      bar.hidden = ring === rings && received >= expected;
    }
  };
}
