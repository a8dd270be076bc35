/** A device of WebGPU with as much room as its adapter has. */

/** Limits that are asked for: a picture's samples and views lie in few buffers. */
const WANTED = ['maxBufferSize', 'maxStorageBufferBindingSize', 'maxTextureDimension2D'] as const;

/** A device; null where there is none, or only one in software that was not asked for by name. */
export async function deviceOf(isNamed: boolean): Promise<GPUDevice | null> {
  const adapter = await navigator.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter || (isSoftware(adapter) && !isNamed)) return null;
  const requiredLimits = Object.fromEntries(WANTED.map((name) => [name, adapter.limits[name]]));
  return adapter.requestDevice({ requiredLimits });
}

/** Older browsers tell it of the adapter itself. */
function isSoftware(adapter: GPUAdapter & { readonly isFallbackAdapter?: boolean }): boolean {
  return adapter.info?.isFallbackAdapter ?? adapter.isFallbackAdapter ?? false;
}
