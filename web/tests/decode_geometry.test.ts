import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { type Buffers, type Decoded, decodeGeometry } from '../src/decode/geometry';
import { REPEATED } from '../src/decode/surfaces';
import { openGlb } from '../src/decode/glb';
import type { GeometryRequest } from '../src/decode/messages';
import { type Arrays, createArrays, documentOf, fileOf, glbOf, type Json, NAME, requestOf } from './support/glb';
import { replaceAt } from './support/manifest';
import { randomOf } from './support/random';

before(() => MeshoptEncoder.ready);

const POSITIONS = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
const CORNERS = Uint16Array.of(0, 1, 2, 1, 3, 2);

/** A square of two triangles with all attributes. */
function square(arrays: Arrays): Json {
  const attributes = {
    POSITION: arrays.add(POSITIONS, 3),
    NORMAL: arrays.add(Int8Array.of(0, 0, 127, 0, 0, -128, 64, 0, 64, 0, 0, 0), 3, 4),
    TEXCOORD_0: arrays.add(Float32Array.of(0, 0, 1, 0, 0, 1, 1, 1), 2),
    COLOR_0: arrays.add(Uint16Array.from({ length: 16 }, (_, n) => 4000 * n), 4),
  };
  return { attributes, indices: arrays.add(CORNERS, 1) };
}

function decode(document: Json, arrays: Arrays, changes: Partial<GeometryRequest> = {}): Promise<Decoded> {
  return decodeGeometry(requestOf(glbOf(document, arrays.chunk()), changes), new Map());
}

const PLAIN = { color: [1, 1, 1, 1], image: null, imageSampler: REPEATED, cutoff: null, emission: null, glow: null,
  glowSampler: REPEATED, isUnlit: false } as const;

test('all attributes of a primitive are decoded', async () => {
  const arrays = createArrays();
  const geometry = await decode(documentOf(arrays, square(arrays), [{ mesh: 0 }]), arrays);
  assert.deepEqual(geometry.triangles, { inFile: 2, drawn: 2 });
  const [piece, ...others] = geometry.pieces;
  assert.ok(piece && others.length === 0);
  assert.deepEqual(piece.positions, POSITIONS);
  const half = Math.fround(Math.SQRT1_2);
  assert.deepEqual(piece.normals, Float32Array.of(0, 0, 1, 0, 0, -1, half, 0, half, 0, 0, 0));
  assert.deepEqual(piece.uvs, Float32Array.of(0, 0, 1, 0, 0, 1, 1, 1));
  assert.deepEqual(piece.colors?.slice(0, 3), Uint16Array.of(0, 4000, 8000));
  assert.deepEqual(piece.indices, CORNERS);
  assert.equal(piece.placements, null);
  assert.deepEqual(piece.material, { ...PLAIN, color: [0.5, 0.25, 1, 1] });
});

test('far from the origin of the world positions are rounded once', async () => {
  const arrays = createArrays();
  const indices = arrays.add(CORNERS, 1);
  const primitive = { attributes: { POSITION: arrays.add(POSITIONS.map((value) => value / 1024), 3) }, indices };
  const root = { translation: [5_000_000.25, -3.5, 1e7 + 1 / 16] };
  const document = documentOf(arrays, primitive, [{ mesh: 0 }], root);
  const { pieces } = await decode(document, arrays, { center: [5_000_000, -3, 1e7] });
  const expected = Float32Array.of(0.25, -0.5, 1 / 16, 0.25 + 1 / 1024, -0.5, 1 / 16);
  assert.deepEqual(pieces[0]?.positions.slice(0, 6), expected);
});

test('placements by nodes and by arrays form one piece; dynamic objects stay separate', async () => {
  const arrays = createArrays();
  const primitive = square(arrays);
  const turn = Math.fround(Math.SQRT1_2);
  const attributes = {
    TRANSLATION: arrays.add(Float32Array.of(1, 2, 3, 4, 5, 6), 3),
    ROTATION: arrays.add(Float32Array.of(0, 0, 0, 1, 0, turn, 0, turn), 4),
    SCALE: arrays.add(Float32Array.of(1, 1, 1, 2, 3, 4), 3),
  };
  const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0.5, 0, 1, 0, 7, 8, 9, 1];
  const copies = { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes } } };
  const nodes = [{ mesh: 0, matrix, name: 'sheared' }, copies];
  const document = documentOf(arrays, primitive, nodes, { translation: [100, 0, 0] });
  const staticGeometry = await decode(document, arrays, { center: [90, 0, 0] });
  assert.equal(staticGeometry.pieces.length, 1);
  assert.deepEqual(staticGeometry.triangles, { inFile: 6, drawn: 6 });
  const expected = [
    [1, 0, 0.5, 17, 0, 1, 0, 8, 0, 0, 1, 9],
    [1, 0, 0, 11, 0, 1, 0, 2, 0, 0, 1, 3],
    // A quarter turn about y maps x to −z, and z to x.
    [0, 0, 4, 14, 0, 3, 0, 5, -2, 0, 0, 6],
  ].flat();
  const found = staticGeometry.pieces[0]?.placements;
  assert.equal(found?.length, expected.length);
  found?.forEach((value, n) => assert.ok(Math.abs(value - (expected[n] ?? NaN)) < 1e-6, `${n}: ${value}`));
  const { pieces } = await decode(document, arrays, { isDynamic: true });
  const dynamicPieces = pieces.map(({ name, placements }) => [name, placements?.length]);
  assert.deepEqual(dynamicPieces, [['sheared', 12], ['', 24]]);
});

test('hundreds of thousands of placements form one piece', async () => {
  const arrays = createArrays();
  const count = 300_000;
  const primitive = square(arrays);
  const attributes = { TRANSLATION: arrays.add(Float32Array.from({ length: 3 * count }, (_, n) => n % 3000), 3) };
  const nodes = [{ mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes } } }, { mesh: 0 }];
  const { pieces, triangles } = await decode(documentOf(arrays, primitive, nodes), arrays);
  assert.equal(triangles.inFile, 2 * (count + 1));
  assert.deepEqual(pieces.map(({ placements }) => placements?.length), [12 * (count + 1)]);
});

test('large meshes are split into parts with the same triangles', async () => {
  const side = 150;
  const positions = new Float32Array(3 * side * side).map((_, n) => {
    const vertex = Math.floor(n / 3);
    return n % 3 === 0 ? vertex % side : n % 3 === 1 ? Math.floor(vertex / side) : 0;
  });
  const corners: number[] = [];
  for (let y = 0; y + 1 < side; y++) {
    for (let x = 0; x + 1 < side; x++) {
      const a = y * side + x;
      corners.push(a, a + 1, a + side, a + 1, a + side + 1, a + side);
    }
  }
  for (const isPacked of [false, true]) {
    const arrays = createArrays();
    const indices = Uint32Array.from(corners);
    const primitive = isPacked
      ? [arrays.pack(positions, 3, 'ATTRIBUTES'), arrays.pack(indices, 1, 'TRIANGLES')]
      : [arrays.add(positions, 3), arrays.add(indices, 1)];
    const [POSITION, corner] = primitive;
    const document = documentOf(arrays, { attributes: { POSITION }, indices: corner }, [{ mesh: 0 }]);
    const { pieces } = await decode(document, arrays);
    assert.equal(pieces.length, Math.ceil(corners.length / 3 / 32_768));
    const found = pieces.flatMap((piece) => {
      assert.ok(piece.indices.length <= 3 * 32_768);
      assert.equal(new Set(piece.indices).size, piece.positions.length / 3);
      return Array.from(piece.indices, (vertex) => {
        return side * (piece.positions[3 * vertex + 1] ?? NaN) + (piece.positions[3 * vertex] ?? NaN);
      });
    });
    // The codec may rotate a triangle's corners.
    assert.equal(leastCornerFirst(found), leastCornerFirst(corners));
  }
});

/** Triangles as text, rotated so that each begins at its least corner. */
function leastCornerFirst(corners: number[]): string {
  return Array.from({ length: corners.length / 3 }, (_, n) => {
    const triangle = corners.slice(3 * n, 3 * n + 3);
    const least = triangle.indexOf(Math.min(...triangle));
    return [...triangle.slice(least), ...triangle.slice(0, least)].join(' ');
  }).join();
}

test('buffers are cached for later requests, even if another part is damaged', async () => {
  const arrays = createArrays();
  const primitive = square(arrays);
  const uri = '00000000000000bb.bin';
  const document = replaceAt(documentOf(arrays, primitive, [{ mesh: 0 }]), ['buffers', 0, 'uri'], uri);
  const data = glbOf(document, new Uint8Array());
  const part = fileOf(`files/${uri}`, Uint8Array.from(arrays.chunk()));
  const wrong = { ...fileOf('files/00000000000000cc.bin', Uint8Array.of(1, 2)), sha256: 'f'.repeat(64) };
  const buffers: Buffers = new Map();
  await assert.rejects(decodeGeometry(requestOf(data), buffers), /the buffer 00000000000000bb\.bin is missing/);
  const damaged = decodeGeometry(requestOf(data, { parts: [wrong, part] }), buffers);
  await assert.rejects(damaged, /files\/0+cc\.bin: expected SHA-256/);
  assert.equal((await decodeGeometry(requestOf(data), buffers)).triangles.inFile, 2);
});

test('cut-outs, and textures that the page already has', async () => {
  const arrays = createArrays();
  const uri = '00000000000000dd.webp';
  const surface = { baseColorTexture: { index: 0 } };
  const document = {
    ...documentOf(arrays, square(arrays), [{ mesh: 0 }]),
    materials: [{ pbrMetallicRoughness: surface, alphaMode: 'MASK', alphaCutoff: 0.25 }],
    textures: [{ sampler: 1, extensions: { EXT_texture_webp: { source: 0 } } }],
    samplers: [{}, { wrapS: 33071, wrapT: 33648, magFilter: 9728 }],
    images: [{ uri }],
  };
  const { pieces } = await decode(document, arrays, { known: [`files/${uri}`] });
  assert.deepEqual(pieces[0]?.material, {
    ...PLAIN, image: `files/${uri}`, imageSampler: [33071, 33648, 9728], cutoff: 0.25,
  });
  const wrong = replaceAt(document, ['samplers', 1, 'wrapS'], 1) as Json;
  await assert.rejects(decode(wrong, arrays, { known: [`files/${uri}`] }), /samplers with glTF's codes/);
  await assert.rejects(decode(document, arrays), /^Error: files\/00000000000000dd\.webp is missing$/);
  const outside = replaceAt(document, ['images', 0, 'uri'], '../../secret.webp') as Json;
  await assert.rejects(decode(outside, arrays), /pictures that are files of the bundle/);
});

test('emission and unlit materials', async () => {
  const arrays = createArrays();
  const uri = '00000000000000ee.webp';
  const strength = { KHR_materials_emissive_strength: { emissiveStrength: 4 } };
  const document = {
    ...documentOf(arrays, square(arrays), [{ mesh: 0 }]),
    materials: [{ emissiveFactor: [0.5, 1, 0], emissiveTexture: { index: 0 }, extensions: strength }],
    textures: [{ extensions: { EXT_texture_webp: { source: 0 } } }],
    images: [{ uri }],
  };
  const known = { known: [`files/${uri}`] };
  const materialOf = async (path: readonly (string | number)[], value: unknown) =>
    (await decode(replaceAt(document, ['materials', 0, ...path], value) as Json, arrays, known)).pieces[0]?.material;
  assert.deepEqual(await materialOf(['name'], 'lamp'), { ...PLAIN, emission: [2, 4, 0], glow: `files/${uri}` });
  assert.deepEqual(await materialOf(['emissiveFactor'], [0, 0, 0]), PLAIN);
  assert.deepEqual(await materialOf(['extensions'], { KHR_materials_unlit: {} }), { ...PLAIN, isUnlit: true });
  for (const wrong of [[1, 1], [1, 1, 1, 1], [0, -1, 0], [0, 'x', 0]]) {
    await assert.rejects(materialOf(['emissiveFactor'], wrong), /emission of three finite numbers/);
  }
});

test('errors name the damaged file', async () => {
  const arrays = createArrays();
  const primitive = square(arrays);
  const bad = arrays.add(Float32Array.of(0, NaN, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), 3);
  const [TRANSLATION, SCALE] = [arrays.add(Float32Array.of(1, 2, 3), 3), arrays.add(new Float32Array(6), 3)];
  const document = documentOf(arrays, primitive, [{ mesh: 0 }]);
  const instances = { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION, SCALE } } } };
  const mesh = ['meshes', 0, 'primitives', 0] as const;
  const changes: [path: readonly (string | number)[], value: unknown, message: RegExp][] = [
    [['nodes'], 3, /list of nodes/],
    [['nodes', 1], null, /list of nodes/],
    [['nodes', 1, 'mesh'], 7, /mesh 7 is missing/],
    [['nodes', 1, 'mesh'], '__proto__', /mesh __proto__ is missing/],
    [['nodes', 1, 'matrix'], [1, 2], /16 numbers/],
    [['nodes', 1, 'matrix'], Array(16).fill('x'), /finite/],
    [['nodes', 1], instances, /of one length/],
    [['nodes', 0, 'translation'], ['x', 0, 0], /origin/],
    [['meshes', 0, 'primitives'], {}, /list of primitives/],
    [[...mesh, 'material'], 1, /material 1/],
    [[...mesh, 'indices'], undefined, /accessor's number is missing/],
    [[...mesh, 'attributes', 'POSITION'], bad, /finite/],
    [[...mesh, 'attributes', 'POSITION'], 4, /3 columns/],
    [['accessors', 0, 'count'], 3, /indices below 3/],
    [['accessors', 0, 'count'], 5, /beyond its array/],
    [['accessors', 0, 'count'], 1e15, /accessor 0/],
    [['accessors', 0, 'count'], -1, /accessor 0/],
    [['accessors', 0, 'byteOffset'], -12, /accessor 0/],
    [['accessors', 0, 'componentType'], 5130, /accessor 0/],
    [['accessors', 1, 'count'], 3, /attributes of 4 vertices/],
    [['accessors', 3, 'componentType'], 5126, /rows of 16 bytes/],
    [['accessors', 4, 'count'], 5, /triangles/],
    [['bufferViews', 0, 'byteStride'], 0, /rows of 12 bytes/],
    [['bufferViews', 0, 'byteOffset'], 1e9, /beyond the file/],
    [['bufferViews', 0, 'byteLength'], 2 ** 53, /beyond the file/],
    [['bufferViews', 0, 'buffer'], 3, /buffer 3/],
    [['materials', 0, 'pbrMetallicRoughness', 'baseColorFactor'], [1, 'x', 1, 1], /finite/],
    [['images'], [{}], /pictures that are files/],
  ];
  for (const [path, value, message] of changes) {
    await assert.rejects(decode(replaceAt(document, path, value) as Json, arrays), (error: Error) => {
      assert.ok(error.message.startsWith(`${NAME}: `), error.stack);
      assert.match(error.message, message);
      return true;
    });
  }
  for (const data of [new Uint8Array(8), glbOf('[', new Uint8Array()), glbOf('null', new Uint8Array())]) {
    await assert.rejects(decodeGeometry(requestOf(data), new Map()), /expected a gl/i);
  }
});

test('compressed arrays with impossible sizes are rejected before allocation', async () => {
  const arrays = createArrays();
  const attributes = { POSITION: arrays.pack(POSITIONS, 3, 'ATTRIBUTES') };
  const document = documentOf(arrays, { attributes, indices: arrays.add(CORNERS, 1) }, [{ mesh: 0 }]);
  assert.equal((await decode(document, arrays)).triangles.inFile, 2);
  const packed = ['bufferViews', 0, 'extensions', 'EXT_meshopt_compression'] as const;
  const changes: [name: string, value: unknown, message: RegExp][] = [
    ['count', 2 ** 26, /compressed bytes claim/],
    ['count', -4, /claim/],
    ['byteStride', 2 ** 31, /claim/],
    ['byteStride', 6, /cannot be ATTRIBUTES/],
    ['byteStride', 0, /claim/],
    ['mode', 'constructor', /cannot be constructor/],
    ['filter', 'toString', /no filter toString/],
    ['filter', 'OCTAHEDRAL', /no filter OCTAHEDRAL/],
    ['byteLength', 12, /expected a compressed array/],
  ];
  for (const [name, value, message] of changes) {
    await assert.rejects(decode(replaceAt(document, [...packed, name], value) as Json, arrays), message);
  }
});

test('many descriptions of one array do not fill the memory', async () => {
  const arrays = createArrays();
  const corners = arrays.add(new Uint32Array(100), 1);
  const glb = openGlb(glbOf(arrays.lists(), arrays.chunk()), new Map(), 1000);
  await glb.read(corners, 1);
  await glb.read(corners, 1);
  await assert.rejects(glb.read(corners, 1), /the arrays take more than 1000 bytes/);
});

test('files with wrong bytes are decoded, or rejected with a message that names the file', async () => {
  const arrays = createArrays();
  const attributes = { POSITION: arrays.pack(POSITIONS, 3, 'ATTRIBUTES') };
  const primitive = { ...square(arrays), attributes };
  const whole = glbOf(documentOf(arrays, primitive, [{ mesh: 0 }]), arrays.chunk());
  const unit = randomOf(1);
  const random = (below: number): number => Math.floor(unit() * below);
  let rejectedCount = 0;
  for (let round = 0; round < 500; round++) {
    const data = whole.slice(0, random(8) === 0 ? random(whole.length) : whole.length);
    for (let n = 0; n <= random(3); n++) data[random(data.length)] = random(256);
    try {
      await decodeGeometry(requestOf(data), new Map());
    } catch (error) {
      rejectedCount += 1;
      assert.ok(error instanceof Error && error.message.startsWith(`${NAME}: `), String(error));
      assert.doesNotMatch(error.message, /undefined is not|Cannot read|not iterable|not a function|Invalid typed/);
    }
  }
  assert.ok(rejectedCount > 100, `${rejectedCount}`);
});
