/** Availability of a headset, as a sentence for users. */

/** Returns why no headset can be entered; null if one can. */
export async function whyNoHeadset(xr: XRSystem | undefined, isSecure: boolean): Promise<string | null> {
  if (!isSecure) return 'A headset can be entered where the page comes over https.';
  if (!xr) return 'This browser knows no headsets.';
  try {
    return (await xr.isSessionSupported('immersive-vr')) ? null : 'No headset is connected.';
  } catch {
    // The page is in a frame without permission for headsets.
    return 'Headsets cannot be used from here.';
  }
}
