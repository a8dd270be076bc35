/**
 * Script of the widget. A notebook loads it from a text, so that it cannot import files beside itself: it imports the
 * page's scripts, which Python sends with it, from object URLs.
 */

/** Scripts by name, each after those that it imports; Python defines them in front of this script. */
declare const SCRIPTS: readonly (readonly [name: string, text: string])[];

const urls = new Map<string, string>();
for (const [name, text] of SCRIPTS) {
  const linked = text.replace(/"\.\.?\/([\w.-]+)"/g, (path, file: string) => {
    const url = urls.get(file);
    return url === undefined ? path : `"${url}"`;
  });
  urls.set(name, URL.createObjectURL(new Blob([linked], { type: 'text/javascript' })));
}

function urlOf(name: string): string {
  const url = urls.get(name);
  if (url === undefined) throw new Error(`the widget has no script ${name}`);
  return url;
}

const { createWidget }: typeof import('./widget') = await import(urlOf('widget.js'));
export default createWidget(new URL(urlOf('worker.js')));
