// 3d-tiles-renderer on tilesets: prints {file: {errors, tiles: [uri, box, bounds and triangles of each content]}}.
import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { TilesRenderer } from '3d-tiles-renderer/three';
import { ImplicitTilingPlugin } from '3d-tiles-renderer/core/plugins';
import { MeshoptDecoder } from 'meshoptimizer';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const PLACE = 'http://files';
globalThis.window ??= { location: { href: PLACE } };
globalThis.requestAnimationFrame ??= (callback) => setTimeout(callback, 0);
globalThis.cancelAnimationFrame ??= clearTimeout;

/** Reads what the renderer asks for from files. */
const fromFiles = {
  name: 'FILES',
  priority: -Infinity,
  async fetchData(url) {
    return new Response(await readFile(decodeURIComponent(new URL(url).pathname)));
  },
};

/** Bounds, turned as the tileset's axes, and triangles of a content. */
function measured(scene) {
  scene.updateMatrixWorld(true);
  const box = new THREE.Box3();
  const [corner, copy] = [new THREE.Vector3(), new THREE.Matrix4()];
  let triangles = 0;
  scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const { position } = mesh.geometry.attributes;
    for (let number = 0; number < (mesh.isInstancedMesh ? mesh.count : 1); number++) {
      if (mesh.isInstancedMesh) mesh.getMatrixAt(number, copy);
      const matrix = mesh.matrixWorld.clone().multiply(copy);
      for (let vertex = 0; vertex < position.count; vertex++) {
        box.expandByPoint(corner.fromBufferAttribute(position, vertex).applyMatrix4(matrix));
      }
      triangles += mesh.geometry.index.count / 3;
    }
  });
  return { triangles, bounds: [box.min.toArray(), box.max.toArray()] };
}

async function show(path) {
  const tiles = new TilesRenderer(PLACE + resolve(path));
  tiles.registerPlugin({ ...fromFiles });
  tiles.registerPlugin(new ImplicitTilingPlugin());
  tiles.manager.addHandler(/\.glb$/, new GLTFLoader(tiles.manager).setMeshoptDecoder(MeshoptDecoder));
  // A viewer far above everything that looks down, with so many pixels that each tile is many of them large.
  const camera = new THREE.OrthographicCamera(-1e5, 1e5, 1e5, -1e5, 0, 1e6);
  camera.position.set(0, 0, 5e5);
  camera.updateMatrixWorld(true);
  tiles.setCamera(camera);
  tiles.setResolution(camera, 1e6, 1e6);
  const errors = [];
  const found = [];
  tiles.addEventListener('load-error', ({ error, url }) => errors.push(`${url}: ${error}`));
  tiles.addEventListener('load-model', ({ scene, tile }) => {
    found.push({ uri: tile.content.uri, box: tile.boundingVolume.box, extras: tile.extras, ...measured(scene) });
  });
  const deadline = performance.now() + 60_000;
  let calm = 0;
  while (calm < 10 && errors.length === 0) {
    if (performance.now() > deadline) throw new Error('the tileset does not finish loading');
    tiles.update();
    await new Promise((done) => setTimeout(done, 10));
    calm = tiles.root && tiles.loadProgress === 1 && tiles.visibleTiles.size === found.length ? calm + 1 : 0;
  }
  const visible = [...tiles.visibleTiles].filter((tile) => tile.content).map((tile) => tile.content.uri);
  tiles.dispose();
  return { errors, visible, tiles: found };
}

await MeshoptDecoder.ready;
const shown = {};
for (const path of process.argv.slice(2)) shown[path] = await show(path);
console.log(JSON.stringify(shown));
process.exit(0);
