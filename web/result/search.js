/**
 * The value of a number for which an answer has a value: the sign change is bracketed, then halved
 * by secants that never leave it (Illinois). Each look is a job.
 */

/** @typedef {{at: number, value: number}} Look */

/** Most looks, and the share of the wanted value within which one is good. */
const [MOST, GOOD] = [24, 2e-3];
/** Largest ratio of both ends before there is a bracket. */
const REACH = 64;

/**
 * @param {(at: number) => Promise<number>} look at the answer of a value; NaN where there is none
 * @param {number} begin a value of the number
 * @param {number} wanted
 * @param {() => boolean} stopped
 * @returns {Promise<{best: Look, found: boolean, looks: Look[]}>}
 */
export async function search(look, begin, wanted, stopped) {
  const looks = /** @type {Look[]} */ ([]);
  const far = (/** @type {Look} */ { value }) => Math.abs(value - wanted);
  const best = () =>
    looks.reduce((a, b) => (!(far(a) <= far(b)) ? b : a), { at: begin, value: NaN });
  const good = (/** @type {Look} */ one) => far(one) <= GOOD * (Math.abs(wanted) || 1);
  const ask = async (/** @type {number} */ at) => {
    const figure = Number(at.toPrecision(5));
    const one = { at: figure, value: await look(figure) };
    looks.push(one);
    return one;
  };
  const done = () => stopped() || looks.length >= MOST || good(best());
  const first = await ask(begin);
  let [low, high] = [first, first];
  for (let ratio = 1.5; ratio <= REACH && !done(); ratio *= 1.6) {
    const [a, b] = [await ask(begin / ratio), done() ? undefined : await ask(begin * ratio)];
    const changed = [a, ...(b ? [b] : [])].find(
      (one) => (one.value - wanted) * (first.value - wanted) < 0,
    );
    if (changed) {
      // The nearest look on the other side of the wanted value.
      const near = looks
        .filter(
          (one) => one.value - wanted !== 0 && (one.value - wanted) * (changed.value - wanted) < 0,
        )
        .reduce(
          (p, q) => (Math.abs(q.at - changed.at) < Math.abs(p.at - changed.at) ? q : p),
          first,
        );
      [low, high] = changed.at < near.at ? [changed, near] : [near, changed];
      break;
    }
  }
  let [weighLow, weighHigh, side] = [1, 1, 0];
  while (low !== high && !done()) {
    const [a, b] = [weighLow * (low.value - wanted), weighHigh * (high.value - wanted)];
    const guess = (a * high.at - b * low.at) / (a - b);
    const inside = guess > low.at && guess < high.at;
    const one = await ask(inside ? guess : (low.at + high.at) / 2);
    if (!Number.isFinite(one.value)) break;
    if ((one.value - wanted) * (low.value - wanted) > 0) {
      low = one;
      weighLow = 1;
      weighHigh = side === 1 ? weighHigh / 2 : 1;
      side = 1;
    } else {
      high = one;
      weighHigh = 1;
      weighLow = side === -1 ? weighLow / 2 : 1;
      side = -1;
    }
  }
  const last = best();
  return { best: last, found: good(last), looks };
}
