/** Two half-spaces in two sections beside each other: along x and along y of the job, to scale. */

import { svg } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';
import { exact, unit, unitsOf } from '../lib/units.js';
import { hasSurface, shapeLabel } from './fields.js';
import { roundStep } from '../field/palette.js';
import { WIDTH, loadLine, travel } from './load-line.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {'upper' | 'lower'} Body */
/** @typedef {{height: (s: number) => number, reach: number, ends?: boolean}} Section height along the outward normal, how far it says something, and whether the body ends there */

const [HEIGHT, STEPS] = [216, 60];
/** Heights that are drawn of a body without a curvature, in parts of the width. */
const DEEP = 0.45;

/** A roller's fall from its middle to its ends. @param {Job} job @param {Body} body @returns {((y: number) => number) | undefined} where it has a profile that can be drawn */
export function fallOf(job, body) {
  const shape = job[body]?.shape;
  if (shape?.type !== 'roller') return undefined;
  const [length, radius] = [numberOf(shape.length), numberOf(shape.radius)];
  if (!(length > 0 && radius > 0)) return undefined;
  const logarithm = (/** @type {number} */ y) =>
    Math.log(1 / (1 - Math.min(0.999999, (2 * y) / length) * ((2 * y) / length)));
  switch (shape.profile ?? '') {
    case '':
      return () => 0;
    case 'crowned': {
      const crown = numberOf(shape.crown_radius);
      return crown > 0 ? (y) => (y * y) / (2 * crown) : undefined;
    }
    case 'iso_16281': {
      const part = length > 5 * radius ? 5e-4 : 3.5e-4;
      return (y) => 2 * part * radius * logarithm(y);
    }
    case 'logarithmic': {
      const force = numberOf(shape.design_force);
      const soft = [job.upper, job.lower].reduce((sum, of) => sum + softness(of?.material), 0);
      return force > 0 && soft > 0
        ? (y) => ((force * soft) / (Math.PI * length)) * logarithm(y)
        : undefined;
    }
    case 'points':
      return fallOfPoints(shape.points);
    default:
      return undefined;
  }
}

/** (1 − ν²)/E. @param {Record<string, any> | undefined} material */
const softness = (material) =>
  material?.rigid
    ? 0
    : (1 - numberOf(material?.poisson_ratio) ** 2) / numberOf(material?.young_modulus);

/** @param {any} points */
function fallOfPoints(points) {
  const good = (/** @type {any} */ point) =>
    Array.isArray(point) && point.length === 2 && point.every(Number.isFinite);
  if (!Array.isArray(points) || points.length < 2 || !points.every(good)) return undefined;
  const half = points[0][0] === 0 || points[points.length - 1][0] === 0;
  return (/** @type {number} */ y) => {
    const at = half ? (points[0][0] === 0 ? Math.abs(y) : -Math.abs(y)) : y;
    const next = points.findIndex(([x]) => x >= at);
    if (next <= 0) return -points[next < 0 ? points.length - 1 : 0][1];
    const [[x0, h0], [x1, h1]] = [points[next - 1], points[next]];
    return -(h0 + ((at - x0) / (x1 - x0)) * (h1 - h0));
  };
}

/** @param {Job} job @param {Body} body @param {0 | 1} axis along x or along y @returns {Section | null} nothing while its figures make no shape */
function sectionOf(job, body, axis) {
  const { shape, surface } = job[body] ?? {};
  const turn = ((numberOf(shape?.rotation ?? 0) || 0) * Math.PI) / 180;
  const along = [Math.cos(turn) ** 2, Math.sin(turn) ** 2];
  const curvature = (/** @type {unknown} */ radius) => (radius == null ? 0 : 1 / numberOf(radius));
  const of = (/** @type {number} */ kx, /** @type {number} */ ky) =>
    arc(along[axis] * kx + along[1 - axis] * ky);
  const grid =
    hasSurface(job[body]) && Array.isArray(surface.heights) ? surface.heights : undefined;
  const size = grid
    ? (axis
        ? (grid[0]?.length ?? 0) * numberOf(surface.spacing_y)
        : grid.length * numberOf(surface.spacing_x)) / 2
    : Infinity;
  switch (shape?.type) {
    case 'sphere':
      return of(curvature(shape.radius), curvature(shape.radius));
    case 'curved':
      return of(curvature(shape.radius_x), curvature(shape.radius_y));
    case 'roller': {
      const fall = fallOf(job, body);
      const round = of(curvature(shape.radius), 0);
      // Turned, its axis lies in the other section; askew, neither section shows its end.
      if (!fall || !round || along[axis] > 1e-6) return round;
      const tilt = (timesOf(shape) * numberOf(shape.tilt ?? 0)) / 1000 || 0;
      return { height: (y) => tilt * y - fall(y), reach: numberOf(shape.length) / 2, ends: true };
    }
    case 'flat':
      return { height: () => 0, reach: size > 0 ? size : Infinity };
    default:
      return null;
  }
}

/** Slope at which a tilt is seen. */
const STEEP = 0.08;

/** How many times as large as it is a tilt is drawn. @param {Record<string, any> | undefined} shape */
function timesOf(shape) {
  const tilt = Math.abs(numberOf(shape?.tilt ?? 0)) / 1000;
  return tilt > 0 && tilt < STEEP ? roundStep(STEEP / tilt / 2) : 1;
}

/** @param {number} curvature @returns {Section | null} */
function arc(curvature) {
  if (!Number.isFinite(curvature)) return null;
  if (Math.abs(curvature) < 1e-12) return { height: () => 0, reach: Infinity };
  const radius = 1 / curvature;
  const rise = (/** @type {number} */ s) =>
    Math.abs(radius) - Math.sqrt(Math.max(0, radius * radius - s * s));
  return { height: (s) => -Math.sign(radius) * rise(s), reach: Math.abs(radius) };
}

/** @param {Job} job */
export function sections(job) {
  const words = `Sections through the contact along x and along y, to scale: ${name(job, 'upper')} above, ${name(job, 'lower')} below.`;
  const root = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': words });
  const views = /** @type {const} */ ([0, 1]).map((axis) =>
    /** @type {const} */ (['upper', 'lower']).map((body) => sectionOf(job, body, axis)),
  );
  if (views.flat().some((one) => one === null)) return root;
  const seen = /** @type {Section[][]} */ (views).map((pair) => {
    const least = Math.min(...pair.map(({ reach }) => reach));
    return Number.isFinite(least) ? 1.3 * least : 0;
  });
  // Where a section says nothing of a size it is as wide as the other.
  const widths = seen.map((one, axis) => one || seen[1 - axis] || 1);
  // One scale for both, unless one would be a point in it.
  const wide = Math.max(...widths);
  const room = WIDTH / 4 - 8;
  /** @type {Section[][]} */ (views).forEach((pair, axis) => {
    const half = widths[axis] < wide / 8 ? widths[axis] : wide;
    const [scale, middle, level] = [room / half, WIDTH * (0.25 + 0.5 * axis), 0.53 * HEIGHT];
    pair.forEach(({ height, reach, ends }, k) => {
      const up = k ? 1 : -1;
      const end = Math.min(reach, half);
      const points = Array.from({ length: 2 * STEPS + 1 }, (_, n) => {
        const s = end * Math.sin((Math.PI / 2) * (n / STEPS - 1));
        return [s, height(s * (ends ? 0.9999 : 1))];
      });
      const base = Math.max(
        Math.min(-DEEP * half, ...points.map(([, one]) => one - 0.08 * half)),
        -0.82 * half,
      );
      const corners = [
        [end, base],
        [-end, base],
      ];
      const path = [...points, ...corners]
        .map(
          ([s, one]) =>
            `${(middle + scale * s).toFixed(2)} ${(level - scale * up * Math.max(base, one)).toFixed(2)}`,
        )
        .join('L');
      const body = k ? 'lower' : 'upper';
      root.append(
        svg('path', {
          class: `body${job[body]?.material?.rigid ? ' rigid' : ''}`,
          d: `M${path}Z`,
        }),
      );
    });
    root.append(
      svg('circle', { class: 'contact', cx: middle, cy: level, r: 2 }),
      svg(
        'text',
        { x: middle - room, y: HEIGHT - 8 },
        `along ${axis ? 'y' : 'x'}${half === wide ? '' : ', enlarged'}${tiltWords(job, axis)}`,
      ),
    );
  });
  const text = loadLine(job);
  root.append(
    svg('path', { class: 'arrow', d: `M${WIDTH / 4} 5v16m-3.500 -5l3.500 5l3.500 -5` }),
    ...travel(job, WIDTH / 4, 13),
    svg('text', { x: WIDTH / 4 + 8, y: 16, class: 'load' }, text),
    svg('text', { x: WIDTH - 6, y: 16, class: 'note' }, name(job, 'upper')),
    svg('text', { x: WIDTH - 6, y: HEIGHT - 22, class: 'note' }, name(job, 'lower')),
  );
  return root;
}

/** What is said of a tilt beside the section that shows it. @param {Job} job @param {number} axis */
function tiltWords(job, axis) {
  const shape = [job.upper, job.lower].map((body) => body?.shape).find((one) => one?.tilt);
  if (!shape || !axis) return '';
  const times = timesOf(shape);
  return `, tilt ${exact(numberOf(shape.tilt))} mrad${times > 1 ? ` ×${exact(times)}` : ''}`;
}

/** What a body is, with its size. @param {Job} job @param {Body} body */
function name(job, body) {
  const { shape, surface } = job[body] ?? {};
  const length = unit('length', unitsOf(job));
  const radii = [shape?.radius, shape?.radius_x, shape?.radius_y]
    .filter((one) => one != null)
    .map((one) => exact(numberOf(one)));
  const size = radii.length ? ` R ${radii.join(' / ')} ${length}` : '';
  const rough = hasSurface(job[body])
    ? `, ${surface.heights?.length ?? 0} × ${surface.heights?.[0]?.length ?? 0} heights`
    : '';
  return `${shapeLabel(shape?.type, job.analysis).toLowerCase()}${size}${rough}`;
}
