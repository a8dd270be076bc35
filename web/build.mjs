// Bundles the page into the Python package: `node build.mjs`. With --tests it bundles the unit tests instead, for Node.
import { copyFile, mkdir, readdir, rm } from 'node:fs/promises';
import { build } from 'esbuild';

const DIST = '../python/nearfar/view/dist';
const common = { bundle: true, format: 'esm', target: 'es2022', legalComments: 'none', logLevel: 'warning' };

async function page() {
  await rm(DIST, { recursive: true, force: true });
  await mkdir(DIST, { recursive: true });
  await build({
    ...common,
    entryPoints: { page: 'src/page.ts', worker: 'src/decode/worker.ts' },
    outdir: DIST,
    minify: true,
    // Names in errors that people report.
    keepNames: true,
  });
  await build({ entryPoints: ['src/page.css'], outdir: DIST, bundle: true, minify: true, logLevel: 'warning' });
  await copyFile('src/index.html', `${DIST}/index.html`);
}

async function tests() {
  const entryPoints = (await readdir('tests')).filter((name) => name.endsWith('.test.ts'));
  await rm('build', { recursive: true, force: true });
  await build({
    ...common,
    entryPoints: entryPoints.map((name) => `tests/${name}`),
    outdir: 'build/tests',
    outExtension: { '.js': '.mjs' },
    platform: 'node',
    sourcemap: 'inline',
  });
}

await (process.argv.includes('--tests') ? tests() : page());
