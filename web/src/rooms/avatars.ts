/** Avatars of visible users: head, name above it, hands and pointer; and the pointer of the own user. */
import {
  type BufferGeometry,
  type Camera,
  CanvasTexture,
  type Color,
  LinearFilter,
  LinearMipmapLinearFilter,
  Matrix4,
  Quaternion,
  Scene,
  SRGBColorSpace,
  type Texture,
  Vector3,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { Point } from '../bundle/manifest';
import { subtract } from '../control/pose';
import { NEAR_VERTEX } from '../shaders/scene';
import type { Shared } from '../show/materials';
import { displayName } from './address';
import { colorOf, createMesh, createRay, createShapes, type DrawnMesh, setUserColor, type Shapes } from './meshes';
import type { Body } from './pose';
import type { VisibleGuest } from './presence';
import { NAME_VERTEX } from './shaders';

/** Greatest number of unused avatars that are kept for new users. */
const MAX_SPARE_AVATARS = 16;

/** Own user, of whom the picture shows only the pointer. */
type OwnUser = Pick<VisibleGuest, 'number' | 'body'>;

export function createAvatars(shared: Shared) {
  const shapes = createShapes();
  const common = { ...shared, pixel: { value: 0 } };
  const avatars = new Map<number, { readonly name: string; readonly avatar: Avatar }>();
  const color = new Vector4();
  const ray = createRay(shapes, common, color);
  let ownPointer: OwnUser | null = null;
  // three.js would delete the programs with the last avatar, and compile them again for the next user.
  const spare: Avatar[] = [createAvatar(shapes, common)];

  function avatarOf(number: number, name: string): Avatar {
    const known = avatars.get(number);
    if (known?.name === name) return known.avatar;
    const avatar = known?.avatar ?? spare.pop() ?? createAvatar(shapes, common);
    avatar.assign(number, name);
    avatars.set(number, { name, avatar });
    return avatar;
  }

  return {
    get meshes(): readonly DrawnMesh[] {
      const avatarMeshes = [...avatars.values()].flatMap(({ avatar }) => avatar.meshes);
      return ownPointer ? [...avatarMeshes, ray.mesh] : avatarMeshes;
    },
    /** Sets the users to draw; `pixel` is the tangent of the angle of a pixel. */
    show(seen: readonly VisibleGuest[], own: OwnUser | null, pixel: number): void {
      common.pixel.value = pixel;
      const numbers = new Set(seen.map(({ number }) => number));
      for (const [number, { avatar }] of avatars) {
        if (numbers.has(number)) continue;
        avatars.delete(number);
        if (spare.length < MAX_SPARE_AVATARS) spare.push(avatar);
        else avatar.dispose();
      }
      for (const { number, name, body } of seen) avatarOf(number, displayName(name, number)).show(body);
      ownPointer = own?.body.pointer ? own : null;
      if (ownPointer) setUserColor(color, ownPointer.number);
    },
    /** Compiles the shaders of avatars before the first user enters. */
    prepare(renderer: WebGLRenderer, camera: Camera): void {
      const meshes = spare.flatMap((avatar) => avatar.meshes);
      renderer.compile(new Scene().add(...meshes, ray.mesh), camera);
    },
    place(center: Point): void {
      for (const { avatar } of avatars.values()) avatar.place(center);
      if (ownPointer) ray.place(ownPointer.body, center);
    },
  };
}

/** Metres from the eyes up to the name. */
const NAME_HEIGHT = 0.2;
const VISOR_COLOR = new Vector4(0.03, 0.035, 0.045, 1);

type Avatar = ReturnType<typeof createAvatar>;

function createAvatar(shapes: Shapes, shared: Shared) {
  const color = new Vector4();
  const createSolid = (shape: BufferGeometry, baseColor: Vector4): DrawnMesh => {
    const uniforms = { base_color: { value: baseColor }, placement: { value: new Matrix4() } };
    return createMesh(shape, shared, NEAR_VERTEX, { SMOOTH: '' }, uniforms);
  };
  const parts = {
    head: createSolid(shapes.head, color),
    visor: createSolid(shapes.visor, VISOR_COLOR),
    left: createSolid(shapes.hand, color),
    right: createSolid(shapes.hand, color),
  };
  const ray = createRay(shapes, shared, color);
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
    get meshes(): readonly DrawnMesh[] {
      return [
        parts.head,
        parts.visor,
        title,
        ...(body?.left ? [parts.left] : []),
        ...(body?.right ? [parts.right] : []),
        ...(body?.pointer ? [ray.mesh] : []),
      ];
    },
    assign(number: number, name: string): void {
      image.value?.dispose();
      const label = createLabel(name, colorOf(number));
      [image.value, ratio.value] = [label.texture, label.ratio];
      setUserColor(color, number);
    },
    /** Sets the body in world space. */
    show(next: Body): void {
      body = next;
    },
    /** Places the avatar for pictures that have this centre at the origin. */
    place(center: Point): void {
      if (!body) return;
      const { head, left, right } = body;
      const [x, y, z] = subtract(head.position, center);
      for (const [part, placement] of [['head', head], ['visor', head], ['left', left], ['right', right]] as const) {
        if (!placement) continue;
        const matrix = parts[part].material.uniforms['placement']?.value as Matrix4;
        const rotation = new Quaternion(...placement.rotation).normalize();
        matrix.compose(new Vector3(...subtract(placement.position, center)), rotation, new Vector3(1, 1, 1));
      }
      nameBase.set(x, y + NAME_HEIGHT, z);
      ray.place(body, center);
    },
    dispose(): void {
      image.value?.dispose();
      for (const { material } of [...Object.values(parts), ray.mesh, title]) material.dispose();
    },
  };
}

/** Height of a label, size of its letters and horizontal padding, pixels. */
const [LABEL_HEIGHT, FONT_SIZE, PADDING] = [64, 40, 22] as const;
/** Greatest number of letters, and greatest width in pixels: some letters are as wide as words. */
const [MAX_LETTERS, MAX_WIDTH] = [24, 640] as const;

/** Draws a name; returns its picture, and the width divided by the height. */
function createLabel(name: string, color: Color): { readonly texture: CanvasTexture; readonly ratio: number } {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const letters = [...name];
  const text = letters.length > MAX_LETTERS ? `${letters.slice(0, MAX_LETTERS - 1).join('')}…` : name;
  const font = `600 ${FONT_SIZE}px system-ui, sans-serif`;
  if (context) context.font = font;
  const width = Math.min(Math.ceil(context?.measureText(text).width ?? 0), MAX_WIDTH);
  canvas.width = width + 2 * PADDING;
  canvas.height = LABEL_HEIGHT;
  if (context) {
    context.beginPath();
    context.roundRect(0, 0, canvas.width, LABEL_HEIGHT, LABEL_HEIGHT / 2);
    context.fillStyle = `#${color.getHexString()}`;
    context.fill();
    // Setting the width has reset the context.
    Object.assign(context, { font, textAlign: 'center', textBaseline: 'middle', fillStyle: '#0b0e12' });
    context.fillText(text, canvas.width / 2, LABEL_HEIGHT / 2 + 2, width);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  return { texture, ratio: canvas.width / LABEL_HEIGHT };
}
