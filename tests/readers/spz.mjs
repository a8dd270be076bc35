// The reference implementation of SPZ (nianticlabs/spz, as WebAssembly): the page reads /job.json and posts to /result the
// arrays of each file. The package does not run in Node.
import { loadSpz } from '@spz-loader/core';

const NAMES = ['positions', 'scales', 'rotations', 'alphas', 'colors'];
const job = await (await fetch('/job.json')).json();

async function read(url) {
  const data = new Uint8Array(await (await fetch(url)).arrayBuffer());
  const cloud = await loadSpz(data, { unpackOptions: { coordinateSystem: 'UNSPECIFIED' } });
  const arrays = Object.fromEntries(NAMES.map((name) => [name, Array.from(cloud[name])]));
  return { count: cloud.numPoints, degree: cloud.shDegree, ...arrays };
}

const files = [];
for (const url of job.files) files.push(await read(url));
await fetch('/result', { method: 'POST', body: JSON.stringify({ files }) });
