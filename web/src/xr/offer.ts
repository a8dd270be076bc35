/** Offers the headset where there is one, also one that is connected later. */
import type { Viewer } from '../show/viewer';
import { createHeadset, type Headset, type HeadsetSettings } from './session';
import { whyNoHeadset } from './support';

/** `tell` is given the headset, or a sentence why there is none, now and whenever that changes. */
export function offerHeadset(
  viewer: Viewer,
  settings: HeadsetSettings,
  tell: (found: Headset | string) => void,
): void {
  const { xr } = navigator;
  let headset: Headset | null = null;

  async function seek(): Promise<void> {
    const reason = await whyNoHeadset(xr, window.isSecureContext);
    if (reason !== null || !xr) {
      tell(reason ?? '');
      return;
    }
    headset ??= createHeadset(viewer, xr, settings);
    tell(headset);
  }

  void seek();
  xr?.addEventListener('devicechange', () => void seek());
}
