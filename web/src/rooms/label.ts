/** A user's name as a picture: dark or light letters on a ground of the user's colour. */
import { CanvasTexture, type Color, LinearFilter, LinearMipmapLinearFilter, SRGBColorSpace } from 'three';

/** Pixels: height of the picture and of the letters, and beside them. */
const [HEIGHT, LETTERS, BESIDE] = [64, 40, 22] as const;
/** Letters that are shown of a name, and pixels: some letters are as wide as words. */
const [MOST, WIDEST] = [24, 640] as const;

export interface Label {
  readonly texture: CanvasTexture;
  /** Width in parts of the height. */
  readonly ratio: number;
}

export function createLabel(name: string, color: Color): Label {
  const canvas = document.createElement('canvas');
  const pen = canvas.getContext('2d');
  const letters = [...name];
  const text = letters.length > MOST ? `${letters.slice(0, MOST - 1).join('')}…` : name;
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
    // Setting the width has reset the pen.
    Object.assign(pen, { font, textAlign: 'center', textBaseline: 'middle', fillStyle: '#0b0e12' });
    pen.fillText(text, canvas.width / 2, HEIGHT / 2 + 2, width);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  return { texture, ratio: canvas.width / HEIGHT };
}
