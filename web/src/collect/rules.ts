/** Rules of a trial: the published ones, changed by the page's address parameters. */
import type { Vector } from '../control/pose';
import { type Box, MAX_SECONDS, MAX_USERS, type Rules } from './messages';

/** Metres across and along the view of the rectangle of seats; across, up and along it of the box of spheres. */
const [SEAT_AREA, SPHERE_BOX] = [[5, 2], [8, 4, 4]] as const;
/** Offset ahead and up from the centre of the seats to the centre of the box, metres. */
const [DISTANCE, RISE] = [8, 0.5] as const;
const SPEEDS = [0, 0.5, 1.5] as const;

/** Parameters of the address: default value, least and greatest value. */
const PARAMETERS = {
  users: [4, 1, MAX_USERS],
  trials: [3, 1, 255],
  seed: [0, 0, 0xffffffff],
  duration: [180, 1, MAX_SECONDS],
  hold: [2, 0, MAX_SECONDS],
  pause: [1.65, 0, MAX_SECONDS],
  rest: [5, 0, MAX_SECONDS],
  radius: [0.3, 0.01, 1000],
} as const;
const INTEGERS: readonly string[] = ['users', 'trials', 'seed'];

export type RuleParameters = Readonly<Record<keyof typeof PARAMETERS, number>>;

/** Reads the rules `?users=…&hold=…`; returns an error message for an invalid number. */
export function readRules(query: URLSearchParams): RuleParameters | string {
  const values: Record<string, number> = {};
  for (const [name, [defaultValue, least, most]] of Object.entries(PARAMETERS)) {
    const text = query.get(name);
    const value = text === null ? defaultValue : Number(text);
    const isWhole = Number.isInteger(value) || !INTEGERS.includes(name);
    if (text?.trim() === '' || !isWhole || !(value >= least && value <= most))
      return `${name}: expected a ${INTEGERS.includes(name) ? 'whole ' : ''}number from ${least} to ${most}`;
    values[name] = value;
  }
  return values as RuleParameters;
}

/** Rules with seats around a place at eye height, and spheres ahead in the quarter turn nearest to `yaw`. */
export function rulesAt(parameters: RuleParameters, [x, y, z]: Vector, yaw: number): Rules {
  const quarter = Math.round(yaw / (Math.PI / 2));
  const isSideways = quarter % 2 !== 0;
  const [ahead, aside] = [-Math.cos((quarter * Math.PI) / 2), -Math.sin((quarter * Math.PI) / 2)].map(Math.round);
  const [wide, deep] = isSideways ? [SEAT_AREA[1], SEAT_AREA[0]] : SEAT_AREA;
  const [across, high, along] = isSideways ? [SPHERE_BOX[2], SPHERE_BOX[1], SPHERE_BOX[0]] : SPHERE_BOX;
  const middle: Vector = [x + DISTANCE * (aside ?? 0), y + RISE, z + DISTANCE * (ahead ?? 0)];
  return {
    ...parameters,
    speeds: SPEEDS,
    box: boxAround(middle, [across, high, along]),
    area: boxAround([x, y, z], [wide, 0, deep]),
  };
}

function boxAround([x, y, z]: Vector, [wide, high, deep]: Vector): Box {
  return [[x - wide / 2, y - high / 2, z - deep / 2], [x + wide / 2, y + high / 2, z + deep / 2]];
}
