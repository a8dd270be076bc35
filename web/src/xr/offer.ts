/** Detection of a headset, also of one that is connected later. */
import type { Viewer } from '../show/viewer';
import { createHeadset, type Headset, type HeadsetSettings } from './session';
import { whyNoHeadset } from './support';

/** Detects the headset; `tell` is called with it, or with a sentence why there is none, now and on changes. */
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
