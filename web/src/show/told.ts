/** Marks of the loading on the browser's timeline: for its developer tools, and for those who measure loads. */

/** A ring of a region can be shown from now on, or is in the frame that is drawn now. */
export function tell(event: 'arrived' | 'shown', region: number, ring: number): void {
  performance.mark(`nearfar:${event}`, { detail: { region, ring } });
}
