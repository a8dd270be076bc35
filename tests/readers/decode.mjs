// meshoptimizer's own decoder on the compressed views of each GLB; prints {file: [SHA-256 of each view's bytes]}.
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { MeshoptDecoder } from 'meshoptimizer';

/** Document and binary chunk of a GLB. */
function parts(glb) {
  const length = glb.readUInt32LE(12);
  return { document: JSON.parse(glb.toString('utf8', 20, 20 + length)), chunk: glb.subarray(28 + length) };
}

await MeshoptDecoder.ready;
const hashes = {};
for (const path of process.argv.slice(2)) {
  const { document, chunk } = parts(await readFile(path));
  const read = async (buffer) => (buffer.uri ? await readFile(join(dirname(path), buffer.uri)) : chunk);
  const buffers = await Promise.all((document.buffers ?? []).map(read));
  hashes[path] = (document.bufferViews ?? [])
    .map((view) => view.extensions?.EXT_meshopt_compression)
    .filter((stream) => stream)
    .map(({ buffer, byteOffset, byteLength, byteStride, count, mode, filter }) => {
      const decoded = new Uint8Array(count * byteStride);
      const source = buffers[buffer].subarray(byteOffset, byteOffset + byteLength);
      MeshoptDecoder.decodeGltfBuffer(decoded, count, byteStride, source, mode, filter);
      return createHash('sha256').update(decoded).digest('hex');
    });
}
console.log(JSON.stringify(hashes));
