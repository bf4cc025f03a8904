/**
 * The smooth curve through points that the solver makes of a profile: piecewise cubic, smooth to
 * the first derivative, without overshoot (Fritsch and Carlson 1980, slopes of Fritsch and Butland
 * 1984).
 */

/** @typedef {[number, number]} Point */

/** Pieces of straight lines that a picture of a curve has at least. */
const PIECES = 192;

/**
 * @param {Point[]} points at least two, x rising
 * @returns {Point[]} them, and points of the curve between them
 */
export function smoothed(points) {
  const secants = points
    .slice(1)
    .map(
      ([x, y], k) =>
        /** @type {Point} */ ([x - points[k][0], (y - points[k][1]) / (x - points[k][0])]),
    );
  const slopes = points.map((_, k) => {
    const [left, right] = [secants[k - 1], secants[k]];
    if (left && right) return innerSlope(left, right);
    return right ? endSlope(right, secants[1]) : endSlope(left, secants[k - 2]);
  });
  const many = Math.max(1, Math.ceil(PIECES / secants.length));
  const between = secants.flatMap(([h], k) =>
    Array.from({ length: many }, (_, j) => {
      const t = (j + 1) / many;
      const s = 1 - t;
      const [[x0, y0], [, y1]] = [points[k], points[k + 1]];
      const bends = h * t * s * (s * slopes[k] - t * slopes[k + 1]);
      return /** @type {Point} */ ([
        x0 + t * h,
        y0 * s * s * (1 + 2 * t) + y1 * t * t * (3 - 2 * t) + bends,
      ]);
    }),
  );
  return [points[0], ...between];
}

/** Slope between two intervals `[h, secant]`: zero at an extremum, else the weighted harmonic mean. @param {Point} left @param {Point} right */
function innerSlope([h0, s0], [h1, s1]) {
  if (s0 * s1 <= 0) return 0;
  const [w0, w1] = [2 * h1 + h0, h1 + 2 * h0];
  return (w0 + w1) / (w0 / s0 + w1 / s1);
}

/** Slope at an end: of the parabola through the three nearest points, limited so that nothing overshoots. @param {Point} near @param {Point | undefined} next */
function endSlope([h0, s0], next) {
  if (!next) return s0;
  const [h1, s1] = next;
  const slope = ((2 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
  if (slope * s0 <= 0) return 0;
  return s0 * s1 <= 0 && Math.abs(slope) > 3 * Math.abs(s0) ? 3 * s0 : slope;
}
