// three.js on files of impostors: the page reads /job.json and posts to /result what it loaded and its pictures.
import { MeshoptDecoder } from 'meshoptimizer';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const job = await (await fetch('/job.json')).json();
const renderer = new THREE.WebGLRenderer({ alpha: true, preserveDrawingBuffer: true });
const results = {};
for (const name of job.files) {
  const gltf = await new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).loadAsync(`/bundles/${name}`);
  const textures = new Set();
  let triangles = 0;
  gltf.scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    triangles += (mesh.geometry.index.count / 3) * (mesh.count ?? 1);
    if (mesh.material.map) textures.add(mesh.material.map);
  });
  const filters = [...textures].map((texture) => ({
    linear: texture.minFilter === THREE.LinearFilter,
    mipmaps: texture.generateMipmaps,
  }));
  const pictures = job.views.map(({ eye, target, size, angle }) => {
    renderer.setSize(...size, false);
    const camera = new THREE.PerspectiveCamera(angle, size[0] / size[1], 0.05, 20_000);
    camera.position.fromArray(eye);
    camera.lookAt(...target);
    renderer.render(gltf.scene, camera);
    return { picture: renderer.domElement.toDataURL('image/png'), calls: renderer.info.render.calls };
  });
  results[name] = { triangles, pictures, filters, center: gltf.scene.userData.nearfar.center };
}
await answer(results);
