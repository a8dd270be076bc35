/** Programs of the GPU, made before a frame needs them: compiling one may take as long as many frames. */
import { BufferGeometry, type Camera, Mesh, type RawShaderMaterial, Scene, Texture, type WebGLRenderer } from 'three';
import type { Piece } from '../decode/messages';
import { definesOf, nearMaterial, type Shared, texturesOf } from './materials';
import type { Uploads } from './uploads';

export interface Programs {
  /** Resolves when the GPU has the programs that pieces like these need. */
  ready(samples: readonly Piece[]): Promise<void>;
  /** The graphics were lost, and all programs with them. */
  forget(): void;
}

export function createPrograms(renderer: WebGLRenderer, camera: Camera, shared: Shared, uploads: Uploads): Programs {
  // By kind. three.js lets go of a program with the last material that uses it; those that are made here stay.
  const made = new Map<string, Promise<void>>();
  const picture = new Texture();

  async function make(piece: Piece): Promise<void> {
    const material = nearMaterial(piece, texturesOf(piece.material, () => picture), shared, Infinity);
    const scene = new Scene().add(new Mesh(new BufferGeometry(), material));
    let compiled = Promise.resolve();
    const begin = (): void => {
      compiled = compile(renderer, scene, camera);
    };
    await uploads.add([{ kind: 'program', bytes: 0, run: begin }], new AbortController().signal, true);
    await compiled;
    await idle(renderer);
    const start = performance.now();
    look(renderer, material);
    uploads.spend(performance.now() - start);
  }

  function kindOf(piece: Piece): string {
    return Object.keys(definesOf(piece, texturesOf(piece.material, () => picture))).join(' ');
  }

  return {
    async ready(samples) {
      const coming = samples.map((piece) => {
        const kind = kindOf(piece);
        const found = made.get(kind) ?? make(piece);
        made.set(kind, found);
        return found;
      });
      await Promise.all(coming);
    },
    forget() {
      made.clear();
    },
  };
}

/** Milliseconds between two looks at what the GPU has done, and how often it is looked at. */
const [LOOK, LOOKS] = [10, 3] as const;

/** Compile the programs of a scene; resolves when a frame that uses them need not wait. */
async function compile(renderer: WebGLRenderer, scene: Scene, camera: Camera): Promise<void> {
  if (renderer.extensions.has('KHR_parallel_shader_compile')) {
    await renderer.compileAsync(scene, camera);
    return;
  }
  // Other browsers compile in the order of all commands, so what comes after them tells.
  renderer.compile(scene, camera);
  await passed(renderer);
}

/** Resolves when the GPU has done all commands until now. */
async function passed(renderer: WebGLRenderer): Promise<void> {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const after = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  while (after && !gl.isContextLost() && gl.getSyncParameter(after, gl.SYNC_STATUS) !== gl.SIGNALED) {
    await new Promise((done) => setTimeout(done, LOOK));
  }
  gl.deleteSync(after);
}

/** Resolves when the GPU has nothing to do, so that it answers questions at once; where it is slow it may not come to that. */
async function idle(renderer: WebGLRenderer): Promise<void> {
  for (let n = 0; n < LOOKS; n++) {
    const { frame } = renderer.info.render;
    await passed(renderer);
    if (renderer.info.render.frame === frame) return;
  }
}

/** Let three.js ask what the program of a material has, which waits for the GPU; an error if it could not be made. */
function look(renderer: WebGLRenderer, material: RawShaderMaterial): void {
  const gl = renderer.getContext() as WebGL2RenderingContext;
  const { currentProgram: made } = renderer.properties.get(material) as { currentProgram?: Made };
  if (!made || gl.isContextLost()) return;
  if (gl.getProgramParameter(made.program, gl.LINK_STATUS) !== true) {
    const logs = [made.vertexShader, made.fragmentShader].map((shader) => gl.getShaderInfoLog(shader));
    throw new Error(`the browser refuses a program: ${[gl.getProgramInfoLog(made.program), ...logs].join(' ')}`);
  }
  made.getUniforms();
  made.getAttributes();
}

/** A program as three.js knows it. */
interface Made {
  readonly program: WebGLProgram;
  readonly vertexShader: WebGLShader;
  readonly fragmentShader: WebGLShader;
  getUniforms(): unknown;
  getAttributes(): unknown;
}
