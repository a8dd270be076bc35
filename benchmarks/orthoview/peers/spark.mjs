// Spark with SPZ files, one per cell: those of each cut and of its ancestors, coarse ones first.
import { SparkRenderer, SplatMesh } from '@sparkjsdev/spark';
import { camera, job, look, renderer, scene } from './shared.mjs';

/** Maximum number of concurrent requests, which is browsers' number of connections. */
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

/** Returns a cell, or its descendants once all of them are loaded, like tiles that replace their parent. */
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
  /** Number of missing files of the cut. */
  get missing() {
    return wanted.filter((name) => !meshes.has(name)).length;
  },
  get facts() {
    return { cells: meshes.size, splats: spark.activeSplats };
  },
};
