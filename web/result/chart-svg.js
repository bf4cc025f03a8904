/**
 * A chart as SVG: on the page, and by itself with title and legend in the light colours of paper.
 */

import { h, pngOf, svg, uniqueId } from '../lib/dom.js';
import { paper } from '../lib/theme.js';
import { plain } from '../lib/units.js';
import { placeWords } from './labels.js';

/**
 * @typedef {object} Curve
 * @property {string} label
 * @property {string} colour a custom property
 * @property {number[]} x
 * @property {(number | null)[]} y
 * @property {boolean} [dashed]
 * @property {number[]} [dash] lengths of strokes and gaps, where curves have to be told apart
 *   without their colours
 * @property {boolean} [right] on the second ordinate
 * @property {boolean} [points]
 * @property {boolean} [filled]
 * @property {number} [width] of its line, where that tells curves apart
 * @property {number[]} [to] ordinates at the other side of a band, in place of a line
 *
 * @typedef {object} Mark a line across
 * @property {'x' | 'y'} across which axis it stands on
 * @property {number} at
 * @property {string} text
 * @property {boolean} [left] where the text of a level line stands
 * @property {string} [colour]
 *
 * @typedef {object} Plot
 * @property {string} x label with unit
 * @property {string} y label with unit
 * @property {string} [right] label with unit
 * @property {boolean} [log]
 * @property {boolean} [turns] whether curves turn back, as loops do
 * @property {Curve[]} curves
 * @property {Mark[]} [marks]
 * @property {[number, number]} [range] of x to begin with
 * @property {Ranges} [held] that every axis has at least
 * @property {string} words what there is to see, for those who do not
 */
/** @typedef {{at: (value: number) => number, of: (pixel: number) => number, ticks: number[], from: number, to: number}} Axis `of`: the value at a pixel */
/** @typedef {{x: [number, number], y: [number, number], right: [number, number]}} Ranges of the axes */
/** @typedef {{root: SVGSVGElement, width: number, box: import('./labels.js').Box, x: Axis, y: Axis, right: Axis}} Layout */

/** Width of a letter at 11 px, on average. */
const LETTER = 6;
const LINE = 16;

/** Colours of the drawing under way, by name: those of paper, or of the page. */
let ink = paper;

/**
 * @param {Plot} plot
 * @param {string} title
 * @param {number} width
 * @param {number} height of the axes' box and what belongs to it, without title and legend
 * @param {(name: string) => string} [colours] by name
 * @returns {SVGSVGElement}
 */
export const chartSvg = (plot, title, width, height, colours = paper) =>
  laidOut(plot, title, width, height, colours).root;

/** What the axes of a plot show. @param {Plot} plot @returns {Ranges} */
export function rangesOf({ curves, range, marks = [], log, held }) {
  const own = range ?? extent(curves.flatMap(({ x }) => x));
  const x = held ? united(own, held.x) : own;
  const seen = (/** @type {boolean} */ right) =>
    curves
      .filter((curve) => Boolean(curve.right) === right)
      .flatMap((curve) =>
        [curve.y, curve.to ?? []].flatMap((values) =>
          values.filter((value, k) => value !== null && curve.x[k] >= x[0] && curve.x[k] <= x[1]),
        ),
      );
  const level = marks.filter(({ across }) => across === 'y').map(({ at }) => at);
  const [y, right] = [grown(seen(false), log, level), grown(seen(true), false, [])];
  return held ? { x, y: united(y, held.y), right: united(right, held.right) } : { x, y, right };
}

/** @param {[number, number]} a @param {[number, number]} b @returns {[number, number]} */
const united = (a, b) => [Math.min(a[0], b[0]), Math.max(a[1], b[1])];

/**
 * @param {Plot} plot
 * @param {string} title with a legend below it; none on the page, which has its own
 * @param {number} width
 * @param {number} height
 * @param {(name: string) => string} colours by name
 * @returns {Layout}
 */
export function laidOut(plot, title, width, height, colours) {
  ink = colours;
  const legend = title ? legendRows(plot.curves, width) : [];
  const head = title ? 22 + LINE * legend.length : 0;
  const ranges = rangesOf(plot);
  const labels = (/** @type {number[]} */ ticks) =>
    Math.max(0, ...ticks.map((tick) => plain(tick).length)) * LETTER;
  const box = { left: 0, right: width - 10, top: head + 6, bottom: head + height - 38 };
  const yTicks = ticksOf(ranges.y, 5, plot.log);
  box.left = labels(yTicks) + 30;
  const rightTicks = plot.right ? ticksOf(ranges.right, 5) : [];
  if (plot.right) box.right = width - labels(rightTicks) - 30;
  // Room for the figures at the ends, and some between them.
  const apart = Math.max(80, labels(ranges.x.map((end) => Number(end.toPrecision(3)))) + 24);
  const xTicks = ticksOf(ranges.x, Math.floor((box.right - box.left) / apart));
  // A figure stands with its middle below its place, that at the right end too.
  if (!plot.right) box.right = width - Math.max(10, labels(xTicks.slice(-1)) / 2 + 4);
  const x = axis(ranges.x, [box.left, box.right], xTicks);
  const y = axis(ranges.y, [box.bottom, box.top], yTicks, plot.log);
  const right = axis(ranges.right, [box.bottom, box.top], rightTicks);
  const clip = uniqueId('clip');
  const root = svg('svg', {
    xmlns: 'http://www.w3.org/2000/svg',
    viewBox: `0 0 ${width} ${head + height}`,
    width,
    height: head + height,
    // On the page its frame is the picture, and has the name.
    ...(title ? { role: 'img', 'aria-label': plot.words } : {}),
    'font-family': 'system-ui, sans-serif',
    'font-size': 11,
  });
  // By itself it lies on whatever the viewer has.
  if (title)
    root.append(
      svg('rect', { width: '100%', height: '100%', fill: ink('--panel') }),
      svg(
        'text',
        {
          x: 4,
          y: 14,
          'font-weight': 'bold',
          'font-size': 12,
          fill: ink('--ink'),
          ...squeezed(title, width - 8),
        },
        title,
      ),
    );
  const of = (/** @type {Curve} */ curve) => (curve.right ? right : y);
  root.append(
    svg(
      'defs',
      {},
      svg(
        'clipPath',
        { id: clip },
        svg('rect', {
          x: box.left,
          y: box.top,
          width: Math.max(0, box.right - box.left),
          height: Math.max(0, box.bottom - box.top),
        }),
      ),
    ),
    ...legend.flatMap((row, k) =>
      row.map(({ curve, at }) => legendItem(curve, at, 30 + LINE * k)),
    ),
    ...grid(plot, x, y, right, box),
    svg(
      'g',
      { 'clip-path': `url(#${clip})`, fill: 'none' },
      plot.curves.flatMap((curve) => [
        ...area(curve, x, of(curve)),
        ...(curve.to ? [] : [path(curve, x, of(curve))]),
      ]),
    ),
    // Whole where they lie on the frame.
    ...plot.curves.flatMap((curve) => (curve.points ? dots(curve, x, of(curve), box) : [])),
    ...marksOf(plot, x, y, right, box),
  );
  return { root, width, box, x, y, right };
}

/** What lies below a curve, or between both sides of a band. @param {Curve} curve @param {Axis} x @param {Axis} y */
function area({ x: along, y: up, to, filled, colour: name }, x, y) {
  if (!to && !filled) return [];
  const point = (/** @type {number} */ value, /** @type {number | null} */ height) =>
    `${x.at(value).toFixed(1)} ${y.at(height ?? 0).toFixed(1)}`;
  const back = along.map((value, k) => point(value, to?.[k] ?? 0)).reverse();
  const d = `M${[...along.map((value, k) => point(value, up[k])), ...back].join('L')}Z`;
  return [svg('path', { d, fill: ink(name), 'fill-opacity': to ? 0.18 : 0.09 })];
}

/** Width of a bold letter at 12 px, on average. */
const BOLD = 7;

/**
 * A line that would leave the drawing is made as long as there is room.
 * @param {string} text
 * @param {number} room
 */
const squeezed = (text, room) =>
  BOLD * text.length > room ? { textLength: room, lengthAdjust: 'spacingAndGlyphs' } : {};

/** @param {SVGSVGElement} picture @returns {Blob} */
export const svgFile = (picture) => new Blob([textOf(picture)], { type: 'image/svg+xml' });

/** @param {SVGSVGElement} picture @param {number} ratio of pixels @returns {Promise<Blob | null>} */
export async function pngFile(picture, ratio) {
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(textOf(picture))}`;
  await image.decode();
  const [width, height] = [image.width, image.height].map((size) => Math.round(size * ratio));
  const canvas = h('canvas', { width, height });
  canvas.getContext('2d')?.drawImage(image, 0, 0, width, height);
  return pngOf(canvas);
}

/** @param {SVGSVGElement} picture */
const textOf = (picture) => new XMLSerializer().serializeToString(picture);

/**
 * @param {Plot} plot
 * @param {Axis} x
 * @param {Axis} y
 * @param {Axis} yr
 * @param {{left: number, right: number, top: number, bottom: number}} box
 */
function grid(plot, x, y, yr, box) {
  const text = (/** @type {Record<string, any>} */ where, /** @type {string} */ words) =>
    svg('text', { fill: ink('--quiet'), ...where }, words);
  const line = (/** @type {string} */ d, /** @type {string} */ stroke) =>
    svg('path', { d, stroke: ink(stroke), fill: 'none' });
  const turned = (/** @type {number} */ at, /** @type {string} */ words) =>
    text(
      {
        x: 0,
        y: 0,
        'text-anchor': 'middle',
        transform: `translate(${at} ${(box.top + box.bottom) / 2}) rotate(-90)`,
      },
      words,
    );
  return [
    ...y.ticks.map((tick) => line(`M${box.left} ${y.at(tick).toFixed(1)}H${box.right}`, '--rule')),
    line(
      `M${box.left} ${box.top}V${box.bottom}H${box.right}${plot.right ? `V${box.top}` : ''}`,
      '--edge',
    ),
    ...y.ticks.map((tick) =>
      text({ x: box.left - 5, y: y.at(tick) + 4, 'text-anchor': 'end' }, plain(tick)),
    ),
    ...x.ticks.map((tick) => line(`M${x.at(tick).toFixed(1)} ${box.bottom}v4`, '--edge')),
    ...x.ticks.map((tick) =>
      text({ x: x.at(tick), y: box.bottom + 16, 'text-anchor': 'middle' }, plain(tick)),
    ),
    ...(plot.right
      ? yr.ticks.map((tick) => text({ x: box.right + 5, y: yr.at(tick) + 4 }, plain(tick)))
      : []),
    text({ x: (box.left + box.right) / 2, y: box.bottom + 32, 'text-anchor': 'middle' }, plot.x),
    turned(11, plot.y),
    plot.right
      ? turned(
          box.right +
            (box.right > 0
              ? Math.max(0, ...yr.ticks.map((tick) => plain(tick).length)) * LETTER + 20
              : 0),
          plot.right,
        )
      : svg('g'),
  ];
}

/** @param {Curve} curve @param {Axis} x @param {Axis} y */
function path(curve, x, y) {
  let d = '';
  let pen = false;
  curve.x.forEach((value, k) => {
    const at = curve.y[k];
    if (at === null || !Number.isFinite(at)) pen = false;
    else {
      d += `${pen ? 'L' : 'M'}${x.at(value).toFixed(2)} ${y.at(at).toFixed(2)}`;
      pen = true;
    }
  });
  return svg('path', {
    d,
    stroke: ink(curve.colour),
    'stroke-width': curve.width ?? (curve.dashed ? 1.1 : 1.6),
    'stroke-dasharray': dashOf(curve)?.join(' '),
  });
}

/** @param {Curve} curve @param {Axis} x @param {Axis} y @param {import('./labels.js').Box} box */
const dots = (curve, x, y, box) =>
  curve.x.flatMap((value, k) => {
    const [cx, cy] = [x.at(value), y.at(curve.y[k] ?? NaN)];
    const isSeen =
      cx >= box.left - 0.5 &&
      cx <= box.right + 0.5 &&
      cy >= box.top - 0.5 &&
      cy <= box.bottom + 0.5;
    const of = { 'data-x': value, 'data-y': curve.y[k], 'data-label': curve.label };
    return isSeen ? [svg('circle', { cx, cy, r: 2.2, fill: ink(curve.colour), ...of })] : [];
  });

/** @param {Curve} curve @returns {number[] | undefined} */
export const dashOf = (curve) => curve.dash ?? (curve.dashed ? [5, 4] : undefined);

/**
 * @param {Plot} plot
 * @param {Axis} x
 * @param {Axis} y
 * @param {Axis} yr
 * @param {import('./labels.js').Box} box
 */
function marksOf(plot, x, y, yr, box) {
  const seen = (plot.marks ?? []).flatMap((mark) => {
    const at = mark.across === 'x' ? x.at(mark.at) : y.at(mark.at);
    const [from, to] = mark.across === 'x' ? [box.left, box.right] : [box.top, box.bottom];
    return at >= from - 0.5 && at <= to + 0.5
      ? [{ ...mark, at, width: mark.text.length * LETTER }]
      : [];
  });
  const curves = plot.curves.map((curve) =>
    curve.x.flatMap((value, k) => {
      const height = curve.y[k];
      return height === null
        ? []
        : [/** @type {[number, number]} */ ([x.at(value), (curve.right ? yr : y).at(height)])];
    }),
  );
  return [
    ...seen.map(({ across, at, colour: name }) =>
      svg('path', {
        d: across === 'x' ? `M${at} ${box.top}V${box.bottom}` : `M${box.left} ${at}H${box.right}`,
        stroke: ink(name ?? '--quiet'),
        'stroke-dasharray': '2 3',
      }),
    ),
    ...placeWords(seen, curves, box).map((place, k) =>
      svg(
        'text',
        {
          ...place,
          fill: ink(seen[k].colour ?? '--quiet'),
          stroke: ink('--panel'),
          'stroke-width': 3,
          'paint-order': 'stroke',
        },
        seen[k].text,
      ),
    ),
  ];
}

/** Entries of the legend in rows that fit. @param {Curve[]} curves @param {number} width */
function legendRows(curves, width) {
  const rows = /** @type {{curve: Curve, at: number}[][]} */ ([]);
  let at = Infinity;
  for (const curve of curves) {
    const need = 46 + (curve.label.length + (curve.right ? 8 : 0)) * LETTER;
    if (at + need > width) {
      rows.push([]);
      at = 4;
    }
    rows[rows.length - 1].push({ curve, at });
    at += need;
  }
  return rows;
}

/** @param {Curve} curve @param {number} x @param {number} y */
const legendItem = (curve, x, y) =>
  svg(
    'g',
    {},
    svg('path', {
      d: `M${x} ${y - 4}h24`,
      stroke: ink(curve.colour),
      'stroke-width': curve.width ?? 1.8,
      'stroke-dasharray': dashOf(curve)?.join(' '),
    }),
    svg(
      'text',
      { x: x + 30, y, fill: ink('--ink') },
      curve.label + (curve.right ? ' (right)' : ''),
    ),
  );

/** @param {number[]} values @returns {[number, number]} */
function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low < high
    ? [low, high]
    : [Number.isFinite(low) ? low : 0, (Number.isFinite(low) ? low : 0) + 1];
}

/**
 * Range of an ordinate, from zero where nothing is negative.
 * @param {(number | null)[]} values
 * @param {boolean | undefined} log
 * @param {number[]} marks
 * @returns {[number, number]}
 */
function grown(values, log, marks) {
  const given = /** @type {number[]} */ (
    values.filter((value) => value !== null && Number.isFinite(value))
  );
  if (log) {
    const [low, high] = extent(given.filter((value) => value > 0));
    if (!(low > 0)) return [0.1, 1];
    return [10 ** Math.floor(Math.log10(low)), 10 ** Math.ceil(Math.log10(high))];
  }
  const [low, high] = extent([0, ...given, ...marks]);
  const size = high - low;
  return [low < 0 ? low - 0.04 * size : 0, high > 0 ? high + 0.04 * size : 0];
}

/**
 * @param {[number, number]} range
 * @param {number} many
 * @param {boolean} [log]
 * @returns {number[]}
 */
function ticksOf([from, to], many, log) {
  if (log) {
    const [first, last] = [Math.round(Math.log10(from)), Math.round(Math.log10(to))];
    // Of many powers there is room for some.
    const every = Math.ceil((last - first + 1) / 9);
    return Array.from({ length: last - first + 1 }, (_, k) => 10 ** (first + k)).filter(
      (_, k) => (first + k) % every === 0,
    );
  }
  const rough = (to - from) / Math.max(2, many);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 2.5, 5].find((one) => one * power >= rough) ?? 10);
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, k) =>
    Number(((first + k) * step).toPrecision(12)),
  );
}

/**
 * @param {[number, number]} range
 * @param {[number, number]} pixels
 * @param {number[]} ticks
 * @param {boolean} [log]
 * @returns {Axis}
 */
function axis([from, to], [low, high], ticks, log) {
  const place = log ? Math.log10 : (/** @type {number} */ value) => value;
  const [a, b] = [place(from), place(to)];
  return {
    from,
    to,
    ticks,
    at: (value) => low + ((place(value) - a) / (b - a || 1)) * (high - low),
    of: (pixel) => {
      const value = a + ((pixel - low) / (high - low || 1)) * (b - a);
      return log ? 10 ** value : value;
    },
  };
}
