/** Drawing of a user: a head with a label above it, hands, and a pointer. */
import {
  type BufferGeometry,
  CanvasTexture,
  type Color,
  LinearFilter,
  LinearMipmapLinearFilter,
  Matrix4,
  Quaternion,
  SRGBColorSpace,
  type Texture,
  Vector3,
  Vector4,
} from 'three';
import type { Point } from '../bundle/manifest';
import { subtract } from '../control/pose';
import { NEAR_VERTEX } from '../shaders/scene';
import type { Shared } from '../show/materials';
import { colorOf, createMesh, createRay, type Drawn, paint, type Shapes } from './meshes';
import type { Body, Placed } from './pose';
import { NAME_VERTEX } from './shaders';

/** Metres from the eyes up to the name. */
const ABOVE = 0.2;
const VISOR = new Vector4(0.03, 0.035, 0.045, 1);

export type Avatar = ReturnType<typeof createAvatar>;

/** Creates an avatar without a user. */
export function createAvatar(shapes: Shapes, shared: Shared) {
  const own = new Vector4();
  const solid = (shape: BufferGeometry, base: Vector4): Drawn => {
    const uniforms = { base_color: { value: base }, placement: { value: new Matrix4() } };
    return createMesh(shape, shared, NEAR_VERTEX, { SMOOTH: '' }, uniforms);
  };
  const parts = {
    head: solid(shapes.head, own),
    visor: solid(shapes.visor, VISOR),
    left: solid(shapes.hand, own),
    right: solid(shapes.hand, own),
  };
  const ray = createRay(shapes, shared, own);
  const nameBase = new Vector3();
  const [image, ratio] = [{ value: null as Texture | null }, { value: 1 }];
  const title = createMesh(shapes.name, shared, NAME_VERTEX, { TEXTURED: '', CUTOUT: '', UNLIT: '' }, {
    base_color: { value: new Vector4(1, 1, 1, 1) },
    image,
    cutoff: { value: 0.5 },
    begin: { value: nameBase },
    ratio,
  });
  let body: Body | null = null;

  return {
    /** Meshes of the visible parts of the body. */
    get meshes(): readonly Drawn[] {
      return [
        parts.head,
        parts.visor,
        title,
        ...(body?.left ? [parts.left] : []),
        ...(body?.right ? [parts.right] : []),
        ...(body?.pointer ? [ray.mesh] : []),
      ];
    },
    /** Assigns the avatar to a user. */
    be(number: number, name: string): void {
      image.value?.dispose();
      const label = createLabel(name, colorOf(number));
      [image.value, ratio.value] = [label.texture, label.ratio];
      paint(own, number);
    },
    /** Sets the body in world space. */
    show(next: Body): void {
      body = next;
    },
    /** Updates positions for pictures with this centre at the origin. */
    place(center: Point): void {
      if (!body) return;
      const { head, left, right } = body;
      const [x, y, z] = subtract(head.position, center);
      for (const [part, placed] of [['head', head], ['visor', head], ['left', left], ['right', right]] as const) {
        if (placed) compose(parts[part], placed, center);
      }
      nameBase.set(x, y + ABOVE, z);
      ray.place(body, center);
    },
    dispose(): void {
      image.value?.dispose();
      for (const { material } of [...Object.values(parts), ray.mesh, title]) material.dispose();
    },
  };
}

function compose({ material }: Drawn, { position, rotation }: Placed, center: Point): void {
  const matrix = material.uniforms['placement']?.value as Matrix4;
  const place = new Vector3(...subtract(position, center));
  matrix.compose(place, new Quaternion(...rotation).normalize(), new Vector3(1, 1, 1));
}

/** Height of the label, height of the letters and horizontal padding, pixels. */
const [HEIGHT, LETTERS, BESIDE] = [64, 40, 22] as const;
/** Greatest number of letters, and greatest width in pixels: some letters are as wide as words. */
const [MAX, WIDEST] = [24, 640] as const;

export interface Label {
  readonly texture: CanvasTexture;
  /** Width divided by height. */
  readonly ratio: number;
}

function createLabel(name: string, color: Color): Label {
  const canvas = document.createElement('canvas');
  const pen = canvas.getContext('2d');
  const letters = [...name];
  const text = letters.length > MAX ? `${letters.slice(0, MAX - 1).join('')}…` : name;
  const font = `600 ${LETTERS}px system-ui, sans-serif`;
  if (pen) pen.font = font;
  const width = Math.min(Math.ceil(pen?.measureText(text).width ?? 0), WIDEST);
  canvas.width = width + 2 * BESIDE;
  canvas.height = HEIGHT;
  if (pen) {
    pen.beginPath();
    pen.roundRect(0, 0, canvas.width, HEIGHT, HEIGHT / 2);
    pen.fillStyle = `#${color.getHexString()}`;
    pen.fill();
    // Setting the width has reset the context.
    Object.assign(pen, { font, textAlign: 'center', textBaseline: 'middle', fillStyle: '#0b0e12' });
    pen.fillText(text, canvas.width / 2, HEIGHT / 2 + 2, width);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  return { texture, ratio: canvas.width / HEIGHT };
}
