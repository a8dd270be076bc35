/** nearfar's random numbers (docs/base.md): a function of seed, cell and index, identical in all languages. */

const GOLDEN = 0x9e3779b97f4a7c15n;
const word = (value: bigint): bigint => BigInt.asUintN(64, value);

/** SplitMix64's finaliser. */
function mixed(value: bigint): bigint {
  let z = word((value ^ (value >> 30n)) * 0xbf58476d1ce4e5b9n);
  z = word((z ^ (z >> 27n)) * 0x94d049bb133111ebn);
  return z ^ (z >> 31n);
}

/** Number in [0, 1). */
export function uniform(seed: number, cell: number, index: number): number {
  let state = mixed(word(BigInt(seed) + GOLDEN));
  for (const each of [cell, index]) state = mixed(word((state ^ BigInt(each)) + GOLDEN));
  return Number(state >> 11n) / 2 ** 53;
}
