/**
 * Script of the widget. A notebook runs it without an address, so that it cannot import other files. Python sends the
 * other scripts as texts; this script makes object URLs from them, and imports those.
 */

/** Name and text of each script, after those that it imports; Python writes the definition before this script. */
declare const SCRIPTS: readonly (readonly [name: string, text: string])[];

const urls = new Map<string, string>();
for (const [name, text] of SCRIPTS) {
  const textWithUrls = text.replace(/"\.\.?\/([\w.-]+)"/g, (path, file: string) => {
    const url = urls.get(file);
    return url === undefined ? path : `"${url}"`;
  });
  urls.set(name, URL.createObjectURL(new Blob([textWithUrls], { type: 'text/javascript' })));
}

function urlOf(name: string): string {
  const url = urls.get(name);
  if (url === undefined) throw new Error(`the widget has no script ${name}`);
  return url;
}

const { createWidget }: typeof import('./widget') = await import(urlOf('widget.js'));
export default createWidget(new URL(urlOf('worker.js')));
