/** Shapes of avatars, shared by all of them. */
import { BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, PlaneGeometry, SphereGeometry } from 'three';

/** Number of pieces of a pointer's ribbon: at a length of 100 m each is shorter than a metre. */
const PIECES = 160;
/** Number of vertices around its spot. */
const CORNERS = 20;
/** Radii of a head along its axes, metres. */
const [WIDE, HIGH, LONG] = [0.085, 0.13, 0.105] as const;
/** Metres from the eyes back to the centre of the head. */
const BACK = 0.06;

export interface Shapes {
  readonly head: BufferGeometry;
  /** Visor in front of the eyes, which shows their direction. */
  readonly visor: BufferGeometry;
  readonly hand: BufferGeometry;
  readonly pointer: BufferGeometry;
  readonly name: BufferGeometry;
}

export function createShapes(): Shapes {
  return {
    head: new SphereGeometry(1, 24, 16).scale(WIDE, HIGH, LONG).translate(0, 0, BACK),
    visor: new BoxGeometry(2 * WIDE, 0.07, 0.07).translate(0, 0, BACK - LONG + 0.02),
    hand: new CapsuleGeometry(0.025, 0.1, 4, 12).rotateX(Math.PI / 2).translate(0, 0, 0.05),
    pointer: pointer(),
    name: new PlaneGeometry(1, 1).translate(0, 0.5, 0),
  };
}

function pointer(): BufferGeometry {
  const [places, corners]: [number[], number[]] = [[], []];
  for (let piece = 0; piece <= PIECES; piece++) {
    places.push(piece / PIECES, -1, 0, piece / PIECES, 1, 0);
    const first = 2 * piece;
    if (piece < PIECES) corners.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  const middle = places.length / 3;
  places.push(2, 0, 0);
  for (let corner = 0; corner < CORNERS; corner++) {
    const angle = (2 * Math.PI * corner) / CORNERS;
    places.push(2, Math.cos(angle), Math.sin(angle));
    corners.push(middle, middle + 1 + corner, middle + 1 + ((corner + 1) % CORNERS));
  }
  const made = new BufferGeometry();
  made.setAttribute('position', new BufferAttribute(new Float32Array(places), 3));
  made.setIndex(corners);
  return made;
}
