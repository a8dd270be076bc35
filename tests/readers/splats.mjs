// Spark on files of splats: the page reads /job.json, draws pictures and posts to /result what it saw of the files.
import { SparkRenderer, SplatMesh } from '@sparkjsdev/spark';
import * as THREE from 'three';

const job = await (await fetch('/job.json')).json();

/** The first splats of a mesh, as the loader decoded them. */
function first(mesh, count) {
  const rows = [];
  mesh.forEachSplat((index, center, scales, quaternion, opacity, color) => {
    if (index < count) {
      rows.push([...center.toArray(), ...scales.toArray(), ...quaternion.toArray(), opacity, ...color.toArray()]);
    }
  });
  return rows;
}

async function load(file) {
  const mesh = new SplatMesh({ url: file.url, fileType: 'spz', extSplats: true });
  await mesh.initialized;
  mesh.position.fromArray(file.position ?? [0, 0, 0]);
  return mesh;
}

const canvas = document.createElement('canvas');
const renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
const scene = new THREE.Scene();
const spark = new SparkRenderer({ renderer, autoUpdate: false, ...job.settings });
scene.add(spark);
const meshes = [];
for (const file of job.files) meshes.push(await load(file));
meshes.forEach((mesh) => scene.add(mesh));

/** A picture as base64 of its RGBA rows, bottom up. */
async function picture({ eye, target, up, angle, size, near, far, files }) {
  meshes.forEach((mesh, number) => (mesh.visible = files?.includes(number) ?? true));
  const [width, height] = size;
  renderer.setSize(width, height, false);
  renderer.setClearColor(0x000000, 0);
  const camera = new THREE.PerspectiveCamera(angle, width / height, near, far);
  camera.position.fromArray(eye);
  camera.up.fromArray(up ?? [0, 1, 0]);
  camera.lookAt(new THREE.Vector3(...target));
  camera.updateMatrixWorld();
  scene.updateMatrixWorld();
  const start = performance.now();
  await spark.update({ scene, camera }); // and sort
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  renderer.render(scene, camera);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let at = 0; at < pixels.length; at += 8192) text += String.fromCharCode(...pixels.subarray(at, at + 8192));
  return { data: btoa(text), ms: performance.now() - start };
}

const files = meshes.map((mesh) => ({ count: mesh.splats?.getNumSplats() ?? 0, first: first(mesh, job.first ?? 0) }));
const pictures = [];
for (const view of job.views ?? []) pictures.push(await picture(view));
await fetch('/result', { method: 'POST', body: JSON.stringify({ files, pictures }) });
