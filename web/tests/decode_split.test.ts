import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Growth } from '../src/decode/messages';
import { splitPlaced } from '../src/decode/split/placed';
import { createRule, TOLERANCE, type Vector } from '../src/decode/split/rule';
import { splitArrays } from '../src/decode/split/triangles';
import { type Arrays, REPEATED } from '../src/decode/surfaces';
import { randomOf } from './support/random';

const CITY: Growth = { radii: [10, 14, 22, 63], nearShare: 0.7, reach: 1 };
const ROOM: Growth = { radii: [1.5, 3], nearShare: 0.7, reach: 1 };
/** Budget of triangles that is not exhausted. */
const ENOUGH = 1e7;

/** Rectangle of two triangles, with texture coordinates and colours. */
function rectangle(corner: Vector, along: Vector, up: Vector): Arrays {
  const shares = [[0, 0], [1, 0], [1, 1], [0, 1]] as const;
  const place = ([s, t]: readonly [number, number]): number[] =>
    corner.map((value, k) => value + s * (along[k] as number) + t * (up[k] as number));
  return {
    positions: Float32Array.from(shares.flatMap(place)),
    normals: null,
    uvs: Float32Array.from(shares.flat()),
    colors: Uint16Array.from(shares.flatMap(([s, t]) => [60000 * s, 60000 * t, 0, 65535])),
    indices: Uint16Array.of(0, 1, 2, 0, 2, 3),
    material: { color: [1, 1, 1, 1], image: null, imageSampler: REPEATED, cutoff: null, emission: null, glow: null,
      glowSampler: REPEATED, isUnlit: false },
  };
}

const GROUND = rectangle([-9000, -1.7, 9000], [18000, 0, 0], [0, 0, -18000]);
const FLOOR = rectangle([-3, -1.6, 2.5], [6, 0, 0], [0, 0, -5]);
const WALL = rectangle([6, -1.7, 5], [0, 0, 75], [0, 20, 0]);

const random = randomOf(1);

function corner({ positions, indices }: Arrays, n: number): Vector {
  const at = 3 * (indices[n] as number);
  return [positions[at] as number, positions[at + 1] as number, positions[at + 2] as number];
}

function mean(points: readonly Vector[], weights: readonly number[]): Vector {
  const sum = (k: number): number => points.reduce((all, p, n) => all + (weights[n] as number) * (p[k] as number), 0);
  return [sum(0), sum(1), sum(2)];
}

/** Displayed position of a point relative to a user, by Eq. 1 to 3 of Popescu et al. */
function displayedPoint(p: Vector, user: Vector, radius: number, nearShare: number, strength: number): Vector {
  const rho = Math.hypot(p[0], p[2]);
  const w = strength * Math.min(Math.max((radius - rho) / (radius * (1 - nearShare)), 0), 1);
  const from = p.map((value, k) => value - (user[k] as number)) as unknown as Vector;
  const [a, b] = [Math.hypot(...from), Math.hypot(...p)];
  const mixed = mean([from, p], [w / a, (1 - w) / b]);
  return mean([mixed], [(w * a + (1 - w) * b) / Math.hypot(...mixed)]);
}

function angle(a: Vector, b: Vector): number {
  const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  return Math.atan2(Math.hypot(...cross), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/** State of the morph, and a user's distance from the centre, metres. */
interface State {
  readonly userDistance: number;
  readonly radius: number;
  readonly strength: number;
}

/** Greatest angle between displayed points of a mesh and the same points on its morphed triangles, in random states. */
function greatestError(mesh: Arrays, growth: Growth, randomState: () => State): number {
  let most = 0;
  const outer = growth.radii.at(-1) ?? 0;
  for (let round = 0; round < 100; round++) {
    const { userDistance, radius, strength } = randomState();
    const turn = 2 * Math.PI * random();
    const user: Vector = [userDistance * Math.cos(turn), 0, userDistance * Math.sin(turn)];
    const place = (p: Vector): Vector => displayedPoint(p, user, radius, growth.nearShare, strength);
    for (let sample = 0; sample < 2000; sample++) {
      const triangle = 3 * Math.floor((random() * mesh.indices.length) / 3);
      const corners = [0, 1, 2].map((n) => corner(mesh, triangle + n));
      const [s, t] = [Math.sqrt(random()), random()];
      const weights = [1 - s, s * (1 - t), s * t];
      const point = mean(corners, weights);
      if (Math.hypot(point[0], point[2]) > outer) continue;
      most = Math.max(most, angle(place(point), mean(corners.map(place), weights)));
    }
  }
  return most;
}

for (const [name, mesh, growth] of [['ground', GROUND, CITY], ['floor', FLOOR, ROOM], ['wall', WALL, CITY]] as const) {
  test(`the error of the split and morphed ${name} is small`, () => {
    const split = splitArrays(mesh, createRule(growth), { triangles: ENOUGH });
    const { radii } = growth;
    const [first, last] = [radii[0] ?? 0, radii.at(-1) ?? 0];
    const stateAtRest = (share: number) => () => {
      const radius = radii[Math.floor(random() * radii.length)] ?? 0;
      return { userDistance: share * radius * random(), radius, strength: 1 };
    };
    // Half a pixel while R rests, for users within a fifth of R; a few pixels while it grows.
    const atRest = greatestError(split, growth, stateAtRest(0.2));
    assert.ok(atRest <= TOLERANCE, `at rest ${atRest}`);
    const reach = Math.min(growth.reach, 0.35 * first);
    const growing = greatestError(split, growth, () => ({
      userDistance: reach,
      radius: first + (last - first) * random(),
      strength: 1,
    }));
    assert.ok(growing <= 8 * TOLERANCE, `growing ${growing}`);
    const weak = greatestError(split, growth, () => ({ userDistance: reach, radius: first, strength: random() }));
    assert.ok(weak <= TOLERANCE, `below full strength ${weak}`);
    // Without splitting the error is large. Too few random points of the ground's two triangles are near to show that.
    if (mesh !== GROUND) assert.ok(greatestError(mesh, growth, stateAtRest(0.2)) > 20 * TOLERANCE);
  });
}

test('no cracks open, and attributes are interpolated linearly', () => {
  for (const [mesh, growth] of [[FLOOR, ROOM], [WALL, CITY]] as const) {
    const split = splitArrays(mesh, createRule(growth), { triangles: ENOUGH });
    const count = split.indices.length / 3;
    assert.ok(count > 1000);
    // Each edge belongs to two triangles, in opposite directions, or lies on the outline of the rectangle.
    const edges = new Map<string, number>();
    let area = 0;
    for (let n = 0; n < split.indices.length; n += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => corner(split, n + k)) as [Vector, Vector, Vector];
      const [u, v] = [mean([b, a], [1, -1]), mean([c, a], [1, -1])];
      area += Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
      for (let k = 0; k < 3; k++) {
        const [i, j] = [split.indices[n + k] as number, split.indices[n + ((k + 1) % 3)] as number];
        edges.set(`${i} ${j}`, (edges.get(`${i} ${j}`) ?? 0) + 1);
      }
    }
    const uv = (vertex: number): readonly number[] => [0, 1].map((k) => split.uvs?.[2 * vertex + k] ?? NaN);
    for (const [edge, times] of edges) {
      const [i, j] = edge.split(' ').map(Number) as [number, number];
      assert.equal(times, 1);
      if (edges.has(`${j} ${i}`)) continue;
      const [p, q] = [uv(i), uv(j)];
      assert.ok([0, 1].some((k) => p[k] === q[k] && (p[k] === 0 || p[k] === 1)), `${edge} ends within the rectangle`);
    }
    // The triangles have the corners 0 1 2 and 0 2 3.
    const [a, b, d] = [0, 1, 5].map((n) => corner(mesh, n)) as [Vector, Vector, Vector];
    const [along, up] = [mean([b, a], [1, -1]), mean([d, a], [1, -1])];
    assert.ok(Math.abs(area / (Math.hypot(...along) * Math.hypot(...up)) - 1) < 1e-5);
    for (let vertex = 0; vertex < split.positions.length / 3; vertex++) {
      const [s = NaN, t = NaN] = uv(vertex);
      for (let k = 0; k < 3; k++) {
        const expected = (a[k] ?? NaN) + s * (along[k] ?? NaN) + t * (up[k] ?? NaN);
        assert.ok(Math.abs((split.positions[3 * vertex + k] ?? NaN) - expected) < 1e-4);
      }
      assert.ok(Math.abs((split.colors?.[4 * vertex] ?? NaN) - 60000 * s) <= 2);
    }
  }
});

test('small and distant triangles are not split', () => {
  const rule = createRule(CITY);
  const small = rectangle([8, 0, 0], [0, 0.05, 0], [0, 0, 0.05]);
  const far = rectangle([70, 0, -500], [0, 0, 1000], [0, 100, 0]);
  const near = rectangle([1, 0, -0.01], [0, 0, 0.02], [0, 0.02, 0]);
  for (const mesh of [small, far, near]) assert.equal(splitArrays(mesh, rule, { triangles: ENOUGH }), mesh);
});

test('near placements are split separately', () => {
  const rule = createRule(CITY);
  const mesh = rectangle([-2, 0, 0], [4, 0, 0], [0, 3, 0]);
  const at = (x: number): number[] => [1, 0, 0, x, 0, 1, 0, -1.7, 0, 0, 1, -1];
  const parts = splitPlaced(mesh, Float32Array.from([at(9), at(400), at(-9)].flat()), rule, { triangles: ENOUGH });
  const [nearPart, farPart, ...none] = parts;
  assert.ok(nearPart && farPart && none.length === 0);
  assert.equal(nearPart.placements, null);
  assert.ok(nearPart.arrays.indices.length > 300);
  const xs = nearPart.arrays.positions.filter((_, n) => n % 3 === 0);
  assert.deepEqual([Math.min(...xs), Math.max(...xs)], [-11, 11]);
  assert.deepEqual(farPart.placements, Float32Array.from(at(400)));
  assert.equal(farPart.arrays.indices.length, 6);
  const far = Float32Array.from([at(400), at(500)].flat());
  assert.deepEqual(splitPlaced(mesh, far, rule, { triangles: ENOUGH }), [{ arrays: mesh, placements: far }]);
});

test('a budget limits the number of triangles, and greater tolerances need fewer', () => {
  const budget = { triangles: 100 };
  splitArrays(GROUND, createRule(CITY), budget);
  assert.ok(budget.triangles < 0);
  const counts = [1, 8, 64].map((factor) => {
    return splitArrays(GROUND, createRule(CITY, factor * TOLERANCE), { triangles: ENOUGH }).indices.length;
  });
  assert.ok((counts[1] ?? 0) < (counts[0] ?? 0) / 4 && (counts[2] ?? 0) < (counts[1] ?? 0) / 4, String(counts));
});
