/** Checks, decompression, and WebP decoding of a bundle's files. */
import { inflate, sha256 as hashOf } from '../base/bytes';
import { messageOf } from '../base/errors';
import type { Band, FileData } from './messages';

/** Content of a file; throws an error if its size or hash is not that of the manifest. */
export async function contentOf(file: FileData): Promise<Uint8Array<ArrayBuffer>> {
  const { name, data, bytes, sha256 } = file;
  if (data.byteLength !== bytes)
    throw new Error(`${name}: expected ${bytes} bytes, as the manifest lists it, got ${data.byteLength}`);
  // Browsers offer hashes only on https and localhost; elsewhere only the size is checked.
  const actualHash = await hashOf(data);
  if (actualHash !== null && actualHash !== sha256)
    throw new Error(`${name}: expected SHA-256 ${sha256.slice(0, 16)}…, got ${actualHash.slice(0, 16)}…`);
  return new Uint8Array(data);
}

/** Content of a compressed file; throws an error if it has more than `maxBytes` bytes. */
export async function inflateFile(file: FileData, maxBytes: number): Promise<Uint8Array> {
  const content = await contentOf(file);
  try {
    return await inflate(content, maxBytes);
  } catch (error) {
    throw new Error(`${file.name}: expected compressed ranges, got ${messageOf(error)}`);
  }
}

/** Greatest number of texels of a picture: 8192². */
const MAX_TEXELS = 2 ** 26;

/** Maximum size of a band of rows, bytes, unless a single row is larger. */
const BAND_BYTES = 2 ** 18;
/** Keeps the raw values of a picture: no colour conversion, no premultiplied alpha. */
const RAW_PIXELS = { colorSpaceConversion: 'none', premultiplyAlpha: 'none', imageOrientation: 'none' } as const;

/** Decodes a WebP picture for the GPU. */
export async function pictureOf(name: string, data: Uint8Array<ArrayBuffer>): Promise<ImageBitmap> {
  const [width, height] = sizeOf(name, data);
  if (width * height > MAX_TEXELS)
    throw new Error(`${name}: expected a smaller picture, got ${width} × ${height} pixels`);
  try {
    return await createImageBitmap(new Blob([data], { type: 'image/webp' }), RAW_PIXELS);
  } catch {
    throw new Error(`${name}: expected a WebP picture, got something else`);
  }
}

/** Splits pictures, given by name, into bands of rows; closes the pictures. */
export async function bandsOf(images: Readonly<Record<string, ImageBitmap>>): Promise<Band[]> {
  const bands: Band[] = [];
  for (const [name, image] of Object.entries(images)) {
    const { width, height } = image;
    const rowsPerBand = Math.max(Math.floor(BAND_BYTES / (4 * width)), 1);
    for (let y = 0; y < height; y += rowsPerBand) {
      const bitmap = await createImageBitmap(image, 0, y, width, Math.min(rowsPerBand, height - y), RAW_PIXELS);
      bands.push({ name, width, height, y, bitmap });
    }
    image.close();
  }
  return bands;
}

/** Decodes an opaque picture of known size to RGBA, rows from the top. */
export async function pixelsOf(file: FileData, width: number, height: number): Promise<Uint8Array> {
  const data = await contentOf(file);
  const size = sizeOf(file.name, data);
  if (size[0] !== width || size[1] !== height)
    throw new Error(`${file.name}: expected ${width} × ${height} pixels, got ${size[0]} × ${size[1]}`);
  const bitmap = await pictureOf(file.name, data);
  return new Uint8Array(rgbaOf(bitmap).buffer);
}

/** Reads the RGBA of a picture, exactly if the picture is opaque, and closes it. */
export function rgbaOf(image: ImageBitmap): Uint8ClampedArray {
  const { width, height } = image;
  try {
    const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    if (!context) throw new Error('this browser has no 2D canvas in workers, which decoding pictures needs');
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, width, height).data;
  } finally {
    image.close();
  }
}

/** Reads width and height from the first chunk of a WebP file. */
export function sizeOf(name: string, data: Uint8Array): [width: number, height: number] {
  const bytes = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const textAt = (place: number): string => String.fromCharCode(...data.subarray(place, place + 4));
  if (data.length >= 30 && textAt(0) === 'RIFF' && textAt(8) === 'WEBP') {
    switch (textAt(12)) {
      // Lossy: a frame tag and a start code of three bytes each, then 14 bits each, below two bits of scaling.
      case 'VP8 ':
        return [bytes.getUint16(26, true) & 0x3fff, bytes.getUint16(28, true) & 0x3fff];
      // Lossless: a signature byte, then width − 1 and height − 1 with 14 bits each.
      case 'VP8L': {
        const bits = bytes.getUint32(21, true);
        return [1 + (bits & 0x3fff), 1 + ((bits >>> 14) & 0x3fff)];
      }
      // Extended: four bytes of flags, then width − 1 and height − 1 with 24 bits each.
      case 'VP8X':
        return [1 + (bytes.getUint32(24, true) & 0xffffff), 1 + (bytes.getUint32(26, true) >>> 8)];
    }
  }
  throw new Error(`${name}: expected a WebP picture, got something else`);
}
