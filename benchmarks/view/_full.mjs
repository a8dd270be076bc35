// A full scene, one GLB, in plain three.js, for the turns of rates.py. Frames are drawn as in the page.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const { eye, angle } = await (await fetch('view.json')).json();
const renderer = new THREE.WebGLRenderer({ antialias: true, powerPreference: 'high-performance' });
document.body.append(renderer.domElement);
renderer.setSize(innerWidth, innerHeight);
const camera = new THREE.PerspectiveCamera(angle, innerWidth / innerHeight, 0.05, 20_000);
camera.position.fromArray(eye);
const scene = new THREE.Scene().add(new THREE.HemisphereLight(0xffffff, 0x888888, 2));
scene.background = new THREE.Color(0x88aadd);
const { scene: full } = await new GLTFLoader().loadAsync('scene.glb');
scene.add(full);
// The scene is static: matrices are computed once.
scene.updateMatrixWorld(true);
scene.matrixWorldAutoUpdate = false;

const rates = {
  gl: renderer.getContext(),
  info: renderer.info,
  script: [],
  triangles: [],
  yaw: 0,
  look(yaw) {
    rates.yaw = yaw;
  },
  draw(yaw) {
    const start = performance.now();
    camera.rotation.y = yaw;
    camera.updateMatrixWorld();
    renderer.info.reset();
    renderer.render(scene, camera);
    rates.script.push(performance.now() - start);
    rates.triangles.push(renderer.info.render.triangles);
  },
};
renderer.info.autoReset = false;
rates.draw(0);
renderer.setAnimationLoop(() => rates.draw(rates.yaw));
window.rates = rates;
