/**
 * Outlines of shapes for the sketch, each in its body's own frame: contact at the origin, heights
 * along the outward normal, so that the material lies below.
 */

import { numberOf } from '../lib/number.js';
import { smoothed } from './interpolation.js';

/** @typedef {[number, number]} Point */
/**
 * @typedef {{surface: Point[], base: number, edge?: Point[], broken?: boolean}} Outline the surface from left to right, closed by straight sides to
 * the height `base`; of a body around a hole the whole circle, and its outer edge, or `broken` off
 * where that is far away
 */

const STEPS = 48;

/** Figures beyond this make no picture. */
const HUGE = 1e150;

/**
 * @param {Record<string, any> | undefined} shape
 * @returns {Outline | null} nothing while its figures make no shape
 */
export function outline(shape) {
  const made = outlineOf(shape);
  const figures = [
    made?.base ?? NaN,
    ...(made?.surface ?? []).flat(),
    ...(made?.edge ?? []).flat(),
  ];
  return figures.every((figure) => Math.abs(figure) < HUGE) ? made : null;
}

/** @param {Record<string, any> | undefined} shape @returns {Outline | null} */
function outlineOf(shape) {
  const [radius, width, depth] = [shape?.radius, shape?.width, shape?.depth].map(numberOf);
  switch (shape?.type) {
    case 'cylinder':
    case 'sphere':
      return radius > 0 ? { surface: arc(radius, radius, -1), base: -radius } : null;
    case 'hole':
      return hole(radius, numberOf(shape?.outer_radius ?? 0), numberOf(shape?.width ?? 0));
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
      return depth > 0 ? profile(shape.points, depth, shape.interpolation !== 'linear') : null;
    default:
      return smooth(shape);
  }
}

/** How far a body is drawn, in sizes of a much smaller one on it. */
const SEEN = 2.5;

/**
 * What is drawn of two bodies: of one that is much larger than the other, the part beside it,
 * broken off.
 * @param {(Outline | null)[]} bodies
 * @returns {(Outline | null)[]}
 */
export function cutOut(bodies) {
  const reach = (/** @type {Outline} */ { surface }) =>
    Math.max(...surface.map(([x]) => Math.abs(x)));
  const plain = bodies.flatMap((body) => (body && !body.edge ? [body] : []));
  if (plain.length < 2) return bodies;
  const small = Math.min(...plain.map((body) => Math.max(reach(body), 0.5 * high(body))));
  const most = SEEN * small;
  return bodies.map((body) => {
    if (!body || body.edge || (reach(body) <= 1.6 * most && high(body) <= 1.6 * most)) return body;
    const inside = body.surface.filter(([x]) => Math.abs(x) < most);
    const end = (/** @type {number} */ x) => /** @type {Point} */ ([x, heightOn(body.surface, x)]);
    const [left, right] = [-1, 1].map((side) => side * Math.min(reach(body), most));
    const surface = [end(left), ...inside, end(right)];
    const low = Math.min(...surface.map(([, h]) => h));
    return { surface, base: Math.max(body.base, low - most), broken: true };
  });
}

/** @param {Outline} body */
const high = ({ surface, base }) => Math.max(...surface.map(([, h]) => h)) - base;

/** @param {Point[]} surface from left to right @param {number} x */
function heightOn(surface, x) {
  const next = surface.findIndex(([at]) => at >= x);
  if (next <= 0) return surface[next < 0 ? surface.length - 1 : 0][1];
  const [[x0, h0], [x1, h1]] = [surface[next - 1], surface[next]];
  return x1 > x0 ? h0 + ((h1 - h0) * (x - x0)) / (x1 - x0) : h1;
}

/** Part of a body around a hole that is drawn, in radii of the hole. */
const AROUND = 2;

/**
 * @param {number} radius
 * @param {number} outer radius of its edge, or 0
 * @param {number} width of a square edge, or 0
 * @returns {Outline | null}
 */
function hole(radius, outer, width) {
  const given = outer || width / 2;
  if (!(radius > 0 && given > radius)) return null;
  const half = Math.min(given, AROUND * radius);
  const lift = (/** @type {Point[]} */ points) =>
    points.map(([x, y]) => /** @type {Point} */ ([x, y + radius]));
  const square = /** @type {Point[]} */ ([
    [-half, -half],
    [half, -half],
    [half, half],
    [-half, half],
  ]);
  const edge = lift(outer ? circle(half) : square);
  return { surface: lift(circle(radius)), base: radius - half, edge, broken: half < given };
}

/** @param {number} radius @returns {Outline | null} a cylinder in a hole, whole */
export function pin(radius) {
  const lower = (/** @type {Point} */ [x, y]) => /** @type {Point} */ ([x, y - radius]);
  return radius > 0 ? { surface: circle(radius).map(lower), base: -2 * radius } : null;
}

/** @param {number} radius @returns {Point[]} around the origin, from the bottom and back */
function circle(radius) {
  return Array.from({ length: 4 * STEPS + 1 }, (_, k) => {
    const angle = (Math.PI * k) / (2 * STEPS);
    return [radius * Math.sin(angle), -radius * Math.cos(angle)];
  });
}

/** @param {Record<string, any> | undefined} shape @returns {Outline | null} of a shape whose height is a formula */
function smooth(shape) {
  const number = (/** @type {string} */ key) => numberOf(shape?.[key] ?? 0);
  const [width, depth] = [number('width'), number('depth')];
  const flank = Math.tan((number('angle') * Math.PI) / 180);
  switch (shape?.type) {
    case 'wedge':
    case 'cone': {
      const radius = number('tip_radius');
      const tip = (radius * flank) / Math.hypot(flank, 1);
      const height = (/** @type {number} */ x) =>
        Math.abs(x) < tip
          ? Math.sqrt(radius * radius - x * x) - radius
          : radius * (Math.hypot(flank, 1) - 1) - flank * Math.abs(x);
      return flank > 0 ? sampled(height, width, depth) : null;
    }
    case 'punch': {
      const radius = number('edge_radius');
      const flat = width / 2 - radius;
      const height = (/** @type {number} */ x) =>
        Math.abs(x) > flat
          ? Math.sqrt(Math.max(0, radius * radius - (Math.abs(x) - flat) ** 2)) - radius
          : 0;
      return flat > 0 ? sampled(height, width, depth) : null;
    }
    case 'parabola': {
      const radius = number('radius');
      return radius > 0 ? sampled((x) => (-x * x) / (2 * radius), width, depth) : null;
    }
    case 'ellipse': {
      const [along, across] = [number('semi_axis_x'), number('semi_axis_y')];
      const height = (/** @type {number} */ x) =>
        across * (Math.sqrt(Math.max(0, 1 - (x / along) ** 2)) - 1);
      return sampled(height, 2 * along, across);
    }
    case 'power': {
      const [exponent, scale] = [number('exponent'), number('scale')];
      return scale > 0
        ? sampled((x) => -scale * (Math.abs(x) / scale) ** exponent, width, depth)
        : null;
    }
    default:
      return null;
  }
}

/** @param {(x: number) => number} height @param {number} width @param {number} depth @returns {Outline | null} */
function sampled(height, width, depth) {
  if (!(width > 0 && depth > 0)) return null;
  const surface = Array.from({ length: 2 * STEPS + 1 }, (_, k) => {
    const x = (width / 2) * Math.sin((Math.PI / 2) * (k / STEPS - 1));
    return /** @type {Point} */ ([x, height(x)]);
  });
  return { surface, base: -depth };
}

/** @param {number} radius @param {number} half of its width @param {1 | -1} sense 1 rises away from the middle @returns {Point[]} */
function arc(radius, half, sense) {
  const limit = Math.asin(Math.min(1, half / radius));
  return Array.from({ length: 2 * STEPS + 1 }, (_, k) => {
    const angle = (limit * (k - STEPS)) / STEPS;
    return [radius * Math.sin(angle), sense * radius * (1 - Math.cos(angle))];
  });
}

/** @param {unknown} points @param {number} depth @param {boolean} isSmooth between the points @returns {Outline | null} */
function profile(points, depth, isSmooth) {
  const good = (/** @type {any} */ point) =>
    Array.isArray(point) && point.length === 2 && point.every(Number.isFinite);
  if (!Array.isArray(points) || points.length < 2 || !points.every(good)) return null;
  const mirrored = points.map(([x, height]) => /** @type {Point} */ ([-x, height])).reverse();
  const whole =
    points[0][0] === 0
      ? [...mirrored.slice(0, -1), ...points]
      : points.at(-1)[0] === 0
        ? [...points, ...mirrored.slice(1)]
        : points;
  const rises = whole.every(([x], k) => k === 0 || x > whole[k - 1][0]);
  return { surface: isSmooth && rises ? smoothed(whole) : whole, base: -depth };
}
