/** Stress, plastic strain and displacement on both deformed meshes. */

import { Problem } from '../api/client.js';
import { reconnected } from '../api/connection.js';
import { button, h, pngOf } from '../lib/dom.js';
import { colour } from '../lib/theme.js';
import { figure, loaded } from '../lib/units.js';
import { isUnloaded } from '../result/loads.js';
import { Panel } from '../result/panel.js';
import { ColourRange } from './colours.js';
import { CutTool } from './cut-tool.js';
import { steer } from './pointer.js';
import { QUANTITIES, arraysOf, nameOf, quantitiesOf, sectionOf } from './quantities.js';
import { READ, colourBar, extremes, readout } from './read.js';
import { Scene, bodiesOf } from './scene.js';
import { fieldTools } from './tools.js';

/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('./quantities.js').Quantity} Quantity */
/** @typedef {import('../lib/units.js').UnitSet} UnitSet */
/** @typedef {import('./source.js').Fields} Fields */
/** @typedef {Pick<import('./source.js').FieldSource, 'whole' | 'peek' | 'get' | 'close'>} FieldSource */
/** @typedef {import('./scene.js').Asked} Asked */

export class FieldPanel {
  /** What is to be drawn, as soon as it is here. @type {Asked | undefined} */
  #wanted;
  /** Of the shown step. @type {Fields | undefined} */
  #fields;
  /**
   * How often something was asked for: an answer to what is not the last question is not shown.
   */
  #turn = 0;
  /** Whether somebody has chosen what is shown. */
  #touched = false;
  /** Kept when what was asked for last is drawn, or cannot be. @type {Promise<void>} */
  settled = Promise.resolve();
  /** Whether something is on its way. */
  busy = false;
  /** What is shown unless one chooses: the stress that is left when the load is gone, plastic strain where a body yields. @type {Quantity} */
  #preset = 'von_mises';
  /** Analysis whose names the quantities have. */
  #named = '';
  /** Fields whose other arrays have been asked for, to be read. @type {Fields | undefined} */
  #reading;
  /** Whether the whole contact is to be seen as soon as there is a field. */
  #homeless = false;
  /** @type {FieldSource | undefined} */
  #source;
  /** Whose steps have all been looked at. @type {FieldSource | undefined} */
  #surveyed;

  /** Another field on the same scale. @type {FieldPanel | undefined} */
  peer;
  /** Quantity of the peer, which this one follows. @type {Quantity | undefined} */
  #led;

  /** @param {() => void} wanted called to solve again with fields @param {Node[]} controls beside the title @param {string} [id] */
  constructor(wanted, controls, id = 'field') {
    this.bar = h('ol', { class: 'colours', 'aria-hidden': 'true' });
    this.readout = h('p', { class: 'readout', role: 'status' });
    this.empty = h(
      'div',
      { class: 'empty' },
      h('p', {}, 'This job did not ask for the stress field on the mesh.'),
      button('Solve again with it', wanted),
    );
    this.waiting = h('p', { class: 'empty waiting', role: 'status' });
    this.cutter = new CutTool(() => this.scene.later(false));
    /** @type {Scene} */
    this.scene = new Scene(this.cutter, this.bar, {
      drawn: (scales) => this.#read(scales),
      lost: () => {
        this.stage.classList.add('stale');
        this.waiting.hidden = false;
        this.waiting.textContent =
          'The browser has stopped the graphics. The field is drawn again when they work.';
      },
      restored: () => {
        this.stage.classList.remove('stale');
        this.waiting.hidden = true;
        if (this.scene.shown) this.#load();
      },
    });
    this.stage = this.scene.stage;
    this.range = new ColourRange(() => this.#colour());
    const { element, quantities, displacement } = this.#tools();
    this.displacement = displacement;
    this.controls = element;
    this.quantities = quantities;
    this.panel = new Panel(
      id,
      'Field',
      [
        this.controls,
        h('div', { class: 'frame' }, this.stage, this.waiting),
        this.readout,
        this.cutter.element,
        this.empty,
      ],
      {
        controls,
        chart: {
          picture: async (title) => {
            await this.settled;
            return pngOf(this.canvas(title));
          },
        },
      },
    );
    steer(this.scene.over, this.scene.camera, {
      moved: () => this.#moved(),
      home: () => this.#home(),
      probe: (at) => {
        this.scene.probe = at;
        // What could not be read is tried again when the pointer is back.
        if (!at) this.#reading = undefined;
        this.scene.later(false);
      },
      line: (from, to) => {
        const [begin, end] = [from, to].map((at) => this.scene.withoutLoad(at));
        this.cutter.draw(begin, end);
      },
    });
  }

  #tools() {
    const later = (/** @type {(value: any) => void} */ set) => (/** @type {any} */ value) => {
      set(value);
      this.scene.later();
    };
    return fieldTools(
      {
        choose: () => {
          this.#touched = true;
          this.#update();
          this.peer?.follow(this.#chosen);
        },
        exaggerate: later((times) => {
          this.scene.exaggerate(times);
        }),
        mesh: later((on) => {
          this.scene.lines = on;
        }),
        isolines: later((on) => {
          this.scene.isolines = on;
        }),
        cut: later((on) => {
          this.scene.over.classList.toggle('cutting', on);
          const { x, unloaded, half } = this.scene.contact();
          this.cutter.show(on, [x, unloaded], half);
        }),
        zoom: (factor) => {
          this.scene.camera.zoom(factor);
          this.#moved();
        },
        home: () => this.#home(),
      },
      this.range.element,
    );
  }

  /**
   * @param {Asked} asked
   * @param {boolean} anew whether it is another job's, of which the whole contact is to be seen
   * @param {FieldSource} [source] of fields that are not in the report
   */
  show(asked, anew, source) {
    this.panel.show(true);
    if (anew) {
      this.range.forget();
      this.scene.shown = undefined;
      this.#homeless = true;
    }
    if (this.#source !== source) this.#forget();
    this.#source = source;
    this.#wanted = asked;
    if (this.#led) this.#preset = this.#led;
    else if (!this.#touched)
      this.#preset = isUnloaded(asked.report.steps[asked.at])
        ? 'sigma_x'
        : asked.yields
          ? 'equivalent_plastic_strain'
          : 'von_mises';
    this.#update();
  }

  /** Shows the quantity that its peer shows. @param {Quantity} quantity */
  follow(quantity) {
    this.#led = this.#preset = quantity;
    this.#touched = false;
    this.#update();
  }

  /** Quantity that is to be drawn. */
  get quantity() {
    return this.#chosen;
  }

  /** Limits of what is drawn, in the units shown. @param {Quantity} quantity @returns {[number, number] | undefined} nothing where it is another quantity */
  limitsOf(quantity) {
    const { shown, bodies } = this.scene;
    if (!shown || this.panel.element.hidden || this.scene.quantity !== quantity) return undefined;
    if (bodies.length === 0 || this.busy) return undefined;
    const { low, high } = extremes(bodies, quantity, shown.report);
    const { factor: times } = this.scene.scale();
    return [low * times, high * times];
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
    this.#source = this.#fields = undefined;
    this.scene.forget();
  }

  /** @param {boolean} shown */
  #showParts(shown) {
    this.stage.hidden = this.readout.hidden = this.controls.hidden = !shown;
    this.cutter.element.hidden = !shown || !this.cutter.on;
  }

  /** Quantity that is to be drawn. */
  get #chosen() {
    return this.#touched ? /** @type {Quantity} */ (this.quantities.value) : this.#preset;
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
    this.#showParts(Boolean(fields) || (this.busy && this.scene.shown !== undefined));
    this.stage.classList.toggle('stale', this.busy);
    if (fields) this.#present(asked, fields);
    else if (this.busy && source)
      this.settled = this.#await(asked, source, () => turn === this.#turn);
  }

  /** @param {Asked} asked @param {FieldSource} source @param {() => boolean} still whether this is what is wanted */
  async #await(asked, source, still) {
    const same = this.scene.shown?.at === asked.at && this.scene.bodies.length > 0;
    const what = same ? nameOf(this.#chosen, asked.report.analysis) : 'the field of this step';
    this.waiting.textContent = `Loading ${what}…`;
    // The room of another step is given back before that of this one is taken.
    if (!same && !source.whole) this.scene.bodies = [];
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
        button('Try again', again),
      );
      if (error instanceof Problem && error.status === 0) reconnected().then(again);
    }
  }

  /** @param {Asked} asked @param {Fields} fields with the arrays of the chosen quantity */
  #present(asked, fields) {
    const { report, at } = asked;
    const step = report.steps[at];
    this.scene.shown = asked;
    this.busy = false;
    this.waiting.hidden = true;
    this.stage.classList.remove('stale');
    this.#showParts(true);
    this.#nameQuantities(report.analysis);
    if (this.#fields === fields && this.scene.bodies.length) this.#choose();
    else {
      performance.mark('field-received');
      this.#fields = fields;
      this.scene.take(fields);
      this.#load();
    }
    this.scene.fit();
    if (this.#homeless) this.#home();
    this.#homeless = false;
    this.#survey(report);
  }

  /** The whole contact, on the scale of the peer. */
  #home() {
    const { peer } = this;
    const beside = peer && !peer.panel.element.hidden ? peer.scene : undefined;
    const least = Math.max(this.scene.reach, beside?.reach ?? 0);
    this.scene.home(least);
    beside?.home(least);
  }

  /** The peer looks where this one does. */
  #moved() {
    this.scene.later();
    if (this.peer && !this.peer.panel.element.hidden) this.peer.scene.match(this.scene);
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
        ...quantitiesOf(analysis).map((value) =>
          h('option', { value, selected: value === chosen }, nameOf(value, analysis)),
        ),
      );
    this.quantities.value = chosen;
    this.displacement.hidden = sectionOf(analysis) !== undefined;
    this.#named = analysis;
    this.range.single = this.scene.shown?.report.steps.length === 1;
  }

  /** @param {string} [title] @param {(name: string) => string} [colours] of the page, or of paper @returns {HTMLCanvasElement | null} the field with its scale of colours */
  canvas(title = this.panel.caption, colours = colour) {
    return this.scene.picture(title, colours);
  }

  /** The curve of the cut, where there is one. @returns {SVGSVGElement | null} */
  cutDrawing() {
    const { on, chart } = this.cutter;
    return on && !this.stage.hidden && !chart.element.hidden
      ? chart.drawing('Along the cut in the field', 380, 135)
      : null;
  }

  #load() {
    if (this.scene.load()) this.#choose();
    else
      this.readout.textContent = 'This browser has no WebGL2. The field can be downloaded as VTU.';
  }

  /** Puts the values of the chosen quantity on the meshes. */
  #choose() {
    const chosen = this.#chosen;
    if (chosen !== this.scene.quantity) this.range.release();
    this.scene.choose(chosen);
    this.#colour();
  }

  /** Gives the values their colours. @param {boolean} [told] whether the peer has its colours anew */
  #colour(told = false) {
    if (!this.scene.shown) return;
    const { report } = this.scene.shown;
    const { factor: times, unit: name } = this.scene.scale();
    const own = extremes(this.scene.bodies, this.scene.quantity, report);
    const said = this.scene.said();
    this.scene.ends = said ? [said, ...own.ends.filter(({ end }) => end === 'min')] : own.ends;
    const beside = this.peer?.limitsOf(this.scene.quantity);
    const limits = /** @type {[number, number]} */ (
      beside
        ? [Math.min(own.low, beside[0] / times), Math.max(own.high, beside[1] / times)]
        : [own.low, own.high]
    );
    this.scene.bands = this.range.bands({
      quantity: this.scene.quantity,
      steps: report.steps.length,
      limits: (step) => this.#limitsOf(step),
      own: limits,
      beside: beside !== undefined,
      signed: QUANTITIES[this.scene.quantity].signed ?? false,
      residual: isUnloaded(report.steps[this.scene.shown.at]),
      factor: times,
      unit: name,
      kind: QUANTITIES[this.scene.quantity].kind,
      units: this.scene.scales().own,
      whole: this.#source?.whole ?? true,
    });
    this.bar.replaceChildren(...colourBar(this.scene.bands, name));
    this.scene.over.setAttribute(
      'aria-label',
      `Field of ${nameOf(this.scene.quantity, report.analysis)}, from ${figure(own.low * times, 4)} to ${figure(own.high * times, 4)} ${name}.`,
    );
    this.scene.later();
    if (beside && !told) this.peer?.recolour();
  }

  /** Takes the colours of both. */
  recolour() {
    this.#colour(true);
  }

  /** Of a step whose field is here. @param {number} at @returns {[number, number] | undefined} */
  #limitsOf(at) {
    const { report } = /** @type {Asked} */ (this.scene.shown);
    const { steps } = report;
    const fields = steps[at].fields ?? this.#source?.peek(at, arraysOf(this.scene.quantity));
    if (!fields) return undefined;
    const { low, high } = extremes(
      bodiesOf(report, steps[at], fields),
      this.scene.quantity,
      report,
    );
    return [low, high];
  }

  /** Says what is under the probe. @param {import('./read.js').Scales} scales */
  #read(scales) {
    this.readout.textContent = this.scene.probe
      ? readout(
          this.scene.bodies,
          this.scene.quantity,
          scales,
          this.scene.deformation,
          this.scene.camera.toWorld(...this.scene.probe),
        )
      : `${matchMedia('(pointer: coarse)').matches ? 'Tap the field for its figures; two fingers move and zoom it' : 'Point at the field for its figures; drag to move; click, then scroll to zoom'}.${sectionOf(scales.analysis) ? '' : ' White line: plastic zone.'}`;
    if (this.scene.probe) this.#fetchRead();
  }

  /** Fetches the arrays of the shown step that a reading is made of. */
  async #fetchRead() {
    const [source, shown, fields] = [this.#source, this.scene.shown, this.#fields];
    if (!source || !shown || this.#wanted?.at !== shown.at || source.peek(shown.at, READ)) return;
    if (this.#reading === fields) return;
    this.#reading = fields;
    const arrived = await source.get(shown.at, READ).catch((error) => error);
    if (this.#fields !== fields) return;
    if (!(arrived instanceof Error)) return this.scene.later(false);
    this.readout.textContent += ` · the others could not be loaded: ${arrived.message}`;
    if (!(arrived instanceof Problem) || arrived.status !== 0) return;
    await reconnected();
    if (this.#reading === fields) this.#reading = undefined;
    this.scene.later(false);
  }
}
