// Draws a picture by three.js for a pose: radians, yaw to the left, pitch up.
import * as THREE from 'three';

export const job = await (await fetch('/job/job.json')).json();
const [width, height] = job.size;
export const renderer = new THREE.WebGLRenderer({ antialias: false, alpha: true, preserveDrawingBuffer: true });
renderer.setSize(width, height, false);
renderer.setClearColor(0x000000, 0);
document.body.append(renderer.domElement);
export const camera = new THREE.PerspectiveCamera(job.angle, width / height, 1, 1e5);
camera.rotation.order = 'YXZ';
export const scene = new THREE.Scene();

export function look({ position, yaw, pitch }) {
  camera.position.fromArray(position);
  camera.rotation.set(pitch, yaw, 0);
  camera.updateMatrixWorld();
}
