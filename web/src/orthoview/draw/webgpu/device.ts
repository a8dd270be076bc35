/** WebGPU device with the greatest limits of its adapter. */

/** Limits that are raised: samples and views of a picture lie in few buffers. */
const WANTED = ['maxBufferSize', 'maxStorageBufferBindingSize', 'maxTextureDimension2D'] as const;

/** Returns a device; null if there is none, or only a software one that was not requested by name. */
export async function deviceOf(isNamed: boolean): Promise<GPUDevice | null> {
  const adapter = await navigator.gpu?.requestAdapter({ powerPreference: 'high-performance' });
  if (!adapter || (isSoftware(adapter) && !isNamed)) return null;
  const requiredLimits = Object.fromEntries(WANTED.map((name) => [name, adapter.limits[name]]));
  return adapter.requestDevice({ requiredLimits });
}

/** Older browsers set the flag on the adapter itself. */
function isSoftware(adapter: GPUAdapter & { readonly isFallbackAdapter?: boolean }): boolean {
  return adapter.info?.isFallbackAdapter ?? adapter.isFallbackAdapter ?? false;
}
