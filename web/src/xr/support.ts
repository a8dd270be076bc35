/** Whether there is a headset, in a sentence for those who look for one. */

/** Why no headset can be entered from here; null if one can. */
export async function whyNoHeadset(xr: XRSystem | undefined, isSecure: boolean): Promise<string | null> {
  if (!isSecure) return 'A headset can be entered where the page comes over https.';
  if (!xr) return 'This browser knows no headsets.';
  try {
    return (await xr.isSessionSupported('immersive-vr')) ? null : 'No headset is connected.';
  } catch {
    // The page lies in a frame that may not use one.
    return 'Headsets cannot be used from here.';
  }
}
