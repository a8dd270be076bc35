// 3d-tiles-renderer with the leaves' tileset, lit as in all renderers here.
import { ImplicitTilingPlugin } from '3d-tiles-renderer/core/plugins';
import { TilesRenderer } from '3d-tiles-renderer/three';
import { MeshoptDecoder } from 'meshoptimizer';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { camera, job, look, renderer, scene } from './shared.mjs';

await MeshoptDecoder.ready;
const tiles = new TilesRenderer(job.tileset);
tiles.registerPlugin(new ImplicitTilingPlugin());
tiles.manager.addHandler(/\.glb$/, new GLTFLoader(tiles.manager).setMeshoptDecoder(MeshoptDecoder));
tiles.group.rotation.x = -Math.PI / 2;
tiles.setCamera(camera);
tiles.setResolution(camera, ...job.size);
// The cache can hold all leaves of a picture.
Object.assign(tiles.lruCache, { minSize: 20_000, maxSize: 30_000, minBytesSize: 2e9, maxBytesSize: 4e9 });
scene.add(tiles.group);
scene.updateMatrixWorld(true);

/** Material with the formula of docs/render.md for faces lit on both sides. */
function lit({ color, vertexColors, map }) {
  const material = new THREE.MeshBasicMaterial({ color, vertexColors, map, side: THREE.DoubleSide });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('void main() {', 'varying vec3 vWorld;\nvoid main() {')
      .replace('#include <project_vertex>', '#include <project_vertex>\nvWorld = (modelMatrix * vec4(transformed, 1.0)).xyz;');
    shader.fragmentShader = shader.fragmentShader.replace('void main() {', `varying vec3 vWorld;\n${job.irradiance}\nvoid main() {`)
      .replace('#include <opaque_fragment>', `
        vec3 n = normalize(cross(dFdx(vWorld), dFdy(vWorld)));
        outgoingLight *= irradiance(n);
        #include <opaque_fragment>`);
  };
  return material;
}

tiles.addEventListener('load-model', ({ scene: model }) => {
  model.traverse((mesh) => {
    if (mesh.isMesh) mesh.material = lit(mesh.material);
  });
});

window.client = {
  see: (pose) => look(pose),
  async draw() {
    tiles.update();
    renderer.render(scene, camera);
  },
  /** Number of missing tiles of the picture. */
  get missing() {
    const { queued, downloading, parsing } = tiles.stats;
    return tiles.root ? queued + downloading + parsing : 1;
  },
  get facts() {
    return { ...tiles.stats, triangles: renderer.info.render.triangles };
  },
};
