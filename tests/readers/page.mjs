// three.js and 3d-tiles-renderer on bundles: the page reads /job.json and posts to /result what they loaded.
import { TilesRenderer } from '3d-tiles-renderer';
import { MeshoptDecoder } from 'meshoptimizer';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

function gltfLoader(manager) {
  return new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder);
}

/** Matrices of all copies of a mesh, mesh→`frame`. */
function placements(mesh, frame) {
  const toFrame = frame.clone().invert().multiply(mesh.matrixWorld);
  if (!mesh.isInstancedMesh) return [toFrame];
  return Array.from({ length: mesh.count }, (_, number) => {
    const copy = new THREE.Matrix4();
    mesh.getMatrixAt(number, copy);
    return toFrame.clone().multiply(copy);
  });
}

/** Triangles, images and exact bounds of what is below an object, in a frame whose matrix to the world is given. */
function measured(object, frame) {
  object.updateWorldMatrix(true, true);
  const box = new THREE.Box3();
  const corner = new THREE.Vector3();
  const names = [];
  let triangles = 0;
  let images = 0;
  object.traverse((mesh) => {
    if (mesh.name) names.push(mesh.userData.name ?? mesh.name);
    if (!mesh.isMesh) return;
    const { position } = mesh.geometry.attributes;
    for (const matrix of placements(mesh, frame)) {
      triangles += mesh.geometry.index.count / 3;
      for (let vertex = 0; vertex < position.count; vertex++) {
        box.expandByPoint(corner.fromBufferAttribute(position, vertex).applyMatrix4(matrix));
      }
    }
    if (mesh.material.map?.image.width > 1) images += 1;
  });
  return { triangles, images, names, bounds: box.isEmpty() ? null : [box.min.toArray(), box.max.toArray()] };
}

async function readFiles(bundle) {
  const files = {};
  for (const uri of bundle.files) {
    const { scene } = await gltfLoader().loadAsync(`${bundle.place}/${uri}`);
    files[uri] = measured(scene, new THREE.Matrix4());
  }
  return files;
}

/** Updates until ten times in turn nothing is left to load and all loaded tiles are visible. */
async function settle(tiles, loaded) {
  const deadline = performance.now() + 60_000;
  let calm = 0;
  while (calm < 10) {
    if (performance.now() > deadline) throw new Error('the tileset does not finish loading');
    tiles.update();
    await new Promise((done) => setTimeout(done, 10));
    const count = tiles.visibleTiles.size;
    calm = tiles.root && tiles.loadProgress === 1 && count > 0 && count === loaded.length ? calm + 1 : 0;
  }
}

/** Materials that show a mesh's own colour, or its normals, whatever the light. */
const UNLIT = {
  color: ({ map, color, vertexColors, alphaTest, side }) =>
    new THREE.MeshBasicMaterial({ map, color, vertexColors, alphaTest, side }),
  normal: ({ flatShading, side }) => new THREE.MeshNormalMaterial({ flatShading, side }),
};

/** Pictures as PNG: lit, of colours alone, and of normals in the camera's axes. */
function pictures(scene, camera, renderer) {
  const shot = () => {
    renderer.render(scene, camera);
    return renderer.domElement.toDataURL('image/png');
  };
  const taken = { lit: shot() };
  const meshes = [];
  scene.traverse((mesh) => mesh.isMesh && meshes.push([mesh, mesh.material]));
  for (const [name, unlit] of Object.entries(UNLIT)) {
    for (const [mesh, material] of meshes) mesh.material = unlit(material);
    taken[name] = shot();
  }
  return taken;
}

async function showTileset(bundle, renderer) {
  const { eye, target, size, angle } = bundle.view;
  renderer.setSize(...size, false);
  const camera = new THREE.PerspectiveCamera(angle, size[0] / size[1], 0.05, 20_000);
  camera.position.fromArray(eye);
  camera.lookAt(...target);
  const tiles = new TilesRenderer(`${bundle.place}/tileset.json`);
  tiles.manager.addHandler(/\.glb$/, gltfLoader(tiles.manager));
  const errors = [];
  const models = [];
  tiles.addEventListener('load-error', ({ error, url }) => errors.push(`${url}: ${error}`));
  tiles.addEventListener('load-model', ({ scene, tile }) => models.push({ scene, tile }));
  const scene = new THREE.Scene().add(tiles.group, new THREE.HemisphereLight(0xffffff, 0x888888, 2));
  const sun = new THREE.DirectionalLight(0xffffff, 1.5);
  sun.position.set(1, 2, 1.5);
  scene.add(sun);
  // Tilesets are z-up, the camera is y-up.
  tiles.group.rotation.x = -Math.PI / 2;
  scene.updateMatrixWorld(true);
  tiles.setCamera(camera);
  tiles.setResolution(camera, ...size);
  await settle(tiles, models);
  const visible = [...tiles.visibleTiles].map((tile) => tile.content.uri);
  const loaded = models.map(({ scene: model, tile }) => ({
    uri: tile.content.uri,
    extras: tile.extras,
    box: tile.boundingVolume.box,
    ...measured(model, tiles.group.matrixWorld),
  }));
  const taken = pictures(scene, camera, renderer);
  tiles.dispose();
  return { errors, visible, tiles: loaded, pictures: taken };
}

const job = await (await fetch('/job.json')).json();
const renderer = new THREE.WebGLRenderer({ alpha: true, preserveDrawingBuffer: true });
const results = {};
for (const bundle of job.bundles) {
  results[bundle.name] = { files: await readFiles(bundle), ...(await showTileset(bundle, renderer)) };
}
await answer(results);
