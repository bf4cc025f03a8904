/**
 * Outlines of shapes for the sketch, each in its body's own frame: contact at the origin, heights along the outward normal,
 * so that the material lies below.
 */

/** @typedef {[number, number]} Point */
/** @typedef {{surface: Point[], base: number}} Outline the surface from left to right, closed by straight sides to the height `base` */

const STEPS = 48;

/**
 * @param {Record<string, any> | undefined} shape
 * @returns {Outline | null} nothing while its figures make no shape
 */
export function outline(shape) {
  const [radius, width, depth] = [shape?.radius, shape?.width, shape?.depth].map(Number);
  switch (shape?.type) {
    case 'cylinder':
      return radius > 0 ? { surface: arc(radius, radius, -1), base: -radius } : null;
    case 'block':
      return width > 0 && depth > 0
        ? {
            surface: [
              [-width / 2, 0],
              [width / 2, 0],
            ],
            base: -depth,
          }
        : null;
    case 'groove':
      return radius > 0 && width > 0 && width <= 2 * radius && depth > 0
        ? { surface: arc(radius, width / 2, 1), base: -depth }
        : null;
    case 'profile':
      return depth > 0 ? profile(shape.points, depth) : null;
    default:
      return null;
  }
}

/** @param {number} radius @param {number} half of its width @param {1 | -1} sense 1 rises away from the middle @returns {Point[]} */
function arc(radius, half, sense) {
  const limit = Math.asin(Math.min(1, half / radius));
  return Array.from({ length: 2 * STEPS + 1 }, (_, k) => {
    const angle = (limit * (k - STEPS)) / STEPS;
    return [radius * Math.sin(angle), sense * radius * (1 - Math.cos(angle))];
  });
}

/** @param {unknown} points @param {number} depth @returns {Outline | null} */
function profile(points, depth) {
  const good = (/** @type {any} */ point) => Array.isArray(point) && point.length === 2 && point.every(Number.isFinite);
  if (!Array.isArray(points) || points.length < 2 || !points.every(good)) return null;
  const mirrored = points.map(([x, height]) => /** @type {Point} */ ([-x, height])).reverse();
  const whole =
    points[0][0] === 0
      ? [...mirrored.slice(0, -1), ...points]
      : points.at(-1)[0] === 0
        ? [...points, ...mirrored.slice(1)]
        : points;
  return { surface: whole, base: -depth };
}
