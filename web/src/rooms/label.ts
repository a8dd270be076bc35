/** Label of a user's name: dark letters on the user's colour. */
import { CanvasTexture, type Color, LinearFilter, LinearMipmapLinearFilter, SRGBColorSpace } from 'three';

/** Height of the label, height of the letters and horizontal padding, pixels. */
const [HEIGHT, LETTERS, BESIDE] = [64, 40, 22] as const;
/** Greatest number of letters, and greatest width in pixels: some letters are as wide as words. */
const [MAX, WIDEST] = [24, 640] as const;

export interface Label {
  readonly texture: CanvasTexture;
  /** Width divided by height. */
  readonly ratio: number;
}

export function createLabel(name: string, color: Color): Label {
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
