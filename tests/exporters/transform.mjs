// glTF-Transform on each job of a JSON file: [{ from, to, steps: [[name, options], …] }].
import { readFile } from 'node:fs/promises';
import { NodeIO } from '@gltf-transform/core';
import {
  ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression, KHRMeshQuantization,
} from '@gltf-transform/extensions';
import * as functions from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import sharp from 'sharp';

await Promise.all([MeshoptDecoder.ready, MeshoptEncoder.ready]);
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.decoder': await draco3d.createDecoderModule(),
  'draco3d.encoder': await draco3d.createEncoderModule(),
  'meshopt.decoder': MeshoptDecoder,
  'meshopt.encoder': MeshoptEncoder,
});

// Compression is chosen when a file is written, by the extension's own settings.
const compressed = (extension, options) => (document) => {
  document.createExtension(extension).setRequired(true).setEncoderOptions(options);
};
const decoded = (document) => {
  const names = [EXTMeshoptCompression, KHRMeshQuantization].map((extension) => extension.EXTENSION_NAME);
  const used = document.getRoot().listExtensionsUsed();
  for (const extension of used) if (names.includes(extension.extensionName)) extension.dispose();
};
const own = {
  decode: () => decoded,
  draco: (options) => compressed(KHRDracoMeshCompression, options),
  meshopt: (options) => compressed(EXTMeshoptCompression, options),
  reorder: () => functions.reorder({ encoder: MeshoptEncoder }),
  webp: ({ slots, ...options }) =>
    functions.textureCompress({ encoder: sharp, targetFormat: 'webp', slots: new RegExp(slots), ...options }),
};

for (const { from, to, steps } of JSON.parse(await readFile(process.argv[2]))) {
  const document = await io.read(from);
  for (const [name, options] of steps) await document.transform((own[name] ?? functions[name])(options));
  await io.write(to, document);
}
