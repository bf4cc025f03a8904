/**
 * Curves by uPlot: the page's colours and type, a legend with units that reads out the point under
 * the cursor, a picture to save.
 */

import { h, svg } from '../lib/dom.js';
import { colour, onTheme } from '../lib/theme.js';
import { figure, plain } from '../lib/units.js';
import { chartPng } from './chart-png.js';
import { bareChart, chartSvg, dashOf } from './chart-svg.js';
import { placeWords } from './labels.js';

/** @typedef {any} uPlot */
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
 * @property {boolean} [gaps] whether it is broken where it has no value
 * @property {number} [width] of its line, where that tells curves apart
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
 * @property {string} words what there is to see, for those who do not
 */

const FONT = '11px system-ui, sans-serif';

export class Chart {
  /** @type {Plot | undefined} */
  #plot;
  /**
   * What the curves on the page are of: a hidden chart is drawn when it is seen again.
   * @type {Plot | undefined}
   */
  #drawn;
  /** @type {uPlot} */
  #uplot;
  /** What it was made for: other curves of the same kind only take its data. */
  #made = '';
  /** Whether the next plot is shown whole. */
  #whole = false;

  /** @param {number} [height] */
  constructor(height = 240) {
    this.height = height;
    this.canvas = h('div', { class: 'plot', role: 'img' });
    this.legend = h('ul', { class: 'legend' });
    this.element = h('div', { class: 'chart' }, this.legend, this.canvas);
    this.canvas.addEventListener('pointermove', (event) => this.#readPoint(event));
    this.canvas.addEventListener('pointerleave', () => this.#plot?.turns && this.#read(null));
    new ResizeObserver(() => this.#fit()).observe(this.canvas);
    onTheme(() => {
      this.#made = '';
      this.#draw();
    });
  }

  /** Lets go of the part that was dragged up, with the next plot. */
  whole() {
    this.#whole = true;
  }

  /** @param {Plot} plot */
  show(plot) {
    const kept =
      this.#uplot && this.#drawn?.x === plot.x && !this.#whole ? this.#zoom() : undefined;
    if (this.#whole && this.#uplot) this.#made = '';
    this.#whole = false;
    this.#plot = plot;
    this.canvas.setAttribute('aria-label', plot.words);
    this.#draw(kept);
  }

  /**
   * @param {string} title
   * @returns {Promise<Blob | null>} a PNG with title and legend, on the page's ground
   */
  async picture(title) {
    if (this.#plot?.turns)
      return chartPng(
        chartSvg(this.#plot, title, this.canvas.clientWidth, this.height, colour),
        devicePixelRatio,
      );
    if (!this.#uplot || !this.#plot) return null;
    const { canvas } = this.#uplot.ctx;
    const ratio = devicePixelRatio;
    const rows = this.#legendRows(canvas.width / ratio);
    const head = 26 + 16 * rows.length;
    const copy = h('canvas', { width: canvas.width, height: canvas.height + head * ratio });
    const context = copy.getContext('2d');
    if (!context) return null;
    context.fillStyle = colour('--panel');
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(canvas, 0, head * ratio);
    context.scale(ratio, ratio);
    context.fillStyle = colour('--ink');
    context.font = `bold 12px system-ui, sans-serif`;
    context.fillText(title, 8, 16, copy.width / ratio - 16);
    context.font = FONT;
    rows.forEach((row, k) =>
      row.forEach(({ curve, at }) => drawEntry(context, curve, at, 34 + 16 * k)),
    );
    return new Promise((resolve) => copy.toBlob(resolve));
  }

  /**
   * @param {string} title
   * @returns {SVGSVGElement | null} the same as a vector drawing, on paper
   */
  drawing(title, width = 640, height = this.height) {
    return this.#plot ? chartSvg(this.#plot, title, width, height) : null;
  }

  /** @param {number} width */
  #legendRows(width) {
    const rows = /** @type {{curve: Curve, at: number}[][]} */ ([]);
    const { ctx } = this.#uplot;
    ctx.save();
    ctx.font = FONT;
    let at = Infinity;
    for (const curve of this.#plot?.curves ?? []) {
      const need = 46 + ctx.measureText(curve.label).width;
      if (at + need > width) {
        rows.push([]);
        at = 8;
      }
      rows[rows.length - 1].push({ curve, at });
      at += need;
    }
    ctx.restore();
    return rows;
  }

  /** The cut-out that was dragged up, if it is one. */
  #zoom() {
    const { min, max } = this.#uplot.scales.x;
    const [first, last] = home(/** @type {Plot} */ (this.#drawn));
    const slack = 1e-9 * (last - first);
    return min !== null && (min > first + slack || max < last - slack) ? [min, max] : undefined;
  }

  #fit() {
    const width = this.canvas.clientWidth;
    if (!width) return;
    if (this.#drawn === this.#plot && this.#uplot)
      this.#uplot.setSize({ width, height: this.height });
    else this.#draw();
  }

  /** @param {number[]} [zoom] */
  #draw(zoom) {
    const plot = this.#plot;
    const width = this.canvas.clientWidth;
    if (!plot || !width) return;
    const Plotter = /** @type {any} */ (globalThis).uPlot;
    const tables = plot.curves.map(({ x, y }) => [x, y]);
    // A gap is as wide as from one value to the next, whatever places other curves have between.
    const modes = plot.curves.map(({ gaps }) => [0, gaps ? 2 : 1]);
    const data = tables.length ? Plotter.join(tables, modes) : [[], []];
    this.#drawn = plot;
    if (this.#uplot && kindOf(plot, width) === this.#made) this.#uplot.setData(data);
    else {
      this.#uplot?.destroy();
      this.#uplot = undefined;
      this.canvas.replaceChildren();
      this.#made = kindOf(plot, width);
      if (plot.turns) this.canvas.append(bareChart(plot, width, this.height));
      else this.#uplot = new Plotter(this.#options(plot, width), data, this.canvas);
    }
    if (!this.#uplot) return this.#read(null);
    if (zoom) this.#uplot.setScale('x', { min: zoom[0], max: zoom[1] });
    this.#read(null);
  }

  /** @param {Plot} plot @param {number} width */
  #options(plot, width) {
    const rule = { stroke: colour('--rule'), width: 1 };
    const axis = {
      stroke: colour('--quiet'),
      font: FONT,
      labelFont: FONT,
      labelSize: 16,
      labelGap: 0,
      ticks: { ...rule, size: 4 },
    };
    const values = (/** @type {any} */ _, /** @type {(number | null)[]} */ splits) =>
      splits.map((value) => (value === null ? '' : plain(value)));
    const grid = plot.log ? { ...rule, filter: decades } : rule;
    return {
      width,
      height: this.height,
      legend: { show: false },
      padding: [10, plot.right ? 0 : 24, 0, 0],
      cursor: { points: { size: 5 }, drag: { x: true, y: false, setScale: true } },
      scales: {
        x: { time: false, ...(plot.range && { range: this.#ranged }) },
        y: { distr: plot.log ? 3 : 1 },
        right: {},
      },
      axes: [
        { ...axis, label: plot.x, size: 26, space: apart, grid: { show: false }, values },
        {
          ...axis,
          label: plot.y,
          size: room,
          grid,
          values,
          ...(plot.log && { filter: decades, ticks: { ...rule, size: 4, filter: decades } }),
        },
        ...(plot.right
          ? [
              {
                ...axis,
                label: plot.right,
                size: room,
                scale: 'right',
                side: 1,
                grid: { show: false },
                values,
              },
            ]
          : []),
      ],
      series: [
        {},
        ...plot.curves.map((curve) => ({
          scale: curve.right ? 'right' : 'y',
          stroke: colour(curve.colour),
          width: curve.width ?? (curve.dashed ? 1.25 : 1.75),
          spanGaps: !curve.gaps,
          dash: dashOf(curve),
          points: { show: Boolean(curve.points), size: 5, fill: colour(curve.colour) },
          fill: curve.filled ? `${colour(curve.colour)}18` : undefined,
        })),
      ],
      hooks: {
        draw: [(/** @type {uPlot} */ u) => drawMarks(u, this.#plot)],
        setCursor: [(/** @type {uPlot} */ u) => this.#read(u.cursor.idx)],
      },
    };
  }

  /**
   * The whole abscissa as the curves have it, or a part of it that was dragged up.
   * @type {(u: uPlot, min: number, max: number) => [number, number]}
   */
  #ranged = (u, min, max) => {
    const all = u.data[0];
    const whole = min <= all[0] && max >= all[all.length - 1];
    return whole && this.#plot ? home(this.#plot) : [min, max];
  };

  /**
   * Reads out the point of a loop that is nearest, where a place on the abscissa has several.
   * @param {PointerEvent} event
   */
  #readPoint({ clientX, clientY }) {
    if (!this.#plot?.turns) return;
    const dots = [...this.canvas.querySelectorAll('circle')].map((dot) => {
      const { left, top, width, height } = dot.getBoundingClientRect();
      return { dot, far: Math.hypot(left + width / 2 - clientX, top + height / 2 - clientY) };
    });
    if (dots.length === 0) return;
    const { dataset } = dots.reduce((a, b) => (b.far < a.far ? b : a)).dot;
    this.#write(Number(dataset.x), ({ label }) =>
      label === dataset.label ? Number(dataset.y) : null,
    );
  }

  /**
   * Writes the legend, with figures if the cursor is somewhere.
   * @param {number | null | undefined} index
   */
  #read(index) {
    const x = index == null ? null : this.#uplot?.data[0][index];
    this.#write(x ?? null, (curve) => (x == null ? null : valueAt(curve, x)));
  }

  /**
   * @param {number | null} x where the cursor is
   * @param {(curve: Curve) => number | null} value of a curve there
   */
  #write(x, value) {
    const { curves, x: across = '', y = '', right = '' } = this.#plot ?? { curves: [] };
    this.legend.replaceChildren(
      ...curves.map((curve) =>
        h(
          'li',
          {},
          swatch(curve),
          curve.label,
          x == null ? null : h('b', {}, measured(value(curve), curve.right ? right : y)),
        ),
      ),
      ...(x == null ? [] : [h('li', { class: 'at' }, `at ${measured(x, across)}`)]),
    );
  }
}

/**
 * Pixels from one figure of the abscissa to the next, so that they do not touch.
 * @param {uPlot} u
 * @param {number} _
 * @param {number} from
 * @param {number} to
 */
function apart(u, _, from, to) {
  const longest = Math.max(...[from, to].map((end) => plain(Number(end.toPrecision(3))).length));
  return Math.max(50, 7 * longest + 14);
}

/** Room for the longest figure of an axis. @param {uPlot} u @param {string[] | null} values */
function room(u, values) {
  u.ctx.save();
  u.ctx.font = FONT;
  const widest = Math.max(
    24,
    ...(values ?? []).map((value) => u.ctx.measureText(value ?? '').width),
  );
  u.ctx.restore();
  return Math.ceil(widest) + 14;
}

/** The whole abscissa. @param {Plot} plot @returns {[number, number]} */
const home = ({ range, curves }) =>
  range ?? [
    Math.min(...curves.map(({ x }) => x[0])),
    Math.max(...curves.map(({ x }) => x[x.length - 1])),
  ];

/** What a plotter is made for beside the figures. @param {Plot} plot @param {number} width */
const kindOf = ({ x, y, right, log, turns, range, curves, words }, width) =>
  JSON.stringify([
    [width, x, y, right, log, range !== undefined, turns && words],
    curves.map(({ label, colour, dashed, dash, right, points, filled, gaps, width }) => [
      label,
      colour,
      dashed,
      dash,
      right,
      points,
      filled,
      gaps,
      width,
    ]),
  ]);

/** @param {Curve} curve @param {number} x @returns {number | null} between its points */
function valueAt(curve, x) {
  const next = curve.x.findIndex((one) => one >= x);
  if (next < 0) return null;
  const [a, b] = [curve.y[next - 1], curve.y[next]];
  if (curve.x[next] === x || a == null || b == null) return curve.x[next] === x ? b : null;
  const t = (x - curve.x[next - 1]) / (curve.x[next] - curve.x[next - 1]);
  return a + t * (b - a);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Curve} curve
 * @param {number} x
 * @param {number} y
 */
function drawEntry(context, curve, x, y) {
  context.strokeStyle = colour(curve.colour);
  context.lineWidth = curve.width ?? 2;
  context.setLineDash(dashOf(curve) ?? []);
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x + 24, y - 4);
  context.stroke();
  context.fillText(curve.label, x + 30, y);
}

/**
 * A figure with the unit that the label of its axis has in brackets.
 * @param {number | null} value
 * @param {string} label
 */
const measured = (value, label) =>
  [figure(value, 4), value === null ? '' : /\[(.+)\]/.exec(label)?.[1]].filter(Boolean).join(' ');

/** @param {Curve} curve */
function swatch(curve) {
  const line = svg('path', {
    d: 'M0 4h24',
    'stroke-width': curve.width ?? 2,
    'stroke-dasharray': dashOf(curve)?.join(' '),
  });
  line.style.stroke = `var(${curve.colour})`;
  return svg('svg', { class: 'swatch', viewBox: '0 0 24 8', 'aria-hidden': 'true' }, line);
}

/** @param {number | null} value */
const isDecade = (value) =>
  value !== null && Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6;

/** Only powers of ten are worth a line. @param {any} _ @param {(number | null)[]} splits */
const decades = (_, splits) => {
  const powers = splits.filter(isDecade).length;
  // Of many there is room for some.
  const every = Math.ceil(powers / 9);
  return splits.map((value) =>
    isDecade(value) && Math.round(Math.log10(value ?? 1)) % every === 0 ? value : null,
  );
};

/** @param {uPlot} u @param {Plot | undefined} plot */
function drawMarks(u, plot) {
  const { ctx, bbox } = u;
  const ratio = devicePixelRatio;
  const box = {
    left: bbox.left,
    right: bbox.left + bbox.width,
    top: bbox.top,
    bottom: bbox.top + bbox.height,
  };
  ctx.save();
  ctx.lineWidth = ratio;
  ctx.textAlign = 'left';
  ctx.textBaseline = 'alphabetic';
  ctx.setLineDash([2 * ratio, 3 * ratio]);
  ctx.font = `${11 * ratio}px system-ui, sans-serif`;
  const seen = (plot?.marks ?? []).flatMap((mark) => {
    const at = Math.round(u.valToPos(mark.at, mark.across, true));
    const [from, to] = mark.across === 'x' ? [box.left, box.right] : [box.top, box.bottom];
    return at >= from && at <= to
      ? [{ ...mark, at, width: ctx.measureText(mark.text).width }]
      : [];
  });
  for (const { across, at, colour: name } of seen) {
    ctx.strokeStyle = colour(name ?? '--quiet');
    ctx.beginPath();
    ctx.moveTo(
      ...(across === 'x'
        ? /** @type {const} */ ([at, box.top])
        : /** @type {const} */ ([box.left, at])),
    );
    ctx.lineTo(
      ...(across === 'x'
        ? /** @type {const} */ ([at, box.bottom])
        : /** @type {const} */ ([box.right, at])),
    );
    ctx.stroke();
  }
  const curves = (plot?.curves ?? []).map(({ x, y, right }) =>
    x.flatMap((value, k) => {
      const height = y[k];
      return height === null
        ? []
        : [
            /** @type {[number, number]} */ ([
              u.valToPos(value, 'x', true),
              u.valToPos(height, right ? 'right' : 'y', true),
            ]),
          ];
    }),
  );
  placeWords(seen, curves, box, ratio).forEach(({ x, y }, k) => {
    ctx.fillStyle = colour(seen[k].colour ?? '--quiet');
    label(ctx, seen[k].text, x, y, ratio);
  });
  ctx.restore();
}

/**
 * A text on the ground of the page, so that no line strikes it through.
 * @param {CanvasRenderingContext2D} ctx
 * @param {string} text
 * @param {number} x
 * @param {number} y of its base line
 * @param {number} ratio of pixels
 */
function label(ctx, text, x, y, ratio) {
  if (!text) return;
  const { width } = ctx.measureText(text);
  const ink = ctx.fillStyle;
  ctx.fillStyle = colour('--panel');
  ctx.fillRect(x - 2 * ratio, y - 10 * ratio, width + 4 * ratio, 13 * ratio);
  ctx.fillStyle = ink;
  ctx.fillText(text, x, y);
}
