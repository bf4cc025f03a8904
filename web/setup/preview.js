/** Small pictures beside the fields: a profile with its heights exaggerated, a hardening curve. */

import { h, svg } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';
import { plain, unit, unitsOf } from '../lib/units.js';
import { bandsWithin } from '../field/palette.js';
import { curve } from './hardening.js';
import { outline } from './outline.js';
import { fallOf } from './sections.js';

/** @typedef {import('../lib/units.js').Units} Units */
/** @typedef {[number, number]} Point */

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [324, 110, 46, 18, 10];

/** @param {Record<string, any> | undefined} shape @param {Units} units */
export function profilePreview(shape, units) {
  if (shape?.type !== 'profile') return [];
  const made = outline(shape);
  if (!made) return [];
  const { surface } = made;
  const [low, high] = range(surface.map(([, y]) => y));
  const [left, right] = range(surface.map(([x]) => x));
  if (!(right > left)) return [];
  const scaleX = (WIDTH - LEFT - 8) / (right - left);
  const scaleY = (HEIGHT - BOTTOM - TOP) / (high - low || 1);
  const length = unit('length', units);
  const times = scaleY / scaleX;
  return [
    h(
      'figure',
      { class: 'preview' },
      drawing(
        surface,
        [left, right],
        [low, high],
        `Profile, ${shape.points.length} points`,
        'filled',
      ),
      h(
        'figcaption',
        {},
        `height over x [${length}]${times > 1.05 ? `, heights ×${plain(Number(times.toPrecision(2)))}` : ''}`,
      ),
    ),
  ];
}

/** How the surface of a roller falls along its axis. @param {import('../types.js').Job} job @param {'upper' | 'lower'} body */
export function rollerPreview(job, body) {
  const fall = fallOf(job, body);
  if (!fall) return [];
  const { shape } = job[body];
  const length = numberOf(shape.length);
  const tilt = numberOf(shape.tilt ?? 0) / 1000 || 0;
  // Logarithms fall without end at the very ends.
  const points = Array.from({ length: 101 }, (_, k) => {
    const y = 0.4995 * length * Math.sin(Math.PI * (k / 100 - 0.5));
    return /** @type {Point} */ ([y, 1000 * (tilt * y - fall(y))]);
  });
  const straight = /** @type {Point[]} */ (
    tilt ? points.map(([y]) => [y, 1000 * tilt * y]) : undefined
  );
  const heights = [...points, ...(straight ?? [])].map(([, height]) => height);
  const small = unitsOf(job) === 'SI' ? 'mm' : 'µm';
  return [
    h(
      'figure',
      { class: 'preview' },
      drawing(
        points,
        [-length / 2, length / 2],
        range(heights),
        'Profile of the roller',
        'filled',
        straight,
      ),
      h(
        'figcaption',
        {},
        `height [${small}] over y [${unit('length', unitsOf(job))}]${straight ? '; dashed: axis' : ''}`,
      ),
    ),
  ];
}

/** @param {Record<string, any> | undefined} surface @param {Units} units a picture of its heights, light where they are high */
export function heightsPreview(surface, units) {
  const rows = surface?.heights;
  if (!Array.isArray(rows) || !Array.isArray(rows[0])) return [];
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows)
    for (const one of row) [low, high] = [Math.min(low, one), Math.max(high, one)];
  if (!Number.isFinite(high - low)) return [];
  const [width, height] = [rows[0].length, rows.length];
  const canvas = h('canvas', {
    width,
    height,
    role: 'img',
    'aria-label': `Heights, ${height} × ${width}`,
  });
  const context = canvas.getContext('2d');
  if (!context) return [];
  const image = context.createImageData(width, height);
  const { colours } = bandsWithin(0, high - low);
  rows.forEach((row, i) =>
    row.forEach((/** @type {number} */ one, /** @type {number} */ j) => {
      const band = Math.floor(((one - low) / (high - low || 1)) * colours.length);
      const rgb = colours[Math.min(colours.length - 1, band)];
      // x points up, as on the map of the contact.
      image.data.set([...rgb.map((part) => 255 * part), 255], 4 * ((height - 1 - i) * width + j));
    }),
  );
  context.putImageData(image, 0, 0);
  const length = unit('length', units);
  const [along, across] = [
    numberOf(surface?.spacing_y) * width,
    numberOf(surface?.spacing_x) * height,
  ];
  const size = Number.isFinite(along * across)
    ? `, ${plain(across)} × ${plain(along)} ${length}`
    : '';
  const span = plain(Number((high - low).toPrecision(3)));
  return [
    h(
      'figure',
      { class: 'preview heights' },
      canvas,
      h(
        'figcaption',
        {},
        `x up, y to the right: ${height} × ${width} heights${size}, ${span} ${length} from lowest to highest`,
      ),
    ),
  ];
}

/** @param {Record<string, any> | undefined} material @param {Units} units */
export function curvePreview(material, units) {
  const stress = curve(material);
  if (!stress) return [];
  const modulus = numberOf(material?.young_modulus);
  const law = material?.plasticity;
  const last = law.law === 'table' ? law.points.at(-1)[0] : 0;
  const reach = Math.max(0.02, Math.min(last, 0.5));
  const plastic = Array.from({ length: 81 }, (_, k) => reach * (k / 80) ** 2);
  const points = /** @type {Point[]} */ ([
    [0, 0],
    ...plastic.map((p) => [p + stress(p) / modulus, stress(p)]),
  ]);
  const nominal = /** @type {Point[]} */ (
    points.map(([e, s]) => [Math.expm1(e), s / Math.exp(e)])
  );
  const xs = range([...points, ...nominal].map(([x]) => x));
  const ys = range([...points, ...nominal].map(([, y]) => y));
  return [
    h(
      'figure',
      { class: 'preview' },
      drawing(points, xs, ys, 'Hardening curve', 'line', nominal),
      h(
        'figcaption',
        {},
        `true stress [${unit('stress', units)}] over total strain; dashed: engineering${
          law.over_depth ? '; at each depth times the factor there' : ''
        }`,
      ),
    ),
  ];
}

/** @param {Record<string, any> | undefined} material @param {Units} units @param {boolean} round whether the bodies are turned about an axis */
export function initialStressPreview(material, units, round) {
  const rows = material?.initial_stress;
  const column = (/** @type {string} */ key) =>
    Array.isArray(rows) ? rows.map((row) => /** @type {Point} */ ([row?.depth, row?.[key]])) : [];
  const [along, across] = [column('sigma_x'), column('sigma_z')];
  if (along.length === 0 || ![...along, ...across].flat().every(Number.isFinite)) return [];
  // Constant beyond the last point.
  const last = Number(along.at(-1)?.[0]);
  const [least, greatest] = range(along.map(([depth]) => depth));
  const end = 1.15 * (greatest || 1);
  const whole = (/** @type {Point[]} */ points) =>
    /** @type {Point[]} */ ([
      ...points,
      ...(last === greatest ? [[end, points.at(-1)?.[1]]] : []),
    ]);
  const stresses = [
    0,
    ...along.map(([, stress]) => stress),
    ...across.map(([, stress]) => stress),
  ];
  return [
    h(
      'figure',
      { class: 'preview' },
      drawing(
        whole(along),
        [Math.min(0, least), end],
        range(stresses),
        `Initial stress, ${along.length} points`,
        'line',
        whole(across),
      ),
      h(
        'figcaption',
        {},
        `stress before the load [${unit('stress', units)}] over depth [${unit('length', units)}]; dashed: ${round ? 'around the axis' : 'out of plane'}`,
      ),
    ),
  ];
}

/** @param {number[]} values @returns {[number, number]} */
const range = (values) => [Math.min(...values), Math.max(...values)];

/**
 * @param {Point[]} points
 * @param {[number, number]} xs
 * @param {[number, number]} ys
 * @param {string} name
 * @param {string} kind of drawing
 * @param {Point[]} [dashed]
 */
function drawing(points, xs, ys, name, kind, dashed) {
  // Figures may be beyond all that can be drawn.
  if (![xs, ys, ...points, ...(dashed ?? [])].flat().every(Number.isFinite)) return null;
  const at = (/** @type {Point} */ [x, y]) => [
    LEFT + ((x - xs[0]) / (xs[1] - xs[0] || 1)) * (WIDTH - LEFT - 8),
    HEIGHT - BOTTOM - ((y - ys[0]) / (ys[1] - ys[0] || 1)) * (HEIGHT - BOTTOM - TOP),
  ];
  const path = (/** @type {Point[]} */ list) =>
    `M${list
      .map((point) =>
        at(point)
          .map((c) => c.toFixed(1))
          .join(' '),
      )
      .join('L')}`;
  const base = HEIGHT - BOTTOM;
  const text = (
    /** @type {number} */ x,
    /** @type {number} */ y,
    /** @type {number} */ value,
    /** @type {string} */ anchor,
  ) => svg('text', { x, y, 'text-anchor': anchor }, plain(Number(value.toPrecision(3))));
  return svg(
    'svg',
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img', 'aria-label': name },
    svg('path', { class: 'axes', d: `M${LEFT} ${TOP}V${base}H${WIDTH - 8}` }),
    kind === 'filled' &&
      svg('path', {
        class: 'ground',
        d: `${path(points)}V${base}H${at(points[0])[0].toFixed(1)}Z`,
      }),
    dashed && svg('path', { class: 'curve dashed', d: path(dashed) }),
    svg('path', { class: 'curve', d: path(points) }),
    text(LEFT - 4, TOP + 8, ys[1], 'end'),
    text(LEFT - 4, base, ys[0], 'end'),
    text(LEFT, HEIGHT - 4, xs[0], 'start'),
    text(WIDTH - 8, HEIGHT - 4, xs[1], 'end'),
  );
}
