/**
 * Curves on the page: one drawing for screen and paper, with a legend that reads out the place
 * under the pointer, a part that is dragged up, and the axes that a moving slider leaves alone.
 */

import { h, svg } from '../lib/dom.js';
import { colour, onTheme } from '../lib/theme.js';
import { figure } from '../lib/units.js';
import { chartSvg, dashOf, laidOut, pngFile, rangesOf } from './chart-svg.js';

/** @typedef {import('./chart-svg.js').Curve} Curve */
/** @typedef {import('./chart-svg.js').Plot} Plot */

/** Pixels below which a drag is a click. */
const CLICK = 6;

/** Width of a picture of a chart that is folded away [px]. */
const UNSEEN = 640;

export class Chart {
  /** @type {Plot | undefined} */
  #plot;
  /** What is drawn: a hidden chart is drawn when it is seen again. @type {Plot | undefined} */
  #drawn;
  /** @type {import('./chart-svg.js').Layout | undefined} */
  #layout;
  /** Part of the abscissa that was dragged up. @type {[number, number] | undefined} */
  #zoom;
  /** Where a drag began [px]. */
  #from = NaN;
  /** Curves and axes from which a slider set out. @type {{plot: Plot, ranges: import('./chart-svg.js').Ranges} | undefined} */
  #start;

  /** @param {number} [height] */
  constructor(height = 240) {
    this.height = height;
    this.canvas = h('div', { class: 'plot', role: 'img' });
    this.legend = h('ul', { class: 'legend' });
    this.element = h('div', { class: 'chart' }, this.legend, this.canvas);
    this.canvas.addEventListener('pointermove', (event) => this.#move(event));
    this.canvas.addEventListener('pointerleave', () => this.#leave());
    this.canvas.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || event.pointerType === 'touch' || this.#plot?.turns) return;
      this.#from = this.#placeOf(event)[0];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointerup', (event) => this.#drop(event));
    this.canvas.addEventListener('dblclick', () => {
      this.#zoom = undefined;
      this.#draw();
    });
    new ResizeObserver(() => this.#fit()).observe(this.canvas);
    onTheme(() => this.#draw());
  }

  /** Lets go of the part that was dragged up, with the next plot. */
  whole() {
    this.#zoom = undefined;
  }

  /** @param {boolean} on whether the axes hold, and what was shown stays in grey */
  hold(on) {
    if (!on) this.#start = undefined;
    else if (!this.#start && this.#plot)
      this.#start = { plot: this.#plot, ranges: rangesOf(this.#plot) };
  }

  /** @param {Plot} plot */
  show(plot) {
    if (this.#plot?.x !== plot.x) this.#zoom = undefined;
    this.#plot = this.#held(plot);
    this.canvas.setAttribute('aria-label', plot.words);
    this.#draw();
  }

  /** With the curves and on the axes from which a slider set out. @param {Plot} plot @returns {Plot} */
  #held(plot) {
    const start = this.#start;
    if (!start || start.plot.x !== plot.x || start.plot.y !== plot.y) return plot;
    const before = start.plot.curves
      .filter(({ dashed, right }) => !dashed && !right)
      .slice(0, 1)
      .map((curve) => ({
        ...curve,
        label: 'before',
        colour: '--edge',
        filled: false,
        points: false,
      }));
    const held = rangesOf({ ...plot, held: start.ranges });
    start.ranges = held;
    return { ...plot, held, range: held.x, curves: [...before, ...plot.curves] };
  }

  /**
   * @param {string} title
   * @returns {Promise<Blob | null>} a PNG with title and legend, on the page's ground
   */
  async picture(title) {
    if (!this.#plot) return null;
    const plot = this.#seen(this.#plot);
    return pngFile(
      chartSvg(plot, title, this.canvas.clientWidth || UNSEEN, this.height, colour),
      devicePixelRatio,
    );
  }

  /**
   * @param {string} title
   * @returns {SVGSVGElement | null} the same as a vector drawing, on paper
   */
  drawing(title, width = 640, height = this.height) {
    return this.#plot ? chartSvg(this.#plot, title, width, height) : null;
  }

  /** The part of a plot that was dragged up. @param {Plot} plot */
  #seen = (plot) => (this.#zoom ? { ...plot, range: this.#zoom, held: undefined } : plot);

  #fit() {
    const width = this.canvas.clientWidth;
    if (width && (this.#drawn !== this.#plot || this.#layout?.width !== width)) this.#draw();
  }

  #draw() {
    const width = this.canvas.clientWidth;
    if (!this.#plot || !width) return;
    this.#drawn = this.#plot;
    this.#layout = laidOut(this.#seen(this.#plot), '', width, this.height, colour);
    const { box, root } = this.#layout;
    const [x, y] = [box.left, box.top];
    root.append(
      svg('g', { class: 'cursor' }),
      svg('rect', {
        class: 'reach',
        x,
        y,
        width: Math.max(0, box.right - x),
        height: Math.max(0, box.bottom - y),
        fill: 'transparent',
      }),
    );
    this.canvas.replaceChildren(root);
    this.#write(null, () => null);
  }

  /** Where the pointer is in the drawing. @param {MouseEvent} event @returns {[number, number]} */
  #placeOf({ clientX, clientY }) {
    const { left, top } = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const [plot, layout] = [this.#plot, this.#layout];
    if (!plot || !layout) return;
    const [px, py] = this.#placeOf(event);
    const cursor = this.canvas.querySelector('.cursor');
    const { box, x } = layout;
    if (!Number.isNaN(this.#from)) {
      const [left, right] = [this.#from, px].sort((a, b) => a - b);
      return cursor?.replaceChildren(
        svg('rect', {
          class: 'dragged',
          x: left,
          y: box.top,
          width: right - left,
          height: box.bottom - box.top,
        }),
      );
    }
    const near = plot.turns ? nearest(layout, plot, px, py) : besideOf(layout, plot, px);
    if (!near) return this.#leave();
    const dots = near.values.flatMap((value, k) => {
      if (value === null) return [];
      const { colour: name, right } = plot.curves[k];
      const cy = (right ? layout.right : layout.y).at(value);
      return [svg('circle', { cx: x.at(near.x), cy, r: 3, fill: colour(name) })];
    });
    const at = x.at(near.x);
    cursor?.replaceChildren(
      svg('path', { class: 'hair', d: `M${at} ${box.top}V${box.bottom}` }),
      ...dots,
    );
    this.#write(near.x, (k) => near.values[k]);
  }

  #leave() {
    this.canvas.querySelector('.cursor')?.replaceChildren();
    this.#write(null, () => null);
  }

  /** Ends a drag. @param {PointerEvent} event */
  #drop(event) {
    const [from, to] = [this.#from, this.#placeOf(event)[0]].sort((a, b) => a - b);
    this.#from = NaN;
    if (!this.#layout || !(to - from > CLICK)) return;
    const { x, box } = this.#layout;
    const value = (/** @type {number} */ px) => x.of(Math.min(box.right, Math.max(box.left, px)));
    this.#zoom = [value(from), value(to)];
    this.#draw();
  }

  /**
   * Writes the legend, with figures if the pointer is somewhere.
   * @param {number | null} x where it is
   * @param {(curve: number) => number | null} value of a curve there
   */
  #write(x, value) {
    const { curves, x: across = '', y = '', right = '' } = this.#plot ?? { curves: [] };
    this.legend.replaceChildren(
      ...curves.map((curve, k) =>
        h(
          'li',
          {},
          swatch(curve),
          curve.label,
          x == null ? null : h('b', {}, measured(value(k), curve.right ? right : y)),
        ),
      ),
      ...(x == null ? [] : [h('li', { class: 'at' }, `at ${measured(x, across)}`)]),
    );
  }
}

/** @typedef {{x: number, values: (number | null)[]}} Read a place, and every curve there */

/**
 * The place of a point of any curve that is nearest to the pointer, and all curves there.
 * @param {import('./chart-svg.js').Layout} layout @param {Plot} plot @param {number} px
 * @returns {Read | undefined}
 */
function besideOf({ x, box }, { curves }, px) {
  if (px < box.left - 4 || px > box.right + 4) return undefined;
  let best = NaN;
  let far = Infinity;
  for (const curve of curves)
    for (const value of curve.x) {
      const distance = Math.abs(x.at(value) - px);
      if (distance < far && value >= x.from && value <= x.to) [best, far] = [value, distance];
    }
  return Number.isNaN(best)
    ? undefined
    : { x: best, values: curves.map((curve) => valueAt(curve, best)) };
}

/**
 * The point of a loop that is nearest, where a place on the abscissa has several.
 * @param {import('./chart-svg.js').Layout} layout @param {Plot} plot @param {number} px @param {number} py
 * @returns {Read | undefined}
 */
function nearest({ x, y }, { curves }, px, py) {
  /** @type {Read | undefined} */
  let best;
  let far = Infinity;
  curves.forEach((curve, k) => {
    if (!curve.points) return;
    curve.x.forEach((value, j) => {
      const height = curve.y[j];
      const distance =
        height === null ? Infinity : Math.hypot(x.at(value) - px, y.at(height) - py);
      if (distance >= far) return;
      far = distance;
      best = { x: value, values: curves.map((_, l) => (l === k ? height : null)) };
    });
  });
  return best;
}

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
    'stroke-width': curve.to ? 8 : (curve.width ?? 2),
    'stroke-opacity': curve.to ? 0.3 : null,
    'stroke-dasharray': dashOf(curve)?.join(' '),
  });
  line.style.stroke = `var(${curve.colour})`;
  return svg('svg', { class: 'swatch', viewBox: '0 0 24 8', 'aria-hidden': 'true' }, line);
}
