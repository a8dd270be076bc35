// Khronos' gltf-validator on each file; prints {file: {errors, warnings, messages}}.
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { validateBytes } from 'gltf-validator';

const reports = {};
for (const path of process.argv.slice(2)) {
  const { issues } = await validateBytes(new Uint8Array(await readFile(path)), {
    uri: path,
    maxIssues: 0,
    externalResourceFunction: async (uri) => new Uint8Array(await readFile(join(dirname(path), uri))),
  });
  reports[path] = issues;
}
console.log(JSON.stringify(reports));
