// Bundles the page, or unit tests for Node: node build.mjs [--tests] [FOLDER]. By default the page goes into the package.
import { copyFile, mkdir, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { relative } from 'node:path';
import { build } from 'esbuild';

const PACKAGE = '../python/nearfar/view/dist';
const common = { bundle: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };

// Shaders are strings, of which nothing else takes out comments and indentation.
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
    // The page loads the scripts of rooms and of what users do in them where they are named, notebooks the widget.
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
    // Names in errors that people report.
    keepNames: true,
    write: false,
  });
  await writeNamed(outputFiles, folder);
  const alone = { ...common, outdir: folder, minify: true, keepNames: true };
  await build({ ...alone, entryPoints: { worker: 'src/decode/worker.ts' } });
  const styles = ['src/page.css', 'src/rooms/rooms.css', 'src/collect/collect.css'];
  const flat = { outdir: folder, entryNames: '[name]', bundle: true, minify: true, logLevel: 'warning' };
  await build({ ...flat, entryPoints: styles });
  const widget = { loader: 'src/widget/loader.ts', widget: 'src/widget/widget.css' };
  await build({ ...alone, outdir: `${folder}/widget`, entryPoints: widget });
  await orthoview(`${folder}/orthoview`);
}

/** Scripts that others share get names that stay the same, the largest first. */
async function writeNamed(outputFiles, folder) {
  const named = outputFiles.map(({ path, text }) => ({ name: relative(folder, path), text }));
  const shared = named.filter(({ name }) => name.startsWith('shared-')).sort((a, b) => b.text.length - a.text.length);
  const names = new Map(shared.map(({ name }, at) => [name, `shared${at === 0 ? '' : at + 1}.js`]));
  const renamed = (text) => [...names].reduce((all, [from, to]) => all.replaceAll(from, to), text);
  const texts = new Map(named.map(({ name, text }) => [names.get(name) ?? name, renamed(text)]));
  await mkdir(`${folder}/widget`);
  for (const [name, text] of texts) await writeFile(`${folder}/${name}`, text);
  // The document preloads what the page imports; Python sends notebooks what the widget imports.
  const preloads = imported('page.js', texts).map((name) => `    <link rel="modulepreload" href="${name}" />\n`);
  const document = await readFile('src/index.html', 'utf8');
  await writeFile(`${folder}/index.html`, document.replace(/ *<script /, (script) => preloads.join('') + script));
  const scripts = [...imported('widget/widget.js', texts), 'widget/widget.js', 'worker.js'];
  await writeFile(`${folder}/widget/scripts.json`, `${JSON.stringify(scripts)}\n`);
}

/** Names of the scripts that a script imports, each behind those that it imports itself. */
function imported(script, texts) {
  const names = [...texts.get(script).matchAll(/\b(?:from|import)"\.\.?\/([\w.-]+)"/g)].map(([, name]) => name);
  return [...new Set(names.flatMap((name) => [...imported(name, texts), name]))];
}

/** The page that flies trees of orthoviews: it may lie in a store's folder. */
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

/** Each file of tests as a script, and one script of all: a process for each file takes longer than its tests. */
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
