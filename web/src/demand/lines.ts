/** JSON documents in a streamed response, one per line. */
import { parseJson } from '../bundle/parse';
import { BundleError } from '../bundle/error';

/** Yields each line's document as soon as it is complete; rejects lines longer than `most` characters. */
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
