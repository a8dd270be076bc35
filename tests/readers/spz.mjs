// Prints the arrays of an SPZ file as the reference implementation (nianticlabs/spz, as WebAssembly) reads them.
import { readFileSync } from 'node:fs';
import { loadSpz } from '@spz-loader/core';

const cloud = await loadSpz(readFileSync(process.argv[2]), { unpackOptions: { coordinateSystem: 'UNSPECIFIED' } });
const names = ['positions', 'scales', 'rotations', 'alphas', 'colors'];
const coded = ({ buffer, byteOffset, byteLength }) => Buffer.from(buffer, byteOffset, byteLength).toString('base64');
const arrays = Object.fromEntries(names.map((name) => [name, coded(cloud[name])]));
console.log(JSON.stringify({ count: cloud.numPoints, degree: cloud.shDegree, arrays }));
