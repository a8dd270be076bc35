// Bundles the page, by default into the Python package, or its tests for Node: node build.mjs [--tests] [FOLDER].
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { relative } from 'node:path';
import { build } from 'esbuild';

const PACKAGE = '../python/nearfar/view/dist';
const common = { bundle: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };

// Removes comments and indentation from shaders, which esbuild does not minify because they are strings.
const shaders = {
  name: 'shaders',
  setup({ onLoad }) {
    onLoad({ filter: /(?:shaders|light)\.ts$/ }, async ({ path }) => {
      const text = await readFile(path, 'utf8');
      return { contents: text.replace(/^[ \t]*\/\/.*\n/gm, '').replace(/^[ \t]+/gm, ''), loader: 'ts' };
    });
  },
};

async function page(folder) {
  await rm(folder, { recursive: true, force: true });
  await mkdir(folder, { recursive: true });
  const { outputFiles } = await build({
    ...common,
    // The page loads `rooms` and `collect` on demand; notebooks load the widget.
    entryPoints: {
      page: 'src/page.ts',
      rooms: 'src/room.ts',
      collect: 'src/collect/start.ts',
      'widget/widget': 'src/widget/widget.ts',
    },
    outdir: folder,
    splitting: true,
    chunkNames: 'shared-[hash]',
    minify: true,
    // Keeps names, so that error reports are readable.
    keepNames: true,
    write: false,
  });
  await writeNamed(outputFiles, folder);
  const single = { ...common, outdir: folder, minify: true, keepNames: true };
  await build({ ...single, entryPoints: { worker: 'src/decode/worker.ts' } });
  const styles = ['src/page.css', 'src/rooms/rooms.css', 'src/collect/collect.css'];
  const flat = { outdir: folder, entryNames: '[name]', bundle: true, minify: true, logLevel: 'warning' };
  await build({ ...flat, entryPoints: styles });
  const widget = { loader: 'src/widget/loader.ts', widget: 'src/widget/widget.css' };
  await build({ ...single, outdir: `${folder}/widget`, entryPoints: widget });
  await orthoview(`${folder}/orthoview`);
}

/** Writes scripts; shared ones get fixed names instead of hashes: shared.js is the largest, then shared2.js and so on. */
async function writeNamed(outputFiles, folder) {
  const named = outputFiles.map(({ path, text }) => ({ name: relative(folder, path), text }));
  const shared = named.filter(({ name }) => name.startsWith('shared-')).sort((a, b) => b.text.length - a.text.length);
  const names = new Map(shared.map(({ name }, at) => [name, `shared${at === 0 ? '' : at + 1}.js`]));
  const renamed = (text) => [...names].reduce((all, [from, to]) => all.replaceAll(from, to), text);
  const texts = new Map(named.map(({ name, text }) => [names.get(name) ?? name, renamed(text)]));
  await mkdir(`${folder}/widget`);
  for (const [name, text] of texts) await writeFile(`${folder}/${name}`, text);
  // The document preloads what the page imports; Python sends notebooks what the widget imports.
  const preloads = importsOf('page.js', texts).map((name) => `    <link rel="modulepreload" href="${name}" />\n`);
  const document = await readFile('src/index.html', 'utf8');
  await writeFile(`${folder}/index.html`, document.replace(/ *<script /, (script) => preloads.join('') + script));
  const scripts = [...importsOf('widget/widget.js', texts), 'widget/widget.js', 'worker.js'];
  await writeFile(`${folder}/widget/scripts.json`, `${JSON.stringify(scripts)}\n`);
}

/** Names of the scripts that a script imports, directly or not, each after its own imports. */
function importsOf(script, texts) {
  const names = [...texts.get(script).matchAll(/\b(?:from|import)"\.\.?\/([\w.-]+)"/g)].map(([, name]) => name);
  return [...new Set(names.flatMap((name) => [...importsOf(name, texts), name]))];
}

/** Bundles the page of trees of orthoviews, which may be copied into the folder of a store. */
async function orthoview(folder) {
  const from = 'src/orthoview';
  await build({
    ...common,
    entryPoints: {
      orthoview: `${from}/page.ts`,
      'orthoview-cut': `${from}/cut/worker.ts`,
      'orthoview-read': `${from}/decode/worker.ts`,
      'orthoview-webgpu': `${from}/draw/webgpu/start.ts`,
    },
    outdir: folder,
    plugins: [shaders],
    minify: true,
    keepNames: true,
  });
  const style = { entryPoints: { orthoview: `${from}/page.css` }, outdir: folder, bundle: true, minify: true };
  await build({ ...style, logLevel: 'warning' });
  await copyFile(`${from}/index.html`, `${folder}/index.html`);
}

/** Bundles each test file, and all.mjs with all of them: one process per file takes longer than the tests. */
async function tests(folder) {
  const names = (await readdir('tests')).filter((name) => name.endsWith('.test.ts'));
  await rm(folder, { recursive: true, force: true });
  const settings = { ...common, platform: 'node', sourcemap: 'inline' };
  const entryPoints = names.map((name) => `tests/${name}`);
  await build({ ...settings, entryPoints, outdir: folder, outExtension: { '.js': '.mjs' } });
  const contents = names.map((name) => `import './${name}';`).join('\n');
  await build({ ...settings, stdin: { contents, resolveDir: 'tests' }, outfile: `${folder}/all.mjs` });
}

const [choice, folder] = process.argv.slice(2);
await (choice === '--tests' ? tests(folder ?? 'build/tests') : page(choice ?? PACKAGE));
