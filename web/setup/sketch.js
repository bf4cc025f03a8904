/**
 * The two bodies to scale, how they are held, what presses them, and how wide Hertz's contact is.
 */

import { byId, svg } from '../lib/dom.js';
import { numberOf } from '../lib/number.js';
import { exact, figure, unit, unitsOf } from '../lib/units.js';
import { cutOut, outline, pin } from './outline.js';
import { BOLD, LETTER, WIDTH, loadLine, travel } from './load-line.js';
import { sections } from './sections.js';
import { counted, touching } from './touching.js';

/** @typedef {import('./outline.js').Outline} Outline */
/** @typedef {import('./check.js').Hertz} Hertz */
/** @typedef {(x: number, y: number) => [number, number]} Scale from the section to the picture */

const [HEIGHT, MARGIN] = [216, 22];

/** @param {import('./draft.js').Draft} draft */
export function startSketch(draft) {
  const place = byId('sketch');
  let hertz = /** @type {Hertz | null} */ (null);
  const draw = () => {
    place.replaceChildren(picture(draft.job, hertz));
  };
  draft.addEventListener('change', draw);
  return (/** @type {Hertz | null} */ answer) => {
    hertz = answer;
    draw();
  };
}

/** Shapes that a hole may hold. */
const ROUND = new Set(['cylinder', 'sphere']);

/** @param {import('../types.js').Job} job @param {Hertz | null} hertz */
export function picture(job, hertz) {
  if (job.analysis === 'three_dimensional') return sections(job);
  const shapes = [job.upper?.shape, job.lower?.shape];
  const inHole = shapes.some((shape) => shape?.type === 'hole');
  const whole = shapes.map((shape) =>
    inHole && ROUND.has(shape?.type) && outline(shape)
      ? pin(numberOf(shape.radius))
      : outline(shape),
  );
  const root = svg('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: 'img',
    'aria-label': words(job),
  });
  const bodies = inHole ? whole : cutOut(whole);
  const drawn = bodies.filter((body) => body !== null);
  if (drawn.length === 0) return root;
  const length = unit('length', unitsOf(job));
  const labels = [
    sizeWords(job.upper, whole[0], length),
    sizeWords(job.lower, whole[1], length),
    widthWords(job, hertz),
  ];
  // A pin and its hole touch at the bottom; others come together first.
  const [above, below] = bodies;
  const meeting = above && below && !inHole ? touching(above, below) : { raise: 0, places: [] };
  if (above) bodies[0] = counted(above, meeting.raise);
  const places = meeting.places.length
    ? meeting.places
    : [/** @type {[number, number]} */ ([0, 0])];
  const scale = fit(
    bodies[0],
    bodies[1],
    16 + LETTER * Math.max(...labels.map((label) => label.length)),
  );
  bodies.forEach((body, k) => {
    const name = k === 0 ? 'upper' : 'lower';
    if (body) root.append(...drawBody(body, k === 0 ? -1 : 1, job[name], scale, labels[k]));
  });
  if (job.analysis === 'axisymmetric') {
    root.append(
      svg('line', { class: 'axis', x1: WIDTH / 2, x2: WIDTH / 2, y1: 6, y2: HEIGHT - 6 }),
    );
  }
  root.append(
    ...load(job, bodies[0], scale, middleOf(places)),
    ...contact(job, hertz, scale, places),
  );
  return root;
}

/** @param {Outline | null} upper @param {Outline | null} lower @param {number} side room for words beside them @returns {Scale} */
function fit(upper, lower, side) {
  const points = (/** @type {Outline | null} */ body) => [
    ...(body?.surface ?? []),
    ...(body?.edge ?? []),
  ];
  const xs = [...points(upper), ...points(lower)].map(([x]) => x);
  const [left, right] = [Math.min(...xs), Math.max(...xs)];
  const top = Math.max(-(upper?.base ?? 0), ...points(lower).map(([, h]) => h));
  const bottom = Math.min(lower?.base ?? 0, ...points(upper).map(([, h]) => -h));
  const size = Math.min(
    (WIDTH - 2 * side) / (right - left || 1),
    (HEIGHT - 2 * MARGIN) / (top - bottom || 1),
  );
  const [across, middle] = [(left + right) / 2, (top + bottom) / 2];
  return (x, y) => [WIDTH / 2 + (x - across) * size, HEIGHT / 2 - (y - middle) * size];
}

/**
 * @param {Outline} body
 * @param {1 | -1} up whether its heights are the section's
 * @param {Record<string, any>} of
 * @param {Scale} scale
 * @param {string} size in words
 */
function drawBody(body, up, of, scale, size) {
  const closed = (/** @type {import('./outline.js').Point[]} */ points) =>
    `M${points
      .map(([x, h]) =>
        scale(x, up * h)
          .map((c) => c.toFixed(2))
          .join(' '),
      )
      .join('L')}Z`;
  if (body.edge) {
    const edge = closed(body.edge);
    return [
      svg('path', {
        class: `body around${of?.material?.rigid ? ' rigid' : ''}`,
        'fill-rule': 'evenodd',
        d: edge + closed(body.surface),
      }),
      svg('path', { class: 'rim', fill: 'none', d: closed(body.surface) }),
      svg('path', { class: body.broken ? 'broken' : 'held', fill: 'none', d: edge }),
      svg('text', { x: 8, y: scale(0, up * body.base)[1] - up * 8 }, size),
    ];
  }
  const points = body.surface.map(([x, h]) => scale(x, up * h));
  const [left, right] = [body.surface[0][0], body.surface[body.surface.length - 1][0]];
  const corners = [scale(right, up * body.base), scale(left, up * body.base)];
  const path = `M${[...points, ...corners].map((point) => point.map((c) => c.toFixed(2)).join(' ')).join('L')}Z`;
  const [[x1, y], [x0]] = corners;
  return [
    svg('path', {
      class: `body${of?.material?.rigid ? ' rigid' : ''}${body.broken ? ' around' : ''}`,
      d: path,
    }),
    ...(body.broken
      ? [
          svg('path', {
            class: 'rim',
            fill: 'none',
            d: `M${points.map((p) => p.map((c) => c.toFixed(2)).join(' ')).join('L')}`,
          }),
        ]
      : []),
    // A pin in a hole is held over its whole section.
    ...(body.broken
      ? [svg('path', { class: 'broken', fill: 'none', d: brokenOff(corners, points) })]
      : x1 > x0
        ? support(x0, x1, y, up, of?.support === 'roller')
        : []),
    svg('text', { x: 8, y: (y + scale(0, 0)[1]) / 2 + 4 }, size),
  ];
}

/** The sides where a body goes on. @param {[number, number][]} corners @param {[number, number][]} points */
function brokenOff([right, left], points) {
  const write = (/** @type {[number, number]} */ at) => at.map((c) => c.toFixed(2)).join(' ');
  return `M${[points[0], left, right, points[points.length - 1]].map(write).join('L')}`;
}

/** @param {Record<string, any> | undefined} of @param {Outline | null} body @param {string} length its unit */
function sizeWords(of, body, length) {
  const { type, radius } = of?.shape ?? {};
  if (!body) return '';
  if (ROUND.has(type)) return `R ${exact(numberOf(radius))} ${length}`;
  if (type === 'groove' || type === 'hole')
    return `${type} R ${exact(numberOf(radius))} ${length}`;
  const [left, right] = [body.surface[0][0], body.surface[body.surface.length - 1][0]];
  return `${exact(right - left)} × ${exact(-body.base)} ${length}`;
}

/** @param {import('../types.js').Job} job @param {Hertz | null} hertz @returns {string} Hertz's width, if there is one */
function widthWords(job, hertz) {
  const width = Math.max(0, ...(hertz?.steps ?? []).map((step) => step.half_width));
  return width > 0 ? `2a ${figure(2 * width, 3)} ${unit('length', unitsOf(job))}` : '';
}

/** @param {number} x0 @param {number} x1 @param {number} y @param {1 | -1} up @param {boolean} roller */
function support(x0, x1, y, up, roller) {
  const many = Math.max(4, Math.round((x1 - x0) / 9));
  const at = (/** @type {number} */ k) => x0 + ((x1 - x0) * (k + 0.5)) / many;
  const ticks = Array.from({ length: many }, (_, k) =>
    roller
      ? svg('circle', { class: 'support', cx: at(k), cy: y + up * 3, r: 2.2 })
      : svg('path', { class: 'support', d: `M${at(k) + 3} ${y}l-6 ${up * 6}` }),
  );
  return [svg('line', { class: 'held', x1: x0, x2: x1, y1: y, y2: y }), ...ticks];
}

/** @param {[number, number][]} places */
const middleOf = (places) => (places[0][0] + places[places.length - 1][0]) / 2;

/** @param {import('../types.js').Job} job @param {Outline | null} upper @param {Scale} scale @param {number} middle of the places that touch */
function load(job, upper, scale, middle) {
  if (!upper) return [];
  const [x, y] = scale(middle, -upper.base);
  const text = loadLine(job);
  const left = Math.max(4, Math.min(x + 8, WIDTH - 4 - BOLD * text.length));
  return [
    svg('path', { class: 'arrow', d: `M${x} ${y - 20}v16m-3.500 -5l3.500 5l3.500 -5` }),
    // Long words reach to the left of the force.
    ...travel(job, Math.min(x, left + 6), y - 12),
    svg('text', { x: left, y: y - 9, class: 'load' }, text),
  ];
}

/** @param {import('../types.js').Job} job @param {Hertz | null} hertz @param {Scale} scale @param {[number, number][]} places where the bodies touch */
function contact(job, hertz, scale, places) {
  const width = Math.max(0, ...(hertz?.steps ?? []).map((step) => step.half_width));
  const [[x, y], ...others] = places.map((place) => scale(...place));
  if (width === 0)
    return [[x, y], ...others].map(([cx, cy]) =>
      svg('circle', { class: 'contact', cx, cy, r: 2.5 }),
    );
  const half = Math.max(1.5, scale(width, 0)[0] - scale(0, 0)[0]);
  return [
    svg('line', { class: 'contact', x1: x - half, x2: x + half, y1: y, y2: y }),
    svg('path', { class: 'leader', d: `M${x + half + 2} ${y}H${WIDTH - 88}` }),
    svg('text', { x: WIDTH - 4, y: y - 4, class: 'note' }, 'Hertz'),
    svg('text', { x: WIDTH - 4, y: y + 10, class: 'note' }, widthWords(job, hertz)),
  ];
}

/** @param {import('../types.js').Job} job */
const words = (job) =>
  `Section through the contact, to scale: ${job.upper?.shape?.type ?? 'nothing'} above, ${job.lower?.shape?.type ?? 'nothing'} below.`;
