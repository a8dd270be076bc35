// zarrita on chunks of a store: `PLACE ARRAY X,Y,Z …`, the place a folder or an address; prints for each the array's shape,
// the name of its type, the chunk's shape and its bytes in base64.
import { decode } from '@cwasm/webp';
import { FileSystemStore } from '@zarrita/storage';
import * as zarr from 'zarrita';

const loadZstd = zarr.registry.get('zstd');
zarr.registry.set('nearfar_webp_view', async () => ({
  fromConfig: (_, { shape }) => ({
    kind: 'array_to_bytes',
    async decode(bytes) {
      const end = 4 + new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
      const rgb = decode(bytes.subarray(4, end)).data.filter((_, place) => place % 4 < 3);
      const zstd = (await loadZstd()).fromConfig({}, {});
      const data = new Uint8Array(shape.at(-1));
      data.set(rgb);
      data.set(await zstd.decode(bytes.subarray(end)), rgb.length);
      return { data, shape, stride: shape.map((_, axis) => shape.slice(axis + 1).reduce((a, b) => a * b, 1)) };
    },
  }),
}));

const [place, ...asked] = process.argv.slice(2);
const store = place.startsWith('http') ? new zarr.FetchStore(place) : new FileSystemStore(place);
const group = await zarr.open.v3(store, { kind: 'group' });
const read = [];
for (let number = 0; number < asked.length; number += 2) {
  const array = await zarr.open.v3(group.resolve(asked[number]), { kind: 'array' });
  const { data, shape } = await array.getChunk([...asked[number + 1].split(',').map(Number), 0]);
  const bytes = Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString('base64');
  read.push({ shape: array.shape, type: array.dtype, chunk: shape, bytes });
}
console.log(JSON.stringify({ attributes: group.attrs, read }));
