// Spark on SPZ files, one a cell: those of each cut and of the cells above it, coarse ones first.
import { SparkRenderer, SplatMesh } from '@sparkjsdev/spark';
import { camera, job, look, renderer, scene } from './shared.mjs';

/** Files that are asked for at once, as many as browsers open connections. */
const AT_ONCE = 6;
const spark = new SparkRenderer({ renderer, autoUpdate: false });
scene.add(spark);
const meshes = new Map();
const loading = new Set();
let wanted = [];
let shown = [];

function fill() {
  for (const name of wanted) {
    if (loading.size >= AT_ONCE) return;
    if (!meshes.has(name) && !loading.has(name)) load(name);
  }
}

async function load(name) {
  loading.add(name);
  const response = await fetch(`/splats/${name}.spz`);
  const mesh = new SplatMesh({ fileBytes: await response.arrayBuffer(), fileType: 'spz', extSplats: true });
  await mesh.initialized;
  mesh.position.fromArray(job.cells[name]);
  mesh.visible = false;
  scene.add(mesh);
  meshes.set(name, mesh);
  loading.delete(name);
  fill();
}

/** A cell's own splats, or those of the cells below once all of these are there, as tiles that replace one another. */
function chosen({ name, below }) {
  if (below.length > 0 && below.every((child) => meshes.has(child.name))) return below.flatMap(chosen);
  return meshes.has(name) ? [name] : [];
}

window.client = {
  see(pose, cut) {
    look(pose);
    wanted = cut.wanted;
    shown = cut.root;
    fill();
  },
  async draw() {
    const visible = new Set(chosen(shown));
    for (const [name, mesh] of meshes) mesh.visible = visible.has(name);
    scene.updateMatrixWorld();
    await spark.update({ scene, camera }); // and sort
    renderer.render(scene, camera);
  },
  /** Files of the cut that are not there. */
  get missing() {
    return wanted.filter((name) => !meshes.has(name)).length;
  },
  get facts() {
    return { cells: meshes.size, splats: spark.activeSplats };
  },
};
