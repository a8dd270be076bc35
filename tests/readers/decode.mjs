// meshoptimizer's own decoder on the compressed views of each GLB; prints {file: [each view's bytes in base64]}.
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { MeshoptDecoder } from 'meshoptimizer';

/** Document and binary chunk of a GLB. */
function parts(glb) {
  const length = glb.readUInt32LE(12);
  return { document: JSON.parse(glb.toString('utf8', 20, 20 + length)), chunk: glb.subarray(28 + length) };
}

await MeshoptDecoder.ready;
const views = {};
for (const path of process.argv.slice(2)) {
  const { document, chunk } = parts(await readFile(path));
  const read = async (buffer) => (buffer.uri ? await readFile(join(dirname(path), buffer.uri)) : chunk);
  const buffers = await Promise.all((document.buffers ?? []).map(read));
  views[path] = (document.bufferViews ?? [])
    .map((view) => view.extensions?.EXT_meshopt_compression)
    .filter((stream) => stream)
    .map(({ buffer, byteOffset, byteLength, byteStride, count, mode, filter }) => {
      const decoded = new Uint8Array(count * byteStride);
      const source = buffers[buffer].subarray(byteOffset, byteOffset + byteLength);
      MeshoptDecoder.decodeGltfBuffer(decoded, count, byteStride, source, mode, filter);
      return Buffer.from(decoded).toString('base64');
    });
}
console.log(JSON.stringify(views));
