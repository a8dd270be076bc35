/** Documents of JSON that come one after the other in an answer, a line each. */
import { parseJson } from '../bundle/parse';
import { BundleError } from '../bundle/error';

/** Yield each line's document as soon as the line is there; longer lines than `most` characters are refused. */
export async function* linesOf(name: string, response: Response, most: number): AsyncGenerator<unknown> {
  const reader = response.body?.getReader();
  if (!reader) return;
  const decoder = new TextDecoder();
  let rest = '';
  for (;;) {
    const { done, value } = await reader.read();
    const pieces = (rest + decoder.decode(value, { stream: !done })).split('\n');
    rest = pieces.pop() ?? '';
    for (const piece of pieces) yield parseJson(name, piece);
    if (rest.length > most) throw new BundleError(`${name}: expected lines of at most ${most} characters`);
    if (done) break;
  }
  if (rest !== '') yield parseJson(name, rest);
}
