/** Marks of the loading on the browser's timeline, for its developer tools and for measurements. */

/** Marks that a ring of a region can be shown, or is in the current frame. */
export function tell(event: 'arrived' | 'shown', region: number, ring: number): void {
  performance.mark(`nearfar:${event}`, { detail: { region, ring } });
}
