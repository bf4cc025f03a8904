/** Pressure and gap over the surface of a contact in three dimensions: a map in bands of colour, read out under the pointer. */

import { ask } from '../api/client.js';
import { bands, limitOf, roundStep } from '../field/palette.js';
import { colourBar } from '../field/read.js';
import { h } from '../lib/dom.js';
import { colour, onTheme, paper } from '../lib/theme.js';
import { figure, plain, setOf, unit } from '../lib/units.js';
import { inUnits } from './converted.js';
import { Panel, segments } from './panel.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {NonNullable<import('../types.js').Step['three_dimensional']>} Ellipse */
/** @typedef {NonNullable<Ellipse['maps']>} Maps */
/** @typedef {(name: string) => string} Colours of custom properties */
/**
 * @typedef {object} Picture
 * @property {Ellipse} ellipse
 * @property {Maps} maps
 * @property {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
 */

/** Room of the axes [px]. */
const LEFT = 52;
const BOTTOM = 38;
/** Room of the colours [px]. */
const RIGHT = 72;
const TOP = 10;
/** What is shown, over the semi-axes. */
const SHOWN = 1.35;
/** Distance of two ticks at least [px]. */
const TICKS = 70;
const FONT = '11px system-ui, sans-serif';

/** @type {Record<'pressure' | 'gap', {letter: string, kind: 'stress' | 'length'}>} */
const QUANTITIES = { pressure: { letter: 'p', kind: 'stress' }, gap: { letter: 'g', kind: 'length' } };

export class MapPanel {
  /** @type {Picture | undefined} */
  #picture;
  /** @type {'pressure' | 'gap'} */
  #quantity = 'pressure';
  /** An answer to what is not the last question is not shown. */
  #turn = 0;

  /** @param {() => void} wanted called to solve again with maps */
  constructor(wanted) {
    this.canvas = h('canvas', { role: 'img' });
    this.bar = h('ol', { class: 'colours', 'aria-hidden': 'true' });
    this.stage = h('div', { class: 'stage' }, this.canvas, this.bar);
    this.readout = h('p', { class: 'readout', role: 'status' });
    this.empty = h(
      'div',
      { class: 'empty' },
      h('p', {}, 'This job did not ask for the maps of its contact.'),
      h('button', { type: 'button', onclick: wanted }, 'Solve again with them'),
    );
    const choice = segments('Shown on the map', { pressure: 'Pressure', gap: 'Gap' }, (value) => {
      this.#quantity = /** @type {'pressure' | 'gap'} */ (value);
      this.#draw();
    });
    this.panel = new Panel('map', 'Map of the contact', [this.stage, this.readout, this.empty], {
      controls: [choice],
      picture: async (title) => {
        const canvas = this.onPaper(title);
        return canvas ? new Promise((resolve) => canvas.toBlob(resolve)) : null;
      },
    });
    this.stage.addEventListener('pointermove', ({ offsetX, offsetY }) => this.#read(offsetX, offsetY));
    this.stage.addEventListener('pointerleave', () => this.#read());
    new ResizeObserver(() => this.#draw()).observe(this.stage);
    onTheme(() => this.#draw());
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show([{ id, job, report, raw = report }], at) {
    const turn = ++this.#turn;
    const ellipse = report.steps[at].three_dimensional;
    this.panel.show(ellipse !== undefined);
    const asked = Boolean(ellipse?.maps ?? job.output?.fields);
    this.stage.hidden = this.readout.hidden = !asked;
    this.empty.hidden = asked;
    this.#picture = undefined;
    if (!ellipse || !asked) return;
    const present = (/** @type {Maps} */ maps) => {
      if (turn !== this.#turn) return;
      const own = /** @type {import('../lib/units.js').Units} */ (raw.units);
      const converted = inUnits(maps, { analysis: raw.analysis, units: own }, setOf(report.units));
      this.#picture = { ellipse, maps: converted, units: report.units };
      this.#draw();
      this.#read();
    };
    const inside = raw.steps[at].three_dimensional?.maps;
    if (inside) return present(inside);
    this.readout.textContent = 'Loading the map…';
    ask(`v1/jobs/${id}/result?fields=maps&step=${at + 1}`).then(
      (part) => present(part.steps[0].three_dimensional.maps),
      (error) => {
        if (turn === this.#turn) this.readout.textContent = `Could not load the map: ${error.message}`;
      },
    );
  }

  get #frame() {
    return new Frame(this.stage.clientWidth, this.stage.clientHeight, /** @type {Picture} */ (this.#picture));
  }

  #draw() {
    const picture = this.#picture;
    const { clientWidth: width, clientHeight: height } = this.stage;
    if (!picture || width === 0) return;
    const scale = devicePixelRatio;
    Object.assign(this.canvas, { width: width * scale, height: height * scale });
    const context = this.canvas.getContext('2d');
    if (!context) return;
    context.scale(scale, scale);
    const shades = bandsOf(picture, this.#quantity);
    const name = unit(QUANTITIES[this.#quantity].kind, picture.units);
    this.bar.replaceChildren(...colourBar(shades, name));
    paint(context, this.#frame, picture, this.#quantity, colour);
    performance.mark('field-drawn');
    const { ellipse, units } = picture;
    const length = unit('length', units);
    this.canvas.setAttribute(
      'aria-label',
      `Map of the ${this.#quantity} over a contact with the semi-axes ${figure(ellipse.a, 4)} and ${figure(ellipse.b, 4)} ${length}.`,
    );
  }

  /** What is at a place of the stage, or of the whole. @param {number} [left] @param {number} [top] */
  #read(left, top) {
    const picture = this.#picture;
    if (!picture) return;
    const { ellipse, maps, units } = picture;
    const [length, stress] = [unit('length', units), unit('stress', units)];
    const [x, y] = left === undefined || top === undefined ? [NaN, NaN] : this.#frame.place(left, top);
    const here = { pressure: valueAt(maps, 'pressure', x, y), gap: valueAt(maps, 'gap', x, y) };
    this.readout.textContent = Number.isFinite(here.pressure)
      ? `x ${figure(x, 3)}, y ${figure(y, 3)} ${length}:  p ${figure(here.pressure, 4)} ${stress} · gap ${figure(here.gap, 3)} ${length}`
      : `x lies along the shorter semi-axis${ellipse.orientation ? `, ${figure(ellipse.orientation, 3)}° from that of the job` : ''}. Dashed: Hertz, elastic. The axes have scales of their own.`;
  }

  /** The map with the limits of its colours. @returns {HTMLCanvasElement | null} nothing where there is no map */
  onPaper(title = this.panel.caption) {
    const picture = this.#picture;
    const canvas = h('canvas', { width: 1400, height: 900 });
    const context = canvas.getContext('2d');
    if (!picture || !context) return null;
    context.fillStyle = paper('--panel');
    context.fillRect(0, 0, 1400, 900);
    context.scale(2, 2);
    context.font = '600 13px system-ui, sans-serif';
    context.fillStyle = paper('--ink');
    context.fillText(title, LEFT, 18);
    context.translate(0, 26);
    paint(context, new Frame(690, 424, picture), picture, this.#quantity, paper);
    const { colours, ...limits } = bandsOf(picture, this.#quantity);
    const name = unit(QUANTITIES[this.#quantity].kind, picture.units);
    context.fillText(`${QUANTITIES[this.#quantity].letter}  [${name}]`, 632, 18);
    colours.forEach((rgb, k) => {
      const top = 32 + 17 * (colours.length - 1 - k);
      context.fillStyle = css(rgb);
      context.fillRect(632, top, 13, 17);
      context.fillStyle = paper('--ink');
      context.fillText(limitOf({ colours, ...limits }, k + 1), 650, top + 4);
    });
    return canvas;
  }
}

/** The part of the surface that is drawn, and where. */
class Frame {
  /** @param {number} width @param {number} height @param {Picture} picture */
  constructor(width, height, { ellipse, maps }) {
    // The longer axis lies along the wider side. Without a contact all cells are shown.
    const reach = (/** @type {number} */ axis, /** @type {number[]} */ cells) =>
      Math.min(axis > 0 ? SHOWN * axis : Infinity, Math.abs(cells[0]));
    this.across = reach(ellipse.b, maps.y);
    this.up = reach(ellipse.a, maps.x);
    this.width = width - LEFT - RIGHT;
    this.height = height - TOP - BOTTOM;
  }

  /** @param {number} left @param {number} top @returns {[number, number]} x and y */
  place(left, top) {
    return [this.up * (1 - (2 * (top - TOP)) / this.height), this.across * ((2 * (left - LEFT)) / this.width - 1)];
  }

  /** @param {number} y @returns {number} */
  left(y) {
    return LEFT + 0.5 * this.width * (1 + y / this.across);
  }

  /** @param {number} x @returns {number} */
  top(x) {
    return TOP + 0.5 * this.height * (1 - x / this.up);
  }
}

/** @param {Picture} picture @param {'pressure' | 'gap'} quantity */
const bandsOf = ({ maps }, quantity) => bands(0, Math.max(...maps[quantity]));

/** @param {import('../field/palette.js').Rgb} rgb */
const css = (rgb) => `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`;

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Picture} picture @param {'pressure' | 'gap'} quantity @param {Colours} colours */
function paint(context, frame, { ellipse, maps, units }, quantity, colours) {
  const { low, step, colours: shades } = bandsOf({ ellipse, maps, units }, quantity);
  for (let top = 0; top < frame.height; top++)
    for (let left = 0; left < frame.width; left++) {
      const place = frame.place(LEFT + left + 0.5, TOP + top + 0.5);
      const value = valueAt(maps, quantity, ...place);
      if (!(value > 0) || (quantity === 'pressure' && !touches(maps, ...place))) continue;
      context.fillStyle = css(shades[Math.min(shades.length - 1, Math.floor((value - low) / step))]);
      context.fillRect(LEFT + left, TOP + top, 1, 1);
    }
  context.font = FONT;
  context.strokeStyle = context.fillStyle = colours('--ink');
  context.strokeRect(LEFT, TOP, frame.width, frame.height);
  context.textAlign = 'center';
  for (const y of ticks(frame.across, frame.width)) {
    context.fillRect(frame.left(y), TOP + frame.height, 1, 4);
    context.fillText(plain(y), frame.left(y), TOP + frame.height + 15);
  }
  const length = unit('length', units);
  context.fillText(`y  [${length}]`, LEFT + 0.5 * frame.width, TOP + frame.height + 31);
  context.textAlign = 'right';
  for (const x of ticks(frame.up, frame.height)) {
    context.fillRect(LEFT - 4, frame.top(x), 4, 1);
    context.fillText(plain(x), LEFT - 7, frame.top(x) + 4);
  }
  context.textAlign = 'left';
  context.fillText(`x  [${length}]`, 2, TOP + 9);
  if (ellipse.hertz) {
    const { a, b } = ellipse.hertz;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.ellipse(
      frame.left(0),
      frame.top(0),
      (0.5 * frame.width * b) / frame.across,
      (0.5 * frame.height * a) / frame.up,
      0,
      0,
      2 * Math.PI,
    );
    context.stroke();
    context.setLineDash([]);
  }
}

/** Between the middles of four cells; none beyond them. @param {Maps} maps @param {'pressure' | 'gap'} quantity @param {number} x @param {number} y */
function valueAt(maps, quantity, x, y) {
  const [i, s] = cellOf(maps.x, x);
  const [j, t] = cellOf(maps.y, y);
  const at = (/** @type {number} */ k, /** @type {number} */ l) => maps[quantity][k * maps.y.length + l];
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return NaN;
  return (1 - s) * ((1 - t) * at(i, j) + t * at(i, j + 1)) + s * ((1 - t) * at(i + 1, j) + t * at(i + 1, j + 1));
}

/** Whether the cell here carries pressure. @param {Maps} maps @param {number} x @param {number} y */
function touches(maps, x, y) {
  const [[i, s], [j, t]] = [cellOf(maps.x, x), cellOf(maps.y, y)];
  return maps.pressure[(i + Math.round(s)) * maps.y.length + j + Math.round(t)] > 0;
}

/** @param {number[]} cells at equal distances @param {number} place @returns {[cell: number, part: number]} */
function cellOf(cells, place) {
  const at = ((place - cells[0]) / (cells[cells.length - 1] - cells[0])) * (cells.length - 1);
  const cell = Math.min(cells.length - 2, Math.max(0, Math.floor(at)));
  return [cell, at - cell];
}

/** Round figures from one end to the other. @param {number} reach to each side @param {number} room [px] */
function ticks(reach, room) {
  const step = roundStep((2 * reach * TICKS) / room);
  const most = Math.floor(reach / step);
  return Array.from({ length: 2 * most + 1 }, (_, k) => (k - most) * step);
}
