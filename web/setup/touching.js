/** Where the outlines of two bodies touch first as they come together. */

/** @typedef {import('./outline.js').Outline} Outline */
/** @typedef {import('./outline.js').Point} Point */

/** Part of the size of the bodies within which gaps are closed. */
const CLOSED = 1e-6;

/** @param {Point[]} surface from left to right @param {number} x @returns {number} its height there; beyond its ends nothing is as high */
function heightAt(surface, x) {
  const next = surface.findIndex(([at]) => at >= x);
  if (next < 0 || (next === 0 && surface[0][0] > x)) return -Infinity;
  if (next === 0) return surface[0][1];
  const [[x0, h0], [x1, h1]] = [surface[next - 1], surface[next]];
  return h0 + ((x - x0) / (x1 - x0)) * (h1 - h0);
}

/**
 * @param {Outline} upper
 * @param {Outline} lower
 * @returns {{raise: number, places: Point[]}} how far the upper body is to be raised so that they just touch, and where they then do, in
 * the section: the middle of each part of the surfaces that lies on the other
 */
export function touching(upper, lower) {
  const xs = [...new Set([...upper.surface, ...lower.surface].map(([x]) => x))].sort(
    (a, b) => a - b,
  );
  const sums = xs.map((x) => heightAt(upper.surface, x) + heightAt(lower.surface, x));
  const raise = Math.max(...sums);
  const slack =
    CLOSED *
    Math.max(xs[xs.length - 1] - xs[0], raise - Math.min(...sums.filter(Number.isFinite)));
  const closed = sums.map((sum) => sum >= raise - slack);
  const places = xs.flatMap((x, k) => {
    if (!closed[k] || closed[k - 1]) return [];
    const open = closed.indexOf(false, k);
    const middle = (x + xs[(open < 0 ? xs.length : open) - 1]) / 2;
    return [/** @type {Point} */ ([middle, heightAt(lower.surface, middle)])];
  });
  return { raise, places };
}

/** A body whose heights are counted from another one. @param {Outline} body @param {number} height @returns {Outline} */
export function counted({ surface, base, edge, ...rest }, height) {
  const lowered = (/** @type {Point[]} */ points) =>
    points.map(([x, h]) => /** @type {Point} */ ([x, h - height]));
  return {
    ...rest,
    surface: lowered(surface),
    base: base - height,
    ...(edge && { edge: lowered(edge) }),
  };
}
