/** Programs of the GPU, made before a frame needs them: compiling one may take as long as many frames. */
import { BufferGeometry, type Camera, Mesh, Scene, Texture, type WebGLRenderer } from 'three';
import type { Piece } from '../decode/messages';
import { nearMaterial, type Shared } from './materials';

export interface Programs {
  /** Resolves when the GPU has the programs that pieces need. */
  ready(pieces: readonly Piece[]): Promise<void>;
  /** The graphics were lost, and all programs with them. */
  forget(): void;
}

export function createPrograms(renderer: WebGLRenderer, camera: Camera, shared: Shared): Programs {
  // three.js lets go of a program that no material uses, so one of each kind stays.
  const samples = new Map<string, { readonly scene: Scene; readonly made: Promise<unknown> }>();
  const picture = new Texture();

  function begin(piece: Piece): Promise<unknown> {
    const material = nearMaterial(piece, piece.material.image === null ? null : picture, shared, Infinity);
    const kind = Object.keys(material.defines).sort().join(' ');
    const found = samples.get(kind);
    if (found) {
      material.dispose();
      return found.made;
    }
    const scene = new Scene().add(new Mesh(new BufferGeometry(), material));
    const made = compiled(renderer, scene, camera);
    samples.set(kind, { scene, made });
    return made;
  }

  return {
    async ready(pieces) {
      await Promise.all(pieces.map(begin));
    },
    forget() {
      samples.clear();
    },
  };
}

/** Milliseconds between two looks at what the GPU has done. */
const LOOK = 10;

/** Compile the programs of a scene; resolves when a frame that uses them need not wait. */
async function compiled(renderer: WebGLRenderer, scene: Scene, camera: Camera): Promise<void> {
  if (renderer.extensions.has('KHR_parallel_shader_compile')) {
    await renderer.compileAsync(scene, camera);
    return;
  }
  // Other browsers compile in the order of all commands, so what comes after them tells.
  renderer.compile(scene, camera);
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const after = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  while (after && !gl.isContextLost() && gl.getSyncParameter(after, gl.SYNC_STATUS) !== gl.SIGNALED) {
    await new Promise((done) => setTimeout(done, LOOK));
  }
  gl.deleteSync(after);
}
