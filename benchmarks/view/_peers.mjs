// Shows a scene as one GLB in three.js (`?glb`), or as 3D Tiles in 3d-tiles-renderer (`?tiles`), and reports when.
import { TilesRenderer } from '3d-tiles-renderer';
import { MeshoptDecoder } from 'meshoptimizer';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const started = performance.now();
const { eye, target, angle } = await (await fetch('view.json')).json();
const renderer = new THREE.WebGLRenderer();
document.body.append(renderer.domElement);
renderer.setSize(innerWidth, innerHeight);
const camera = new THREE.PerspectiveCamera(angle, innerWidth / innerHeight, 0.05, 20_000);
camera.position.fromArray(eye);
camera.lookAt(...target);
const scene = new THREE.Scene().add(new THREE.HemisphereLight(0xffffff, 0x888888, 2));

/** Draws, waits for the GPU to finish, and returns the time in milliseconds. */
function drawn() {
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now();
}

function loader(manager) {
  return new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder);
}

async function glb() {
  scene.add((await loader().loadAsync('scene.glb')).scene);
  return { last: drawn() };
}

async function tileset() {
  const tiles = new TilesRenderer('bundle/tileset.json');
  tiles.manager.addHandler(/\.glb$/, loader(tiles.manager));
  tiles.group.rotation.x = -Math.PI / 2;
  scene.add(tiles.group);
  scene.updateMatrixWorld(true);
  tiles.setCamera(camera);
  tiles.setResolutionFromRenderer(camera, renderer);
  let first = null;
  while (!tiles.root || tiles.loadProgress < 1 || tiles.visibleTiles.size === 0) {
    tiles.update();
    if (first === null && tiles.visibleTiles.size > 0) first = drawn();
    await new Promise((done) => setTimeout(done, 4));
  }
  tiles.update();
  return { first, last: drawn() };
}

window.result = { started, ...(await (location.search === '?glb' ? glb() : tileset())), triangles: renderer.info.render.triangles };
