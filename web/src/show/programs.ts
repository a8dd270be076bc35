/** Compiles GPU programs before a frame needs them, because a compilation may take as long as many frames. */
import { BufferGeometry, type Camera, Mesh, type RawShaderMaterial, Scene, Texture, type WebGLRenderer } from 'three';
import type { Piece } from '../decode/messages';
import { definesOf, nearMaterial, type Shared, texturesOf } from './materials';
import type { Uploads } from './uploads';

export type Programs = ReturnType<typeof createPrograms>;

export function createPrograms(renderer: WebGLRenderer, camera: Camera, shared: Shared, uploads: Uploads) {
  // Programs by kind. Their materials are never disposed of: three.js deletes a program with its last material.
  const programs = new Map<string, Promise<void>>();
  const picture = new Texture();

  async function compileProgram(piece: Piece): Promise<void> {
    const material = nearMaterial(piece, texturesOf(piece.material, () => picture), shared, Infinity);
    const scene = new Scene().add(new Mesh(new BufferGeometry(), material));
    let compiled = Promise.resolve();
    const run = (): void => {
      compiled = compile(renderer, scene, camera);
    };
    await uploads.add([{ kind: 'program', bytes: 0, run }], new AbortController().signal, true);
    await compiled;
    await waitForIdle(renderer);
    const start = performance.now();
    checkProgram(renderer, material);
    uploads.spend(performance.now() - start);
  }

  return {
    /** Compiles the programs for pieces like these, unless that has been done. */
    async compileFor(samples: readonly Piece[]): Promise<void> {
      const compilations: (Promise<void> | undefined)[] = [];
      for (const piece of samples) {
        const kind = Object.keys(definesOf(piece, texturesOf(piece.material, () => picture))).join(' ');
        if (!programs.has(kind)) programs.set(kind, compileProgram(piece));
        compilations.push(programs.get(kind));
      }
      await Promise.all(compilations);
    },
    /** Forgets all programs, after the graphics context was lost. */
    forget: (): void => programs.clear(),
  };
}

/** Milliseconds between two polls of the GPU's progress. */
const POLL_MS = 10;
/** Greatest number of attempts to find the GPU idle. */
const MAX_ATTEMPTS = 3;

/** Compiles the programs of a scene; resolves when a frame can use them without waiting. */
async function compile(renderer: WebGLRenderer, scene: Scene, camera: Camera): Promise<void> {
  if (renderer.extensions.has('KHR_parallel_shader_compile')) {
    await renderer.compileAsync(scene, camera);
    return;
  }
  // Browsers without this extension compile in the order of the commands, so that a fence tells the end.
  renderer.compile(scene, camera);
  await waitForGpu(renderer);
}

/** Resolves when the GPU has finished all commands up to now. */
async function waitForGpu(renderer: WebGLRenderer): Promise<void> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED)
    await new Promise((done) => setTimeout(done, POLL_MS));
  gl.deleteSync(fence);
}

/** Waits until the GPU is idle, so that queries do not block, or until a few attempts have failed. */
async function waitForIdle(renderer: WebGLRenderer): Promise<void> {
  for (let n = 0; n < MAX_ATTEMPTS; n++) {
    const { frame } = renderer.info.render;
    await waitForGpu(renderer);
    if (renderer.info.render.frame === frame) return;
  }
}

/** Lets three.js read the variables of a program, which waits for the GPU; throws an error if it is invalid. */
function checkProgram(renderer: WebGLRenderer, material: RawShaderMaterial): void {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { currentProgram: compiled } = renderer.properties.get(material) as { currentProgram?: ThreeProgram };
  if (!compiled || gl.isContextLost()) return;
  if (gl.getProgramParameter(compiled.program, gl.LINK_STATUS) !== true) {
    const logs = [compiled.vertexShader, compiled.fragmentShader].map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`the browser refuses a program: ${[gl.getProgramInfoLog(compiled.program), ...logs].join(' ')}`);
  }
  compiled.getUniforms();
  compiled.getAttributes();
}

/** Program of three.js. */
interface ThreeProgram {
  readonly program: WebGLProgram;
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
  getUniforms(): unknown;
  getAttributes(): unknown;
}
