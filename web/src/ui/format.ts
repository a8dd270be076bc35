/** Numbers as people read them. */

export function megabytes(bytes: number): string {
  return `${(bytes / 1e6).toFixed(bytes < 1e7 ? 2 : 1)} MB`;
}

export function thousands(count: number): string {
  return count.toLocaleString('en');
}
