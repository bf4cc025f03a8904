/**
 * Pressure and gap over the surface of a contact in three dimensions: a map in bands of colour,
 * read out under the pointer.
 */

import { ask } from '../api/client.js';
import { bands, isDark, limitOf, roundStep } from '../field/palette.js';
import { colourBar } from '../field/read.js';
import { button, h, plainButton, pngOf } from '../lib/dom.js';
import { colour, onTheme, paper } from '../lib/theme.js';
import { figure, plain, setOf, unit } from '../lib/units.js';
import { orMiddle } from './answers.js';
import { axesOf, mapInJob } from './axes.js';
import { Chart } from './chart.js';
import { inUnits } from './converted.js';
import { beside, isUnloaded } from './loads.js';
import { Panel, segments } from './panel.js';
import { rowOf, valueIn, widthIn } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../wire.js').ContactMaps} Maps */
/** @typedef {(name: string) => string} Colours of custom properties */
/**
 * @typedef {object} Picture
 * @property {{a: number, b: number}} semi axes of the contact
 * @property {boolean} rough whether heights touch
 * @property {Maps} maps over x and y of the job, with a `dent` where a load has left one
 * @property {{x: string, y: string, words: string}} axes names of both, and how they lie
 * @property {{x: number, y: number} | undefined} hertz semi-axes along both
 * @property {string} label
 * @property {string} colour of its curves
 * @property {number[]} [dash]
 * @property {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} units
 */

/** Room of the axes [px]. */
const LEFT = 52;
const BOTTOM = 38;
const RIGHT = 14;
const TOP = 10;
/** Least and largest height of the axes' box on the page [px]. */
const [LOW, HIGH] = [44, 340];
/** What is shown, over what touches. */
const SHOWN = 1.35;
/** Distance of two ticks at least [px]. */
const TICKS = 70;
const FONT = '11px system-ui, sans-serif';

/** @typedef {'pressure' | 'gap' | 'dent'} Quantity */
/** @type {Record<Quantity, {name: string, letter: string, kind: 'stress' | 'length'}>} */
const QUANTITIES = {
  pressure: { name: 'Pressure', letter: 'p', kind: 'stress' },
  gap: { name: 'Gap', letter: 'g', kind: 'length' },
  dent: { name: 'Dent', letter: 'δ', kind: 'length' },
};

export class MapPanel {
  /** Of every job that is shown. @type {Picture[]} */
  #pictures = [];
  /** Which of them is drawn. */
  #which = 0;
  /** @type {Quantity} */
  #quantity = 'pressure';
  #isolines = false;
  /** Whether the map fills its place, whatever its proportions are. */
  #stretch = false;
  /** Where the cuts meet: x and y, or the place of the largest pressure. @type {[number, number] | undefined} */
  #pinned;
  /** An answer to what is not the last question is not shown. */
  #turn = 0;

  /** @param {() => void} wanted called to solve again with maps */
  constructor(wanted) {
    this.canvas = h('canvas', {
      class: 'map',
      role: 'img',
      tabindex: 0,
      'aria-description':
        'Arrows move the place of the cuts; Home puts it back to the largest value.',
    });
    this.bar = h('ol', { class: 'colours level', 'aria-hidden': 'true' });
    this.stage = h('div', { class: 'stage flat' }, this.canvas);
    this.readout = h('p', { class: 'readout', role: 'status' });
    this.chart = new Chart(170);
    this.empty = h(
      'div',
      { class: 'empty' },
      h('p', {}, 'This job did not ask for the maps of its contact.'),
      button('Solve again with them', wanted),
    );
    const names = Object.fromEntries(
      Object.entries(QUANTITIES).map(([key, { name }]) => [key, name]),
    );
    this.choice = segments('Shown on the map', names, (value) => {
      this.#quantity = /** @type {Quantity} */ (value);
      this.#again();
    });
    const lines = h('input', {
      type: 'checkbox',
      onchange: () => {
        this.#isolines = lines.checked;
        this.#draw();
      },
    });
    const stretch = () => {
      this.#stretch = !this.#stretch;
      this.stretch.setAttribute('aria-pressed', String(this.#stretch));
      this.#again();
    };
    const title = 'Give both axes scales of their own';
    this.stretch = plainButton('Stretch', stretch, { 'aria-pressed': 'false', title });
    this.jobs = h('select', {
      'aria-label': 'Job of the map',
      onchange: () => {
        this.#which = this.jobs.selectedIndex;
        this.#again();
      },
    });
    this.tools = h(
      'div',
      { class: 'bar tools' },
      this.jobs,
      h('label', {}, lines, ' Lines between colours'),
      this.stretch,
    );
    const content = [
      this.tools,
      this.stage,
      this.bar,
      this.readout,
      this.chart.element,
      this.empty,
    ];
    /** @type {Panel} */
    this.panel = new Panel('map', 'Map of the contact', content, {
      controls: [this.choice],
      chart: { picture: (title) => pngOf(this.onPaper(title)) },
    });
    this.canvas.addEventListener('pointermove', ({ offsetX, offsetY }) =>
      this.#read(offsetX, offsetY),
    );
    this.canvas.addEventListener('pointerleave', () => this.#read());
    this.canvas.addEventListener('click', ({ offsetX, offsetY }) => {
      const picture = this.#picture;
      if (picture) this.#pin(this.#frame.place(offsetX, offsetY));
    });
    this.canvas.addEventListener('keydown', (event) => {
      const picture = this.#picture;
      const step = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] }[
        event.key
      ];
      if (!picture || !(step || event.key === 'Home')) return;
      event.preventDefault();
      this.#pin(step && this.#frame.beside(this.#place(picture), step[0], step[1]));
    });
    new ResizeObserver(() => this.#draw()).observe(this.stage);
    onTheme(() => this.#draw());
  }

  /** Whether the map is shown, with its cuts. */
  get hasCuts() {
    return !this.stage.hidden;
  }

  get #picture() {
    return this.#pictures[this.#which];
  }

  /** @param {Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const turn = ++this.#turn;
    const [{ report, job }] = shown;
    const { section, maps } = report.steps[at].contact;
    this.panel.show(section !== undefined);
    const asked = Boolean(maps ?? job.output?.fields);
    this.tools.hidden =
      this.stage.hidden =
      this.bar.hidden =
      this.readout.hidden =
      this.chart.element.hidden =
        !asked;
    this.empty.hidden = asked;
    this.#pictures = [];
    if (!section || !asked) return;
    const sides = beside(shown, at).filter(
      ({ one, at }) => one.report.steps[at].contact.maps ?? one.job.output?.fields,
    );
    this.readout.textContent = 'Loading the map…';
    Promise.all(sides.map(({ one, at, label }) => pictureOf(one, at, label))).then(
      (pictures) => {
        if (turn !== this.#turn) return;
        this.#pictures = pictures;
        this.#which = Math.min(this.#which, pictures.length - 1);
        this.#offer();
        this.#again();
      },
      (error) => {
        if (turn === this.#turn)
          this.readout.textContent = `Could not load the map: ${error.message}`;
      },
    );
  }

  /** Offers jobs and quantities of which there is a map. */
  #offer() {
    this.jobs.hidden = this.#pictures.length < 2;
    this.jobs.replaceChildren(...this.#pictures.map(({ label }) => h('option', {}, label)));
    this.jobs.selectedIndex = this.#which;
    const dented = this.#pictures.some(({ maps }) => maps.dent);
    const boxes = /** @type {NodeListOf<HTMLInputElement>} */ (
      this.choice.querySelectorAll('input')
    );
    /** @type {HTMLElement} */ (boxes[2].parentElement).hidden = !dented;
    // What a load has left is what one looks for when it is gone.
    if (dented !== (this.#quantity === 'dent')) {
      this.#quantity = dented ? 'dent' : 'pressure';
      boxes[dented ? 2 : 0].checked = true;
    }
  }

  /** Another job, quantity or step. */
  #again() {
    this.#draw();
    this.#read();
    this.#cut();
  }

  /** @param {[number, number]} [place] */
  #pin(place) {
    this.#pinned = place;
    this.#draw();
    this.#cut();
  }

  /** Where the cuts meet. @param {Picture} picture @returns {[number, number]} */
  #place({ maps, semi, rough }) {
    const { x, y } = maps;
    const values = valuesOf(maps, this.#quantity);
    const within = (/** @type {number} */ at, /** @type {number[]} */ cells) =>
      Math.min(cells[cells.length - 1], Math.max(cells[0], at));
    if (this.#pinned) return [within(this.#pinned[0], x), within(this.#pinned[1], y)];
    const most = this.#quantity === 'gap' ? -1 : values.indexOf(largest(values));
    if (most < 0) return [0, 0];
    const [px, py] = [x[Math.floor(most / y.length)], y[most % y.length]];
    return rough ? [px, py] : [orMiddle(px, semi.a), orMiddle(py, semi.b)];
  }

  /** Curves of all jobs through the place of the cuts. */
  #cut() {
    const picture = this.#picture;
    if (!picture) return;
    const [px, py] = this.#place(picture);
    const { letter, kind, name } = QUANTITIES[this.#quantity];
    const several = this.#pictures.length > 1;
    const { axes } = picture;
    const length = unit('length', picture.units);
    const along = (/** @type {Picture} */ { maps, label, colour: own, dash }) => {
      const there = (/** @type {number} */ x, /** @type {number} */ y) => {
        const value = valueAt(maps, this.#quantity, x, y);
        return Number.isFinite(value) ? value : null;
      };
      const x = { x: maps.x, y: maps.x.map((x) => there(x, py)) };
      const y = { x: maps.y, y: maps.y.map((y) => there(px, y)) };
      return several
        ? [
            { ...y, label: `${label}, along ${axes.y}`, colour: own, dash },
            { ...x, label: `${label}, along ${axes.x}`, colour: own, dash: [2, 2] },
          ]
        : [
            {
              ...y,
              label: `along ${axes.y}, at ${axes.x} ${figure(px, 3)}`,
              colour: '--curve-2',
              dash: [7, 3],
            },
            { ...x, label: `along ${axes.x}, at ${axes.y} ${figure(py, 3)}`, colour: '--curve-1' },
          ];
    };
    const { x, y } = this.#frame.shown;
    this.chart.show({
      x: `${axes.x}, ${axes.y}  [${length}]`,
      y: `${letter}  [${unit(kind, picture.units)}]`,
      curves: this.#pictures.flatMap(along),
      range: [Math.min(x[0], y[0]), Math.max(x[1], y[1])],
      words: `${name} along the cuts through ${axes.x} ${figure(px, 3)}, ${axes.y} ${figure(py, 3)} ${length}.`,
    });
  }

  get #frame() {
    const { clientWidth: width, clientHeight: height } = this.stage;
    return new Frame(width, height, this.#picture, this.#stretch);
  }

  /** Gives the stage the height that the map needs. */
  #fit() {
    const picture = this.#picture;
    if (!picture) return;
    const { width, height } = new Frame(
      this.stage.clientWidth,
      HIGH + TOP + BOTTOM,
      picture,
      this.#stretch,
    );
    if (width > 0) this.stage.style.height = `${Math.max(LOW, height) + TOP + BOTTOM}px`;
  }

  #draw() {
    const picture = this.#picture;
    this.#fit();
    const { clientWidth: width, clientHeight: height } = this.stage;
    if (!picture || width === 0) return;
    const scale = devicePixelRatio;
    Object.assign(this.canvas, { width: width * scale, height: height * scale });
    const context = this.canvas.getContext('2d');
    if (!context) return;
    context.scale(scale, scale);
    const name = unit(QUANTITIES[this.#quantity].kind, picture.units);
    this.bar.replaceChildren(...colourBar(this.#bands(), name));
    thin(this.bar);
    const frame = this.#frame;
    this.canvas.dataset.box = [frame.x0, frame.y0, frame.width, frame.height].join(' ');
    this.#paint(context, frame, picture, colour);
    performance.mark('field-drawn');
    const { semi, units } = picture;
    const length = unit('length', units);
    this.canvas.setAttribute(
      'aria-label',
      `Map of the ${QUANTITIES[this.#quantity].name.toLowerCase()} over a contact with the semi-axes ${figure(semi.a, 4)} and ${figure(semi.b, 4)} ${length}.`,
    );
  }

  /** Colours that are the same for all jobs. */
  #bands() {
    const all = this.#pictures.map(({ maps }) => valuesOf(maps, this.#quantity));
    return bands(Math.min(0, ...all.map(least)), Math.max(...all.map(largest)));
  }

  /** What is at a place of the stage, or of the whole. @param {number} [left] @param {number} [top] */
  #read(left, top) {
    const picture = this.#picture;
    if (!picture) return;
    const { hertz, maps, units, axes } = picture;
    const [length, stress] = [unit('length', units), unit('stress', units)];
    const [x, y] =
      left === undefined || top === undefined ? [NaN, NaN] : this.#frame.place(left, top);
    const at = (/** @type {Quantity} */ quantity) => valueAt(maps, quantity, x, y);
    const dent = maps.dent ? ` · dent ${figure(at('dent'), 3)} ${length}` : '';
    const scales = this.#stretch ? ' The axes have scales of their own.' : '';
    this.readout.textContent = Number.isFinite(at('pressure'))
      ? `${axes.x} ${figure(x, 3)}, ${axes.y} ${figure(y, 3)} ${length}:  p ${figure(at('pressure'), 4)} ${stress} · gap ${figure(at('gap'), 3)} ${length}${dent}`
      : `${axes.words && `${axes.words} `}${hertz ? 'Dashed: Hertz, elastic. ' : ''}Click to cut there.${scales}`;
  }

  /** Maps of all jobs, for the report. @returns {HTMLCanvasElement[]} */
  allOnPaper() {
    return this.#pictures.flatMap(
      (picture) =>
        this.onPaper(`${QUANTITIES[this.#quantity].name}, ${picture.label}`, picture) ?? [],
    );
  }

  /** The map with the limits of its colours. @returns {HTMLCanvasElement | null} nothing where there is no map */
  onPaper(title = this.panel.caption, picture = this.#picture) {
    if (!picture) return null;
    const [width, right] = [520, 462];
    const room = right - 10;
    const wanted = new Frame(room, 324, picture, this.#stretch).height + TOP + BOTTOM;
    const { colours, ...limits } = this.#bands();
    const band = Math.min(17, 272 / colours.length);
    const height = 26 + Math.max(LOW + TOP + BOTTOM, wanted, 20 + band * colours.length);
    const canvas = h('canvas', { width: 3 * width, height: 3 * height });
    const context = canvas.getContext('2d');
    if (!context) return null;
    const ink = paper('--ink');
    context.scale(3, 3);
    context.fillStyle = paper('--panel');
    context.fillRect(0, 0, width, height);
    context.font = '600 13px system-ui, sans-serif';
    context.fillStyle = ink;
    context.fillText(title, 8, 18, 440);
    context.translate(0, 26);
    this.#paint(context, new Frame(room, wanted, picture, this.#stretch), picture, paper);
    const { kind, letter } = QUANTITIES[this.#quantity];
    context.fillStyle = ink;
    context.fillText(`${letter}  [${unit(kind, picture.units)}]`, right, -8);
    colours.forEach((rgb, k) => {
      const top = 8 + band * (colours.length - 1 - k);
      context.fillStyle = css(rgb);
      context.fillRect(right, top, 13, band);
      context.fillStyle = ink;
      context.fillText(limitOf({ colours, ...limits }, k + 1), right + 18, top + 4);
    });
    return canvas;
  }

  /** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Picture} picture @param {Colours} colours */
  #paint(context, frame, picture, colours) {
    const { maps } = picture;
    const { low, step, colours: shades } = this.#bands();
    const ink = colours('--ink');
    const shown = bandsOf(frame, maps, this.#quantity, low, step, shades.length);
    const { width, height } = frame;
    const image = new ImageData(width, height);
    const rgba = shades.map((rgb) => rgb.map((part) => Math.round(255 * part)));
    for (let top = 0, k = 0; top < height; top++)
      for (let left = 0; left < width; left++, k++) {
        const [band, before, above] = [
          shown[k],
          left ? shown[k - 1] : shown[k],
          top ? shown[k - width] : shown[k],
        ];
        const line = this.#isolines && (before !== band || above !== band);
        if (band < 0 && !line) continue;
        const white = band >= 0 && isDark(shades[band]);
        const [r, g, b] = !line ? rgba[band] : white ? [255, 255, 255] : inkOf(ink);
        image.data.set([r, g, b, 255], 4 * k);
      }
    const sheet = new OffscreenCanvas(width, height);
    sheet.getContext('2d')?.putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(sheet, frame.x0, frame.y0);
    frame.axes(context, ink);
    if (picture.hertz) frame.ellipse(context, picture.hertz);
    frame.cross(context, this.#place(picture));
  }
}

/** Leaves out limits of colours that have no room. @param {HTMLElement} bar */
function thin(bar) {
  const swatches = /** @type {HTMLElement[]} */ ([...bar.children].slice(0, -2).reverse());
  const longest = Math.max(...swatches.map(({ textContent }) => textContent?.length ?? 0));
  const room = (bar.clientWidth - 130) / swatches.length;
  const every = Math.max(1, Math.ceil((6.5 * longest + 8) / Math.min(56, room)));
  swatches.forEach((swatch, k) => {
    if ((swatches.length - 1 - k) % every) swatch.replaceChildren();
  });
}

/** @param {Shown} one @param {number} at @param {string} label @returns {Promise<Picture>} */
async function pictureOf({ id, report, raw = report, colour, dash }, at, label) {
  const step = report.steps[at];
  const maps =
    raw.steps[at].contact.maps ??
    (await ask(`v1/jobs/${id}/result?fields=maps&step=${at + 1}`)).steps[0].contact.maps;
  const own = /** @type {import('../lib/units.js').Units} */ (raw.units);
  const converted = inUnits(
    { ...maps, dent: isUnloaded(step) ? maps.dent : undefined },
    { analysis: raw.analysis, units: own },
    setOf(report.units),
  );
  const { x, y, words } = axesOf(step);
  const turned = x.name === 'y';
  const [a, b] = ['semi_axis_a', 'semi_axis_b'].map((name) => rowOf(step, name)?.elastic);
  return {
    semi: { a: widthIn(step), b: valueIn(step, 'semi_axis_b') ?? 0 },
    rough: step.contact.quantiles !== undefined,
    maps: mapInJob(converted, { x, y, words }),
    axes: turned ? { x: 'x', y: 'y', words } : { x: x.name, y: y.name, words },
    hertz: a && b ? (turned ? { x: b, y: a } : { x: a, y: b }) : undefined,
    units: report.units,
    label,
    colour,
    dash,
  };
}

/** @param {number[]} values */
const largest = (values) => values.reduce((a, b) => Math.max(a, b), -Infinity);
/** @param {number[]} values */
const least = (values) => values.reduce((a, b) => Math.min(a, b), Infinity);
/** @param {Picture['maps']} maps @param {Quantity} quantity */
const valuesOf = (maps, quantity) => maps[quantity] ?? maps.gap;

/**
 * The part of the surface that is drawn, and where: the longer axis to the right, seen from above,
 * so that x is up where y is to the right, and y is down where x is.
 */
class Frame {
  /** @param {number} width @param {number} height @param {Picture} picture @param {boolean} stretch whether it fills its place */
  constructor(width, height, { rough, maps, hertz, axes, units }, stretch) {
    const rows = maps.x.map((_, i) =>
      maps.pressure.slice(i * maps.y.length, (i + 1) * maps.y.length).some((p) => p > 0),
    );
    const columns = maps.y.map((_, j) =>
      maps.x.some((_, i) => maps.pressure[i * maps.y.length + j] > 0),
    );
    const room = (
      /** @type {number[]} */ cells,
      /** @type {boolean[]} */ touching,
      /** @type {number} */ axis = 0,
    ) => {
      const [first, last] = [cells[0], cells[cells.length - 1]];
      // Of heights, and without a contact, all cells are shown.
      if (rough || !touching.includes(true)) return [first, last];
      const [from, to] = [cells[touching.indexOf(true)], cells[touching.lastIndexOf(true)]];
      const [low, high] = axis > 0 ? [Math.min(from, -axis), Math.max(to, axis)] : [from, to];
      const [middle, half] = [(low + high) / 2, Math.max((high - low) / 2, cells[1] - cells[0])];
      return [Math.max(first, middle - SHOWN * half), Math.min(last, middle + SHOWN * half)];
    };
    this.shown = { x: room(maps.x, rows, hertz?.x), y: room(maps.y, columns, hertz?.y) };
    this.step = { x: maps.x[1] - maps.x[0], y: maps.y[1] - maps.y[0] };
    const long = (/** @type {'x' | 'y'} */ axis) => this.shown[axis][1] - this.shown[axis][0];
    /** Axes to the right, and up or down. @type {'x' | 'y'} */
    this.across = long('x') > 1.001 * long('y') ? 'x' : 'y';
    /** @type {'x' | 'y'} */
    this.along = this.across === 'x' ? 'y' : 'x';
    const label = (/** @type {'x' | 'y'} */ axis) => `${axes[axis]}  [${unit('length', units)}]`;
    this.labels = [label(this.across), label(this.along)];
    this.width = Math.max(1, Math.floor(width - LEFT - RIGHT));
    this.height = Math.max(1, Math.floor(height - TOP - BOTTOM));
    if (!stretch) {
      const even = Math.min(this.width / long(this.across), this.height / long(this.along));
      this.width = Math.max(1, Math.floor(even * long(this.across)));
      this.height = Math.max(1, Math.floor(even * long(this.along)));
    }
    this.x0 = LEFT + Math.floor((width - LEFT - RIGHT - this.width) / 2);
    this.y0 = TOP;
  }

  /** Ends of the box from left to right, and from top to bottom. */
  get #ends() {
    const [low, high] = this.shown[this.along];
    return [this.shown[this.across], this.along === 'x' ? [high, low] : [low, high]];
  }

  /** @param {number} left @param {number} top @returns {[number, number]} x and y */
  place(left, top) {
    const [[from, to], [first, last]] = this.#ends;
    const [s, t] = [(left - this.x0) / this.width, (top - this.y0) / this.height];
    if (s < 0 || s > 1 || t < 0 || t > 1) return [NaN, NaN];
    const [across, along] = [from + s * (to - from), first + t * (last - first)];
    return this.across === 'x' ? [across, along] : [along, across];
  }

  /** One cell to the right and down from a place. @param {[number, number]} place @param {number} right @param {number} down @returns {[number, number]} */
  beside([x, y], right, down) {
    const { x: dx, y: dy } = this.step;
    return this.across === 'x' ? [x + right * dx, y + down * dy] : [x - down * dx, y + right * dy];
  }

  /** @param {number} value of the axis to the right */
  left(value) {
    const [[from, to]] = this.#ends;
    return this.x0 + (this.width * (value - from)) / (to - from);
  }

  /** @param {number} value of the other axis */
  top(value) {
    const [, [first, last]] = this.#ends;
    return this.y0 + (this.height * (value - first)) / (last - first);
  }

  /** @param {CanvasRenderingContext2D} context @param {string} ink */
  axes(context, ink) {
    const bottom = this.y0 + this.height;
    context.font = FONT;
    context.strokeStyle = context.fillStyle = ink;
    context.strokeRect(this.x0, this.y0, this.width, this.height);
    context.textAlign = 'center';
    for (const value of ticks(this.shown[this.across], this.width)) {
      context.fillRect(this.left(value), bottom, 1, 4);
      context.fillText(plain(value), this.left(value), bottom + 15);
    }
    context.fillText(this.labels[0], this.x0 + 0.5 * this.width, bottom + 31);
    context.textAlign = 'right';
    for (const value of ticks(this.shown[this.along], this.height)) {
      context.fillRect(this.x0 - 4, this.top(value), 4, 1);
      context.fillText(plain(value), this.x0 - 7, this.top(value) + 4);
    }
    context.textAlign = 'left';
    context.fillText(this.labels[1], Math.max(2, this.x0 - LEFT + 2), bottom + 31);
  }

  /** @param {CanvasRenderingContext2D} context @param {{x: number, y: number}} semi axes */
  ellipse(context, semi) {
    const across = this.left(semi[this.across]) - this.left(0);
    const along = Math.abs(this.top(semi[this.along]) - this.top(0));
    context.save();
    context.beginPath();
    context.rect(this.x0, this.y0, this.width, this.height);
    context.clip();
    context.setLineDash([5, 4]);
    context.beginPath();
    context.ellipse(this.left(0), this.top(0), across, along, 0, 0, 2 * Math.PI);
    context.stroke();
    context.restore();
  }

  /** @param {CanvasRenderingContext2D} context @param {[number, number]} place of the cuts */
  cross(context, [x, y]) {
    const [across, along] = this.across === 'x' ? [x, y] : [y, x];
    context.save();
    context.globalAlpha = 0.45;
    context.beginPath();
    context.rect(this.x0, this.y0, this.width, this.height);
    context.clip();
    context.fillRect(this.x0, this.top(along), this.width, 1);
    context.fillRect(this.left(across), this.y0, 1, this.height);
    context.restore();
  }
}

/** @param {import('../field/palette.js').Rgb} rgb */
const css = (rgb) => `rgb(${rgb.map((c) => Math.round(255 * c)).join(' ')})`;

/** Between the middles of four cells; none beyond them. @param {Picture['maps']} maps @param {Quantity} quantity @param {number} x @param {number} y */
function valueAt(maps, quantity, x, y) {
  const [i, s] = cellOf(maps.x, x);
  const [j, t] = cellOf(maps.y, y);
  const values = valuesOf(maps, quantity);
  const at = (/** @type {number} */ k, /** @type {number} */ l) => values[k * maps.y.length + l];
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return NaN;
  return (
    (1 - s) * ((1 - t) * at(i, j) + t * at(i, j + 1)) +
    s * ((1 - t) * at(i + 1, j) + t * at(i + 1, j + 1))
  );
}

/** A colour of the page, which is written as #rrggbb. @param {string} colour */
const inkOf = (colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));

/**
 * The band of every pixel of a frame, row by row; −1 where nothing is to be seen.
 * @param {Frame} frame @param {Picture['maps']} maps @param {Quantity} quantity @param {number} low @param {number} step @param {number} many
 */
function bandsOf(frame, maps, quantity, low, step, many) {
  const { width, height, x0, y0 } = frame;
  const [values, columns] = [valuesOf(maps, quantity), maps.y.length];
  const [first, last] = [frame.place(x0, y0), frame.place(x0 + width, y0 + height)];
  const along = (/** @type {'x' | 'y'} */ axis) => {
    const k = axis === 'x' ? 0 : 1;
    const pixels = frame.across === axis ? width : height;
    return Array.from({ length: pixels }, (_, n) =>
      cellOf(maps[axis], first[k] + ((n + 0.5) / pixels) * (last[k] - first[k])),
    );
  };
  const [xs, ys] = [along('x'), along('y')];
  const bands = new Int8Array(width * height).fill(-1);
  const flipped = frame.across === 'x';
  for (let top = 0, k = 0; top < height; top++)
    for (let left = 0; left < width; left++, k++) {
      const [i, s] = flipped ? xs[left] : xs[top];
      const [j, t] = flipped ? ys[top] : ys[left];
      if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) continue;
      const at = i * columns + j;
      const value =
        (1 - s) * ((1 - t) * values[at] + t * values[at + 1]) +
        s * ((1 - t) * values[at + columns] + t * values[at + columns + 1]);
      if (quantity === 'pressure') {
        const nearest = (i + Math.round(s)) * columns + j + Math.round(t);
        if (!(value > 0 && maps.pressure[nearest] > 0)) continue;
      } else if (quantity === 'gap' && !(value > 0)) continue;
      if (Number.isFinite(value))
        bands[k] = Math.min(many - 1, Math.max(0, Math.floor((value - low) / step)));
    }
  return bands;
}

/** @param {number[]} cells at equal distances @param {number} place @returns {[cell: number, part: number]} */
function cellOf(cells, place) {
  const at = ((place - cells[0]) / (cells[cells.length - 1] - cells[0])) * (cells.length - 1);
  const cell = Math.min(cells.length - 2, Math.max(0, Math.floor(at)));
  return [cell, at - cell];
}

/** Round figures from one end to the other. @param {number[]} ends @param {number} room [px] */
function ticks([low, high], room) {
  const step = roundStep(((high - low) * Math.min(TICKS, Math.max(20, room / 2.2))) / room);
  const first = Math.ceil(low / step);
  return Array.from({ length: Math.floor(high / step) - first + 1 }, (_, k) => (first + k) * step);
}
