// Decodes bundles by the page's worker: reads /job.json and posts maps, images and errors to /result.

/** A worker as a function that returns the result or throws its error. */
function startWorker() {
  const worker = new Worker('/worker.js', { type: 'module' });
  const waiting = new Map();
  let last = 0;
  worker.onmessage = ({ data }) => {
    const { done, failed } = waiting.get(data.id);
    if ('error' in data) failed(new Error(data.error));
    else done(data.result);
  };
  worker.onerror = (event) => {
    for (const { failed } of waiting.values()) failed(new Error(`the worker stopped: ${event.message}`));
  };
  const decode = (request) =>
    new Promise((done, failed) => {
      last += 1;
      waiting.set(last, { done, failed });
      worker.postMessage({ ...request, id: last });
    });
  return { decode, stop: () => worker.terminate() };
}

function base64(array) {
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  let text = '';
  for (let start = 0; start < bytes.length; start += 1 << 15) {
    text += String.fromCharCode(...bytes.subarray(start, start + (1 << 15)));
  }
  return btoa(text);
}

function joined(arrays) {
  const all = new arrays[0].constructor(arrays.reduce((sum, array) => sum + array.length, 0));
  let place = 0;
  for (const array of arrays) {
    all.set(array, place);
    place += array.length;
  }
  return base64(all);
}

/** The bytes of a picture as WebGL takes its bands for a texture. */
function texelsOf(bands) {
  const [{ width, height }] = bands;
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
  for (const { y, bitmap } of bands) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const texels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, texels);
  gl.getExtension('WEBGL_lose_context').loseContext();
  return { width, height, texels: base64(texels) };
}

async function decoded(name) {
  const place = `/bundles/${name}`;
  const manifest = await (await fetch(`${place}/manifest.json`)).json();
  const [region] = manifest.regions;
  const file = async (uri) => {
    const data = await (await fetch(`${place}/${uri}`)).arrayBuffer();
    return { name: uri, data, ...manifest.files[uri] };
  };
  const files = (names) => Promise.all([names ?? []].flat().map(file));
  const { face_size: faceSize, tile, across } = manifest.map;
  const { step } = region.range;
  const first = async () => ({
    kind: 'first-map', faceSize, tile, across, step, color: await files(region.rings[0].map.color),
  });
  const next = async (ring, since) => {
    const { tiles, color, range } = region.rings[ring].map;
    const [picture] = await files(color);
    return { kind: 'next-map', ring, tiles, color: picture ?? null, range: await files(range), since };
  };
  const result = { whole: [], changes: [], images: {}, errors: {} };

  const { decode, stop } = startWorker();
  const failure = async (request) => {
    try {
      await decode(request);
      return 'nothing';
    } catch (error) {
      return error.message;
    }
  };
  const ring = region.rings.find(({ geometry }) => geometry);
  const geometry = (glb, parts, isDynamic) => ({
    kind: 'geometry', glb, parts, known: [], center: region.center, growth: { radii: [], nearShare: 0.7, reach: 1 }, isDynamic,
  });
  // Damage comes first: what follows shows that the worker goes on.
  const [glb, picture] = [await file(ring.geometry), (await files(region.rings[0].map.color))[0]];
  const garbage = new TextEncoder().encode('garbage'.repeat(9)).buffer;
  const hash = await crypto.subtle.digest('SHA-256', garbage);
  const sha256 = Array.from(new Uint8Array(hash), (byte) => byte.toString(16).padStart(2, '0')).join('');
  const wrong = { data: garbage, bytes: garbage.byteLength, sha256 };
  result.errors.hash = await failure(geometry({ ...glb, sha256: '0'.repeat(64) }, [], false));
  result.errors.size = await failure(geometry({ ...glb, data: glb.data.slice(1) }, [], false));
  result.errors.glb = await failure(geometry({ ...glb, ...wrong }, [], false));
  result.errors.order = await failure(await next(1, null));
  result.errors.picture = await failure({ ...(await first()), color: Array(6).fill({ ...picture, ...wrong }) });

  const entry = (update) => ({ color: joined(update.color), codes: update.codes && joined(update.codes) });
  result.whole.push(entry(await decode(await first())));
  for (let number = 1; number < region.rings.length; number++) {
    result.whole.push(entry(await decode(await next(number, null))));
  }
  await decode(await first());
  await decode(await next(1, null));
  for (let number = 2; number < region.rings.length; number++) {
    // In turn of the ring before and of the one before that, as two cubes need it.
    const since = Math.max(number % 2 === 0 ? number - 1 : number - 2, 1);
    const { tiles, color, codes } = await decode(await next(number, since));
    result.changes.push({ ring: number, since, tiles: base64(tiles), color: base64(color), codes: base64(codes) });
  }
  for (const { geometry: uri, parts, isDynamic } of [
    ...region.rings.map((own) => ({ ...own, isDynamic: false })),
    ...(manifest.dynamic ? [{ ...manifest.dynamic, isDynamic: true }] : []),
  ]) {
    if (!uri) continue;
    const { number, parts: count } = await decode(geometry(await file(uri), await files(parts), isDynamic));
    const bands = [];
    for (let part = 0; part < count; part++) bands.push(...(await decode({ kind: 'part', geometry: number, part })).bands);
    for (const name of new Set(bands.map((band) => band.name))) {
      result.images[name] = texelsOf(bands.filter((band) => band.name === name));
    }
  }
  stop();
  return result;
}

const { bundles } = await (await fetch('/job.json')).json();
const results = {};
for (const name of bundles) results[name] = await decoded(name);
await answer(results);
