// The morph in GLSL on vectors, a far map in directions, and the morph in three.js as docs/engines.md tells: the page posts
// what shaders compute, and pictures of moved triangles.
import * as THREE from 'three';

const job = await (await fetch('/job.json')).json();
const MORPH = await (await fetch('/bundles/engines/morph.glsl')).text();
const canvas = document.createElement('canvas');
const gl = canvas.getContext('webgl2');

function compiled(kind, text) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${text}`);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
  return shader;
}

/** A program that writes an expression of the attribute `p` to a buffer. */
function program(expression) {
  const made = gl.createProgram();
  const uniforms = 'uniform vec3 user, center; uniform float r1, r2, strength; uniform samplerCube map;';
  const vertex = `${MORPH}\n${uniforms}\nin vec3 p;\nout vec3 q;\nvoid main() { q = ${expression}; }`;
  gl.attachShader(made, compiled(gl.VERTEX_SHADER, vertex));
  gl.attachShader(made, compiled(gl.FRAGMENT_SHADER, 'out vec4 color; void main() { color = vec4(1.0); }'));
  gl.transformFeedbackVaryings(made, ['q'], gl.SEPARATE_ATTRIBS);
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  return made;
}

/** Puts a far map's faces in their order before the programs, rows from the top. */
function bindMap({ size, faces }) {
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, gl.createTexture());
  faces.forEach((texels, face) => {
    const target = gl.TEXTURE_CUBE_MAP_POSITIVE_X + face;
    gl.texImage2D(target, 0, gl.RGBA8, size, size, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(texels));
  });
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
}

/** Values of a program for all points, three numbers each. */
function values(made, { points, user, center, r1, r2, strength }) {
  gl.useProgram(made);
  for (const [name, value] of Object.entries({ user, center })) gl.uniform3fv(gl.getUniformLocation(made, name), value);
  for (const [name, value] of Object.entries({ r1, r2, strength })) {
    gl.uniform1f(gl.getUniformLocation(made, name), value);
  }
  const input = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, input);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points.flat()), gl.STATIC_DRAW);
  const place = gl.getAttribLocation(made, 'p');
  gl.enableVertexAttribArray(place);
  gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
  const output = gl.createBuffer();
  gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, output);
  gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 12 * points.length, gl.STATIC_READ);
  gl.bindBuffer(gl.TRANSFORM_FEEDBACK_BUFFER, null);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, output);
  gl.enable(gl.RASTERIZER_DISCARD);
  gl.beginTransformFeedback(gl.POINTS);
  gl.drawArrays(gl.POINTS, 0, points.length);
  gl.endTransformFeedback();
  const found = new Float32Array(3 * points.length);
  gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, found);
  gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
  return Array.from(found);
}

/** Pixels of triangles about a centre that the user sees, by the page's own material or as they are. */
async function pictures({ positions, moved, colors, user, center, r1, r2, target, size, code }) {
  const howTo = await import(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
  howTo.nearFar.center.value.fromArray(center);
  howTo.nearFar.radii.value.set(r1, r2);
  const renderer = new THREE.WebGLRenderer();
  renderer.setSize(size, size, false);
  const camera = new THREE.PerspectiveCamera(90, 1, 0.1, 1000);
  camera.position.fromArray(user);
  camera.lookAt(...target);
  const shot = (at, material) => {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(at.flat(), 3));
    geometry.setAttribute('color', new THREE.Float32BufferAttribute(colors.flat(), 3));
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    const frame = new THREE.WebGLRenderTarget(size, size);
    renderer.setRenderTarget(frame);
    renderer.render(new THREE.Scene().add(mesh), camera);
    const pixels = new Uint8Array(4 * size * size);
    renderer.readRenderTargetPixels(frame, 0, 0, size, size, pixels);
    return Array.from(pixels);
  };
  const plain = () => new THREE.MeshBasicMaterial({ vertexColors: true, side: THREE.DoubleSide });
  return {
    morphed: shot(positions, howTo.nearFarMaterial(plain(), MORPH)),
    moved: shot(moved, plain()),
    plain: shot(positions, plain()),
  };
}

bindMap(job.map);
const programs = job.expressions.map(program);
const shown = job.cases.map((one) => values(programs[one.program], one));
await answer({ shown, pictures: await pictures(job.scene) });
