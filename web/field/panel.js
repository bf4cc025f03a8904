/** Stress, plastic strain and displacement on both deformed meshes. */

import { Problem } from '../api/client.js';
import { reconnected } from '../api/connection.js';
import { h } from '../lib/dom.js';
import { colour, onTheme } from '../lib/theme.js';
import { factor, figure, loaded, unit } from '../lib/units.js';
import { Panel } from '../result/panel.js';
import { Camera } from './camera.js';
import { ColourRange } from './colours.js';
import { withoutLoad } from './cut.js';
import { CutTool } from './cut-tool.js';
import { Renderer } from './gl.js';
import { lifts } from './lift.js';
import { carried } from './locate.js';
import { drawOverlay } from './overlay.js';
import { bands, rgb } from './palette.js';
import { compose } from './picture.js';
import { steer } from './pointer.js';
import { QUANTITIES, arraysOf, nameOf, parityOf, valuesOf } from './quantities.js';
import { READ, colourBar, extremes, readout, scaleOf } from './read.js';
import { fieldTools } from './tools.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('./quantities.js').Quantity} Quantity */
/** @typedef {import('./read.js').Body & {polygons: ReturnType<typeof carried>}} Body */
/** @typedef {import('../lib/units.js').UnitSet} UnitSet */
/** @typedef {import('./source.js').Fields} Fields */
/** @typedef {import('./source.js').FieldSource} FieldSource */
/** @typedef {{report: Report, at: number, units: UnitSet}} Asked */

/** Plastic strain below this part of the scale has no colour: nodes beside the zone take a little from its elements. */
const PLAIN = 0.02;

export class FieldPanel {
  /** @type {Body[]} */
  #bodies = [];
  /** Quantity that is drawn. @type {Quantity} */
  #quantity = 'von_mises';
  #camera = new Camera();
  #deformation = 1;
  #lines = false;
  #isolines = false;
  #frame = 0;
  /** Whether the meshes are to be drawn anew. */
  #stale = true;
  /** @type {[number, number] | null} */
  #probe = null;
  /** What is drawn. @type {Asked | undefined} */
  #shown;
  /** What is to be drawn, as soon as it is here. @type {Asked | undefined} */
  #wanted;
  /** Of the shown step. @type {Fields | undefined} */
  #fields;
  /** How often something was asked for: an answer to what is not the last question is not shown. */
  #turn = 0;
  /** Kept when what was asked for last is drawn, or cannot be. @type {Promise<void>} */
  settled = Promise.resolve();
  /** Whether something is on its way. */
  busy = false;
  /** Analysis whose names the quantities have. */
  #named = '';
  /** Fields whose other arrays have been asked for, to be read. @type {Fields | undefined} */
  #reading;
  /** @type {Renderer | undefined} */
  #renderer;
  /** In the units shown. @type {import('./palette.js').Bands} */
  #bands = bands(0, 1);
  /** Whether the whole contact is to be seen as soon as there is a field. */
  #homeless = false;
  /** @type {FieldSource | undefined} */
  #source;
  /** Whose steps have all been looked at. @type {FieldSource | undefined} */
  #surveyed;
  /** @type {import('./read.js').Extreme[]} */
  #ends = [];
  /** @type {(deformation: number) => import('./lift.js').Lifts} */
  #lifts = () => ({ upper: 0, lower: 0, contact: 0 });

  /** @param {() => void} wanted called to solve again with fields */
  constructor(wanted) {
    this.surface = h('canvas', { class: 'surface' });
    this.over = h('canvas', {
      class: 'over',
      tabindex: 0,
      role: 'img',
      'aria-label': 'Stress field',
      'aria-description':
        'Arrows move, plus and minus zoom, 0 goes back; figures of the point in the middle are read out below.',
    });
    this.bar = h('ol', { class: 'colours', 'aria-hidden': 'true' });
    this.readout = h('p', { class: 'readout', role: 'status' });
    this.stage = h('div', { class: 'stage' }, this.surface, this.over, this.bar);
    this.empty = h(
      'div',
      { class: 'empty' },
      h('p', {}, 'This job did not ask for the stress field on the mesh.'),
      h('button', { type: 'button', onclick: wanted }, 'Solve again with it'),
    );
    this.waiting = h('p', { class: 'empty waiting', role: 'status' });
    this.cutter = new CutTool(() => this.#later(false));
    this.range = new ColourRange(() => this.#colour());
    const { element, quantities } = this.#tools();
    this.controls = element;
    this.quantities = quantities;
    this.panel = new Panel(
      'field',
      'Field',
      [
        this.controls,
        h('div', { class: 'frame' }, this.stage, this.waiting),
        this.readout,
        this.cutter.element,
        this.empty,
      ],
      {
        picture: async (title) => {
          await this.settled;
          const canvas = this.canvas(title);
          return canvas ? new Promise((resolve) => canvas.toBlob(resolve)) : null;
        },
      },
    );
    steer(this.over, this.#camera, {
      moved: () => this.#later(),
      home: () => this.#home(),
      probe: (at) => {
        this.#probe = at;
        // What could not be read is tried again when the pointer is back.
        if (!at) this.#reading = undefined;
        this.#later(false);
      },
      line: (from, to) => {
        const mirrored = this.#shown?.report.mesh.symmetric ?? false;
        const [begin, end] = [from, to].map((at) =>
          withoutLoad(this.#bodies, this.#deformation, mirrored, this.#camera.toWorld(...at)),
        );
        this.cutter.draw(begin, end);
      },
    });
    new ResizeObserver(() => this.#fit()).observe(this.stage);
    onTheme(() => this.#later());
    this.surface.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#renderer = undefined;
      this.stage.classList.add('stale');
      this.waiting.hidden = false;
      this.waiting.textContent =
        'The browser has taken the graphics back: the field is drawn again as soon as it gives them.';
    });
    this.surface.addEventListener('webglcontextrestored', () => {
      this.stage.classList.remove('stale');
      this.waiting.hidden = true;
      if (this.#shown) this.#load();
    });
  }

  #tools() {
    const later = (/** @type {(value: any) => void} */ set) => (/** @type {any} */ value) => {
      set(value);
      this.#later();
    };
    return fieldTools(
      {
        choose: () => this.#update(),
        exaggerate: later((times) => {
          this.#deformation = times;
          this.#place();
        }),
        mesh: later((on) => {
          this.#lines = on;
        }),
        isolines: later((on) => {
          this.#isolines = on;
        }),
        cut: later((on) => {
          this.over.classList.toggle('cutting', on);
          this.cutter.show(on, this.#camera, this.#half());
        }),
        zoom: later((factor) => this.#camera.zoom(factor)),
        home: () => this.#home(),
      },
      this.range.element,
    );
  }

  /**
   * @param {Report} report in the units of its job
   * @param {number} at
   * @param {UnitSet} units shown
   * @param {boolean} anew whether it is another job's, of which the whole contact is to be seen
   * @param {FieldSource} [source] of fields that are not in the report
   */
  show(report, at, units, anew, source) {
    this.panel.show(true);
    if (anew) {
      this.range.forget();
      this.#shown = undefined;
      this.#homeless = true;
    }
    if (this.#source !== source) this.#forget();
    this.#source = source;
    this.#wanted = { report, at, units };
    this.#update();
  }

  /** Before there is anything. */
  clear() {
    this.#forget();
    this.#wanted = undefined;
    this.panel.show(false);
  }

  /** Gives back the room of what was shown. */
  #forget() {
    this.#turn += 1;
    this.#source?.close();
    this.#source = this.#shown = this.#fields = undefined;
    this.#bodies = [];
    this.#renderer?.load([]);
  }

  /** @param {boolean} shown */
  #showParts(shown) {
    this.stage.hidden = this.readout.hidden = this.controls.hidden = !shown;
    this.cutter.element.hidden = !shown || !this.cutter.on;
  }

  /** Quantity that is to be drawn. */
  get #chosen() {
    return /** @type {Quantity} */ (this.quantities.value || this.#quantity);
  }

  /** Draws the step and the quantity that are wanted: at once, or when their arrays have come. */
  #update() {
    if (!this.#wanted) return;
    const turn = ++this.#turn;
    const [asked, source] = [this.#wanted, this.#source];
    const step = asked.report.steps[asked.at];
    const fields = step.fields ?? source?.peek(asked.at, arraysOf(this.#chosen));
    this.busy = !fields && source !== undefined && step.plasticity !== undefined;
    this.empty.hidden = Boolean(fields) || this.busy;
    this.waiting.hidden = !this.busy;
    this.#showParts(Boolean(fields) || (this.busy && this.#shown !== undefined));
    this.stage.classList.toggle('stale', this.busy);
    if (fields) this.#present(asked, fields);
    else if (this.busy && source) this.settled = this.#await(asked, source, () => turn === this.#turn);
  }

  /** @param {Asked} asked @param {FieldSource} source @param {() => boolean} still whether this is what is wanted */
  async #await(asked, source, still) {
    const same = this.#shown?.at === asked.at && this.#bodies.length > 0;
    const what = same ? nameOf(this.#chosen, asked.report.analysis) : 'the field of this step';
    this.waiting.textContent = `Loading ${what}…`;
    // The room of another step is given back before that of this one is taken.
    if (!same && !source.whole) this.#bodies = [];
    try {
      const fields = await source.get(asked.at, arraysOf(this.#chosen), (received, total) => {
        if (still()) this.waiting.textContent = `Loading ${what}, ${loaded(received, total)}`;
      });
      if (still()) this.#present(asked, fields);
    } catch (error) {
      if (!still()) return;
      this.busy = false;
      const again = () => still() && this.#update();
      this.waiting.replaceChildren(
        `Could not load ${what}: ${/** @type {Error} */ (error).message}. `,
        h('button', { type: 'button', onclick: again }, 'Try again'),
      );
      if (error instanceof Problem && error.status === 0) reconnected().then(again);
    }
  }

  /** @param {Asked} asked @param {Fields} fields with the arrays of the chosen quantity */
  #present(asked, fields) {
    const { report, at } = asked;
    const step = report.steps[at];
    this.#shown = asked;
    this.busy = false;
    this.waiting.hidden = true;
    this.stage.classList.remove('stale');
    this.#showParts(true);
    this.#nameQuantities(report.analysis);
    if (this.#fields === fields && this.#bodies.length) this.#choose();
    else {
      performance.mark('field-received');
      this.#fields = fields;
      this.#lifts = lifts(fields.upper, fields.lower, step);
      this.#bodies = bodiesOf(step, fields).map((body) => ({
        ...body,
        polygons: carried(
          step.plasticity?.[body.name]?.outline ?? [],
          body.mesh,
          body.name === 'upper' ? 1 : -1,
          report.mesh.symmetric,
        ),
      }));
      this.#place();
      this.#load();
    }
    this.#fit();
    if (this.#homeless) this.#home();
    this.#homeless = false;
    this.#survey(report);
  }

  /** Looks at the other steps, so that colours are the same over all of them: where they all can be kept. @param {Report} report */
  async #survey(report) {
    const source = this.#source;
    if (!source?.whole || this.#surveyed === source) return;
    this.#surveyed = source;
    for (const step of report.steps.keys()) {
      const failed = await source.get(step, []).then(
        () => false,
        () => true,
      );
      if (failed || this.#source !== source) return;
    }
    this.#colour();
  }

  /** @param {string} analysis */
  #nameQuantities(analysis) {
    const chosen = this.#chosen;
    if (this.#named !== analysis)
      this.quantities.replaceChildren(
        ...Object.keys(QUANTITIES).map((value) =>
          h('option', { value, selected: value === chosen }, nameOf(/** @type {Quantity} */ (value), analysis)),
        ),
      );
    this.#named = analysis;
    this.range.single = this.#shown?.report.steps.length === 1;
  }

  /** Raises the bodies so that they do not overlap. */
  #place() {
    const lifted = this.#lifts(this.#deformation);
    for (const body of this.#bodies) body.lift = lifted[body.name];
  }

  /** @param {string} [title] @param {(name: string) => string} [colours] of the page, or of paper @returns {HTMLCanvasElement | null} the field with its scale of colours */
  canvas(title = this.panel.caption, colours = colour) {
    const step = this.#step();
    if (!this.#renderer || !step || this.stage.hidden || this.stage.classList.contains('stale')) return null;
    this.#draw(true, colours);
    // The page has its own colours again.
    this.#later();
    const { unit: name } = this.#scale();
    return compose([this.surface, this.over], this.#bands, {
      title,
      quantity: `${nameOf(this.#quantity, this.#shown?.report.analysis ?? '')}${name ? ` [${name}]` : ''}${
        this.#deformation === 1 ? '' : `, displacements ×${this.#deformation}`
      }`,
      colours,
    });
  }

  /** The curve of the cut, where there is one. @returns {SVGSVGElement | null} */
  cutDrawing() {
    const { on, chart } = this.cutter;
    return on && !this.stage.hidden && !chart.element.hidden
      ? chart.drawing('Along the cut in the field', 520, 240)
      : null;
  }

  #load() {
    const gl = this.#renderer?.gl ?? this.surface.getContext('webgl2', { antialias: false });
    if (!gl) {
      this.readout.textContent = 'This browser has no WebGL2. The field can be downloaded as VTU.';
      return;
    }
    this.#renderer ??= new Renderer(gl);
    this.#renderer.load(this.#bodies);
    this.#choose();
  }

  /** Puts the values of the chosen quantity on the meshes. */
  #choose() {
    const chosen = this.#chosen;
    if (chosen !== this.#quantity) this.range.release();
    this.#quantity = chosen;
    this.#renderer?.choose((mesh, moved) => valuesOf(mesh, this.#quantity, moved));
    this.#colour();
  }

  #scale() {
    return scaleOf(this.#quantity, this.#scales());
  }

  /** @returns {import('./read.js').Scales} */
  #scales() {
    if (!this.#shown) throw new Error('nothing is shown');
    const { report, units } = this.#shown;
    const own = /** @type {import('../lib/units.js').Units} */ (report.units);
    return {
      analysis: report.analysis,
      symmetric: report.mesh.symmetric,
      own,
      units,
      length: factor('length', own, units),
      stress: factor('stress', own, units),
    };
  }

  /** Gives the values their colours. */
  #colour() {
    if (!this.#shown) return;
    const { report } = this.#shown;
    const { factor: times, unit: name } = this.#scale();
    const own = extremes(this.#bodies, this.#quantity, report);
    this.#ends = own.ends;
    this.#bands = this.range.bands({
      quantity: this.#quantity,
      steps: report.steps.length,
      limits: (step) => this.#limitsOf(step),
      own: [own.low, own.high],
      signed: QUANTITIES[this.#quantity].signed ?? false,
      factor: times,
      unit: name,
      kind: QUANTITIES[this.#quantity].kind,
      units: this.#scales().own,
      whole: this.#source?.whole ?? true,
    });
    this.bar.replaceChildren(...colourBar(this.#bands, name));
    this.over.setAttribute(
      'aria-label',
      `Field of ${nameOf(this.#quantity, report.analysis)}, from ${figure(own.low * times, 4)} to ${figure(own.high * times, 4)} ${name}.`,
    );
    this.#later();
  }

  /** Of a step whose field is here. @param {number} at @returns {[number, number] | undefined} */
  #limitsOf(at) {
    const { report } = /** @type {Asked} */ (this.#shown);
    const { steps } = report;
    const fields = steps[at].fields ?? this.#source?.peek(at, arraysOf(this.#quantity));
    if (!fields) return undefined;
    const { low, high } = extremes(bodiesOf(steps[at], fields), this.#quantity, report);
    return [low, high];
  }

  /** Half-width of the contact; where the load is taken away, that of the largest one, whose traces are to be seen. */
  #half() {
    const widths = this.#shown?.report.steps.map(({ contact }) => contact.half_width) ?? [];
    return this.#step()?.contact.half_width || Math.max(0, ...widths) || 1 / 1.9;
  }

  #home() {
    if (this.#shown) this.#camera.home(1.9 * this.#half());
    this.#later();
  }

  #step() {
    return this.#shown?.report.steps[this.#shown.at];
  }

  #fit() {
    const [width, height] = [this.stage.clientWidth, this.stage.clientHeight];
    if (!width || !height) return;
    const first = this.#camera.width === 1;
    this.#camera.scale *= width / this.#camera.width;
    Object.assign(this.#camera, { width, height });
    const [pixels, lines] = [width, height].map((size) => Math.round(size * devicePixelRatio));
    if (first) this.#home();
    if (this.surface.width === pixels && this.surface.height === lines) return;
    // A canvas that is given its size is made anew, and empty.
    for (const canvas of [this.surface, this.over]) Object.assign(canvas, { width: pixels, height: lines });
    if (!first) this.#draw();
  }

  /** @param {boolean} [meshes] whether more has changed than what lies over them */
  #later(meshes = true) {
    this.#stale ||= meshes;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#draw(this.#stale);
    });
  }

  #draw(meshes = true, colours = colour) {
    const step = this.#step();
    if (!this.#renderer || !step || !this.#shown || !this.#bodies.length || this.stage.hidden) return;
    const { report } = this.#shown;
    const scales = this.#scales();
    const { factor: times, unit: name } = this.#scale();
    if (meshes) this.#drawMeshes(this.#renderer, report, colours);
    if (meshes || this.cutter.stale)
      this.cutter.read(this.#bodies, this.#deformation, {
        quantity: this.#quantity,
        mirrored: report.mesh.symmetric,
        scales,
      });
    drawOverlay(this.over, {
      camera: this.#camera,
      deformation: this.#deformation,
      zones: this.#bodies,
      edges: step.contact.patches
        .flatMap(({ left, right }) =>
          report.analysis === 'axisymmetric' ? [left, right, -left, -right] : [left, right],
        )
        .filter((x) => x !== 0),
      height: this.#lifts(this.#deformation).contact,
      cross: this.#probe,
      ends: this.#ends.map((end) => ({
        ...end,
        lift: this.#bodies.find(({ name }) => name === end.name)?.lift ?? 0,
        text: `${end.end} ${figure(end.value * times, 4)} ${name}`,
      })),
      path: this.cutter.path,
      colours,
      length: unit('length', scales.units),
      factor: scales.length,
    });
    this.#read(scales);
    performance.mark('field-drawn');
  }

  /** @param {Renderer} renderer @param {Report} report @param {(name: string) => string} colours */
  #drawMeshes(renderer, report, colours) {
    this.#stale = false;
    const strain = this.#quantity === 'equivalent_plastic_strain';
    const { factor: times } = this.#scale();
    const { low, step, colours: swatches } = this.#bands;
    renderer.draw({
      camera: this.#camera,
      bands: { low: low / times, step: step / times, colours: swatches },
      deformation: this.#deformation,
      mirrored: report.mesh.symmetric,
      odd: parityOf(this.#quantity, report.analysis, -1) < 0,
      lines: this.#lines,
      isolines: this.#isolines,
      floor: strain ? (PLAIN * (low + step * swatches.length)) / times : -Infinity,
      plain: rgb(colours('--metal')),
    });
  }

  /** Says what is under the probe. @param {import('./read.js').Scales} scales */
  #read(scales) {
    this.readout.textContent = this.#probe
      ? readout(this.#bodies, this.#quantity, scales, this.#deformation, this.#camera.toWorld(...this.#probe))
      : `${matchMedia('(pointer: coarse)').matches ? 'Tap the field for its figures; two fingers move and zoom it' : 'Point at the field for its figures; drag to move; click, then scroll to zoom'}. White line: plastic zone.`;
    if (this.#probe) this.#fetchRead();
  }

  /** Fetches the arrays of the shown step that a reading is made of. */
  async #fetchRead() {
    const [source, shown, fields] = [this.#source, this.#shown, this.#fields];
    if (!source || !shown || this.#wanted?.at !== shown.at || source.peek(shown.at, READ)) return;
    if (this.#reading === fields) return;
    this.#reading = fields;
    const arrived = await source.get(shown.at, READ).catch((error) => error);
    if (this.#fields !== fields) return;
    if (!(arrived instanceof Error)) return this.#later(false);
    this.readout.textContent += ` · the others could not be loaded: ${arrived.message}`;
    if (!(arrived instanceof Problem) || arrived.status !== 0) return;
    await reconnected();
    if (this.#reading === fields) this.#reading = undefined;
    this.#later(false);
  }
}

/** @param {import('../types.js').Step} step @param {Fields} fields @returns {import('./read.js').Body[]} */
const bodiesOf = (step, fields) =>
  /** @type {const} */ (['upper', 'lower']).flatMap((name) => {
    const mesh = fields[name];
    return mesh ? [{ name, mesh, lift: 0, moved: name === 'upper' ? -step.approach : 0 }] : [];
  });
