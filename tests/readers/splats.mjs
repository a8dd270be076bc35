// Spark on SPZ files: the page reads /job.json, draws pictures and posts to /result what it loaded and drew.
import { SparkRenderer, SplatMesh } from '@sparkjsdev/spark';
import * as THREE from 'three';

const job = await (await fetch('/job.json')).json();

async function load({ url, position }) {
  const mesh = new SplatMesh({ url, fileType: 'spz', extSplats: true });
  await mesh.initialized;
  mesh.position.fromArray(position);
  return mesh;
}

/** The first splats of a mesh: middle, standard deviations, rotation, opacity and colour of each. */
function first(mesh, count) {
  const rows = [];
  mesh.forEachSplat((index, center, scales, quaternion, opacity, color) => {
    if (index < count) {
      rows.push([...center.toArray(), ...scales.toArray(), ...quaternion.toArray(), opacity, ...color.toArray()]);
    }
  });
  return rows;
}

const canvas = document.createElement('canvas');
const renderer = new THREE.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
const spark = new SparkRenderer({ renderer, autoUpdate: false });
const scene = new THREE.Scene();
const meshes = [];
for (const file of job.files) meshes.push(await load(file));
scene.add(spark, ...meshes);

/** A picture of some of the files as base64 of its RGBA rows, bottom up, with premultiplied alpha. */
async function picture({ eye, target, angle, size: [width, height], near, far, files }) {
  meshes.forEach((mesh, number) => {
    mesh.visible = files.includes(number);
  });
  renderer.setSize(width, height, false);
  renderer.setClearColor(0x000000, 0);
  const camera = new THREE.PerspectiveCamera(angle, width / height, near, far);
  camera.position.fromArray(eye);
  camera.lookAt(...target);
  camera.updateMatrixWorld();
  scene.updateMatrixWorld();
  await spark.update({ scene, camera }); // and sort
  renderer.render(scene, camera);
  const gl = renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (let at = 0; at < pixels.length; at += 8192) text += String.fromCharCode(...pixels.subarray(at, at + 8192));
  return btoa(text);
}

const files = meshes.map((mesh) => ({ count: mesh.splats.getNumSplats(), first: first(mesh, job.first) }));
const pictures = [];
for (const view of job.views) pictures.push(await picture(view));
await fetch('/result', { method: 'POST', body: JSON.stringify({ files, pictures }) });
