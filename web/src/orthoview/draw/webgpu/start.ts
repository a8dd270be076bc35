/** Entry point of WebGPU, in a script that only browsers with WebGPU load. */
import type { Layout } from '../../store/layout';
import { createWebgpuDrawer } from './drawer';
import { kernelsOf } from './kernels';
import { createMeshes } from './meshes';

/** Callback for failures of the graphics: fatal if the device is lost, not fatal if memory is short. */
export type FailureHandler = (message: string, isFatal: boolean) => void;

const MEMORY_SHORT = 'there is too little graphics memory: set a lower limit by ?megabytes= in the address';

/** Starts drawing on a canvas with a device; throws before it takes the canvas if a feature is missing. */
export async function start(canvas: HTMLCanvasElement, layout: Layout, device: GPUDevice, onFailure: FailureHandler) {
  const format = navigator.gpu.getPreferredCanvasFormat();
  device.pushErrorScope('validation');
  const kernels = kernelsOf(device, format);
  const meshes = createMeshes(device, kernels.uniformLayout);
  const error = await device.popErrorScope();
  if (error) throw new Error(error.message);
  const context = canvas.getContext('webgpu');
  if (!context) throw new Error('this browser has no WebGPU for canvases');
  context.configure({ device, format, alphaMode: 'opaque' });
  reportFailures(device, onFailure);
  return createWebgpuDrawer(context, layout, device, kernels, meshes);
}

/** Reports only the first failure, because others follow from it; reports a shortage of memory once. */
function reportFailures(device: GPUDevice, onFailure: FailureHandler): void {
  let [isLost, isShort] = [false, false];
  const reportLoss = (message: string): void => {
    if (!isLost) onFailure(message, true);
    isLost = true;
  };
  void device.lost.then(({ message, reason }) => {
    if (reason !== 'destroyed') reportLoss(`the graphics device is lost: ${message}`);
  });
  device.onuncapturederror = ({ error }): void => {
    if (!(error instanceof GPUOutOfMemoryError)) reportLoss(`the graphics fail: ${error.message}`);
    else if (!isShort) onFailure(MEMORY_SHORT, false);
    isShort ||= error instanceof GPUOutOfMemoryError;
  };
}
