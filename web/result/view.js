/**
 * All that is shown of solved jobs: the first in figures and pictures, the others laid over its
 * curves.
 */

import { arrange, byId, h } from '../lib/dom.js';
import { paper } from '../lib/theme.js';
import { figure, setOf, unit, unitsOf } from '../lib/units.js';
import { sentence } from '../setup/send.js';
import { LayerSource, reportOf } from '../field/layers.js';
import { stemOf } from '../jobs/names.js';
import { FieldPanel } from '../field/panel.js';
import { answersOf } from './answers.js';
import { axesOf } from './axes.js';
import { ConvergencePanel } from './convergence.js';
import { inUnits } from './converted.js';
import { DentPanel } from './dent.js';
import { DepthPanel } from './depth.js';
import { DifferencesPanel } from './differences.js';
import { DisplayUnits } from './display.js';
import { FiguresPanel } from './figures.js';
import { showHeadline } from './headline.js';
import { HistoryPanel } from './history.js';
import { beside, isUnloaded, loadWords } from './loads.js';
import { MapPanel } from './map.js';
import { segments } from './panel.js';
import { passesPanels } from './passes.js';
import { PressurePanel } from './pressure.js';
import { progressWords } from './progress.js';
import { SpreadPanel } from './spread.js';
import { close, showSheet } from './sheet.js';
import { Steps } from './steps.js';
import { SweepPanel } from './sweep.js';
import { VaryPanel } from './vary.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Iteration} Iteration */

/** Least width of a column [px]. */
const COLUMN = 440;
/** About how high panels are [px], so that columns end together. */
const HEIGHTS = new Map([
  ['field', 560],
  ['field-beside', 560],
  ['map', 560],
  ['depth', 400],
  ['spread', 300],
  ['dent', 320],
  ['vary', 250],
]);

export class View {
  /** Results in the units of their jobs. @type {Shown[]} */
  #given = [];
  /** Results in the shown units. @type {Shown[]} */
  #shown = [];
  #at = 0;
  #otherId = '';
  /** Whether the field has not shown this job. */
  #anew = false;
  /** Along which a section of half-spaces lies. @type {'x' | 'y'} */
  #axis = 'x';

  /** @param {{fieldsWanted: () => void, stepped: (step: number) => void} & ConstructorParameters<typeof VaryPanel>[0]} on */
  constructor(on) {
    this.on = on;
    this.pressure = new PressurePanel();
    this.plane = segments('Section of the field', { x: 'y = 0', y: 'x = 0' }, (axis) => {
      this.#axis = /** @type {'x' | 'y'} */ (axis);
      this.#showField(true);
    });
    this.field = new FieldPanel(on.fieldsWanted, [this.plane]);
    /** Of the job that is compared first, on the scale of the other. */
    this.other = new FieldPanel(on.fieldsWanted, [], 'field-beside');
    this.field.peer = this.other;
    this.other.peer = this.field;
    this.spread = new SpreadPanel();
    this.map = new MapPanel(on.fieldsWanted);
    this.depth = new DepthPanel();
    this.convergence = new ConvergencePanel();
    this.sweep = new SweepPanel();
    this.dent = new DentPanel();
    this.passes = passesPanels();
    this.vary = new VaryPanel(on);
    this.figures = new FiguresPanel((step) => this.#go(step));
    this.differences = new DifferencesPanel();
    this.history = new HistoryPanel();
    this.steps = new Steps(
      (step) => this.#go(step),
      () => !this.field.busy,
    );
    this.units = new DisplayUnits(() => this.#again());
    const report = h(
      'button',
      { type: 'button', id: 'report', onclick: () => this.report() },
      'Report',
    );
    this.tools = h(
      'div',
      { class: 'bar view-tools', hidden: true },
      this.steps.element,
      report,
      this.units.element,
    );
    const solver = h(
      'details',
      { class: 'solver', hidden: true },
      h('summary', {}, 'Convergence and iterations'),
      h('div', { class: 'pair' }, this.convergence.panel.element, this.history.panel.element),
    );
    this.solver = solver;
    this.columns = h('div', { class: 'columns' });
    byId('panels').replaceChildren(
      this.tools,
      this.columns,
      this.figures.panel.element,
      this.differences.panel.element,
      solver,
    );
    new ResizeObserver(() => this.#arrange()).observe(this.columns);
    addEventListener('beforeprint', () => {
      if (this.#shown.length) this.#sheet();
    });
  }

  /** The step of the first job that is shown, counted from 0. */
  get step() {
    return this.#at;
  }

  get #charts() {
    const { pressure, spread, map, depth, sweep, dent, passes } = this;
    return [pressure, spread, map, depth, sweep, dent, ...passes];
  }

  /**
   * Puts the panels that are seen into as many columns as there is room for, the one that answers
   * the question first: the curve of a sweep, the dent of a history, the map of half-spaces.
   */
  #arrange() {
    const { sweep, dent, map, passes, pressure, field, other, spread, depth, vary } = this;
    const step = this.#shown[0]?.report.steps[this.#at];
    const left = step && isUnloaded(step);
    const all = [
      ...(vary.hasCurve ? [vary] : []),
      ...(left ? [dent] : []),
      ...(step && !step.flow ? [sweep] : []),
      ...passes,
      map,
      pressure,
      field,
      other,
      spread,
      depth,
      dent,
      sweep,
      vary,
    ];
    const seen = [...new Set(all)].filter(({ panel }) => !panel.element.hidden);
    const many = Math.max(
      1,
      Math.min(seen.length, Math.floor(this.columns.clientWidth / COLUMN) || 1),
    );
    while (this.columns.children.length < many) this.columns.append(h('div', { class: 'column' }));
    while (this.columns.children.length > many && this.columns.lastElementChild) {
      const last = this.columns.lastElementChild;
      this.columns.firstElementChild?.append(...last.children);
      last.remove();
    }
    const columns = [...this.columns.children].map((element) => ({
      element,
      high: 0,
      own: /** @type {Node[]} */ ([]),
    }));
    for (const one of seen) {
      const least = columns.reduce((a, b) => (b.high < a.high - 1 ? b : a));
      least.own.push(one.panel.element);
      least.high += one === vary && vary.hasCurve ? 700 : (HEIGHTS.get(one.panel.id) ?? 360);
    }
    // The field beside is on the page only where jobs are compared: it has the tools of the other.
    const hidden = [...new Set(all)]
      .filter((one) => one.panel.element.hidden && one !== other)
      .map(({ panel }) => panel.element);
    columns.forEach(({ element, own }, k) => arrange(element, k ? own : [...own, ...hidden]));
  }

  /** Shows a message instead of a result. @param {Node} content */
  clear(content) {
    this.#given = this.#shown = [];
    this.tools.hidden = true;
    this.steps.stop();
    for (const { panel } of [
      this.sweep,
      ...this.passes,
      this.dent,
      this.pressure,
      this.spread,
      this.map,
      this.depth,
      this.vary,
      this.convergence,
      this.figures,
      this.differences,
      this.history,
    ])
      panel.show(false);
    this.field.clear();
    this.other.clear();
    this.solver.hidden = true;
    byId('headline').replaceChildren(content);
  }

  /**
   * Before anything is solved.
   * @param {import('../setup/check.js').Hertz | null} hertz
   * @param {import('../types.js').Job} job
   */
  preview(hertz, job) {
    const highest = hertz?.steps.reduce((a, b) => (b.force > a.force ? b : a), hertz.steps[0]);
    if (highest) this.pressure.preview(highest, unitsOf(job), job.analysis === 'axisymmetric');
    else this.pressure.panel.show(false);
    this.#arrange();
  }

  /** While it runs. @param {Iteration[]} history @param {import('../types.js').Job} job */
  iterate(history, job) {
    const units = unitsOf(job);
    const set = this.units.set(units);
    const shown = inUnits(history, { analysis: job.analysis, units }, set);
    this.convergence.show(shown, set, Number(job.solver?.tolerance ?? 1e-6));
    byId('headline').replaceChildren(soFar(shown, job, set));
    // Until there is an answer, it is all there is to see.
    if (this.solver.hidden) this.solver.open = true;
    this.solver.hidden = false;
  }

  /** @param {Shown[]} shown the first is the one in figures @param {boolean} [moving] whether a slider moves: axes hold, and what was before it stays in grey */
  show(shown, moving = false) {
    for (const { chart } of this.#charts) chart.hold(moving);
    const anew = shown[0]?.id !== this.#given[0]?.id;
    if (this.#given[0]?.fields !== shown[0]?.fields) this.#given[0]?.fields?.close();
    this.#given = shown;
    if (shown.length === 0) return;
    const last = shown[0].report.steps.length - 1;
    this.#at = anew ? askedStep(shown[0]) : Math.min(this.#at, last);
    this.#anew ||= anew;
    // A part of a chart that was dragged up is a part of that job's.
    if (anew && !moving) {
      for (const { chart } of this.#charts) chart.whole();
      this.solver.open = false;
    }
    this.#again();
  }

  /** The sheet of what is shown, to be printed. */
  report() {
    const { dataset } = document.documentElement;
    const open = () => {
      this.#sheet();
      byId('sheet').querySelector('button')?.focus();
    };
    dataset.view = 'sheet';
    open();
    scrollTo(0, 0);
    // The field may be on its way.
    if (this.field.busy) this.field.settled.then(() => dataset.view === 'sheet' && open());
  }

  /** Makes the sheet anew where it is seen. */
  refreshReport() {
    if (document.documentElement.dataset.view === 'sheet') this.report();
  }

  /** Back to the page, from the sheet. */
  closeReport() {
    if (document.documentElement.dataset.view === 'sheet') close();
  }

  #sheet() {
    // Of a line that rolls, groove and pressure are figures: there is one page.
    const [{ report }] = this.#shown;
    const rolled = report.analysis !== 'three_dimensional' && report.steps[this.#at].rolling;
    const left = rolled ? ['groove', 'pressure'] : [];
    showSheet({
      shown: this.#shown,
      at: this.#at,
      drawings: [
        ...this.passes,
        this.pressure,
        this.spread,
        this.dent,
        this.depth,
        this.sweep,
      ].flatMap(({ panel, chart }) =>
        panel.element.hidden || left.includes(panel.id)
          ? []
          : (chart.drawing(panel.caption, 380, 135) ?? []),
      ),
      fields: [...this.#maps(), this.other.canvas(undefined, paper)].filter((one) => one !== null),
      cutDrawing: this.field.cutDrawing(),
    });
  }

  /** Of half-spaces their maps, of other bodies the field: there is one page. */
  #maps() {
    const maps = this.map.allOnPaper();
    return maps.length
      ? maps
      : [this.field.canvas(undefined, paper)].filter((one) => one !== null);
  }

  /** @param {number} step */
  #go(step) {
    this.#at = step;
    this.on.stepped(step);
    this.#showStep();
  }

  #again() {
    if (this.#given.length === 0) return;
    const set = this.units.set(
      /** @type {import('../lib/units.js').Units} */ (this.#given[0].report.units),
    );
    this.#shown = this.#given.map((one) => {
      const { analysis, units } = one.report;
      const of = { analysis, units: /** @type {import('../lib/units.js').Units} */ (units) };
      return { ...one, raw: one.report, report: { ...inUnits(one.report, of, set), units: set } };
    });
    this.tools.hidden = false;
    this.#showStep();
  }

  #showStep() {
    const shown = this.#shown;
    const [{ id, job, report, raw, label }] = shown;
    const step = report.steps[this.#at];
    const many = report.steps.length;
    const load = loadWords(report, this.#at);
    const stem = stemOf(job, id) + otherUnits(raw?.units ?? report.units, report.units);
    for (const { panel } of [
      this.pressure,
      this.spread,
      this.map,
      ...this.passes,
      this.dent,
      this.depth,
      this.field,
      this.convergence,
      this.history,
    ]) {
      panel.of =
        many > 1 ? `${label}, step ${this.#at + 1} of ${many}, ${load}` : `${label}, ${load}`;
      panel.stem = many > 1 ? `${stem}-step-${this.#at + 1}` : stem;
    }
    // Curves of several jobs have the step of each in the legend.
    if (shown.length > 1)
      for (const { panel } of [this.pressure, this.spread, this.depth]) panel.of = '';
    // So have those of sweeps, among which the first job need not be.
    this.sweep.panel.of = shown.length > 1 ? '' : label;
    for (const { panel } of [this.sweep, this.vary, this.figures, this.differences])
      panel.stem = stem;
    this.steps.show(many, this.#at, load);
    showHeadline(shown, this.#at);
    this.sweep.show(shown, this.#at);
    this.pressure.show(shown, this.#at);
    this.spread.show(shown, this.#at);
    this.map.show(shown, this.#at);
    this.dent.show(shown, this.#at);
    for (const panel of this.passes) panel.show(shown, this.#at);
    this.depth.show(shown, this.#at);
    this.vary.show(shown, this.#at);
    this.figures.show(shown, this.#at);
    this.differences.show(shown);
    this.convergence.show(step.history, report.units, Number(job.solver?.tolerance ?? 1e-6));
    this.history.show(step.history, report.units);
    this.solver.hidden = step.history.length === 0;
    this.#showField(this.#anew);
    this.#anew = false;
    this.#arrange();
  }

  /** The field of the job that is compared first. */
  #showOther() {
    const [, side] = beside(this.#shown, this.#at);
    const found =
      side && !this.field.panel.element.hidden && fieldOf(side.one, side.at, this.#axis);
    if (!found) return this.other.clear();
    const anew = this.#otherId !== side.one.id;
    this.#otherId = side.one.id;
    this.other.panel.rename(`Field: ${side.label}`);
    this.other.follow(this.field.quantity);
    this.other.show(found.asked, anew, /** @type {any} */ (found.source));
  }

  /** @param {boolean} anew whether the whole contact is to be seen */
  #showField(anew) {
    const [{ job, report, raw, fields }] = this.#shown;
    const solid = report.analysis === 'three_dimensional';
    this.plane.hidden = !solid;
    if (!raw) return;
    if (solid) namePlanes(this.plane, report.steps[this.#at]);
    const yields = hasYielded(raw);
    const asked = { job, at: this.#at, yields, units: setOf(report.units) };
    if (report.steps[0]?.rolling) this.field.clear();
    else if (!solid) this.field.show({ ...asked, report: raw }, anew, /** @type {any} */ (fields));
    // The map offers to solve again with both.
    else if (!job.output?.fields) this.field.clear();
    else {
      const source = fields instanceof LayerSource ? fields.planes[this.#axis] : undefined;
      this.field.show({ ...asked, report: reportOf(raw, this.#axis) }, anew, source);
    }
    this.#showOther();
  }
}

/** The figures of the last iteration, until there is an answer. @param {Iteration[]} history @param {import('../types.js').Job} job @param {import('../lib/units.js').UnitSet} set */
function soFar(history, job, set) {
  const last = history[history.length - 1];
  const row = (
    /** @type {string} */ name,
    /** @type {number} */ value,
    /** @type {string} */ of,
  ) =>
    h(
      'div',
      {},
      h('dt', {}, name),
      h(
        'dd',
        {},
        h('span', { class: 'figure' }, figure(value, 4), h('span', { class: 'unit' }, of)),
        h('span', { class: 'bar-of-error' }, 'so far'),
      ),
    );
  return h(
    'div',
    {},
    h(
      'p',
      { class: 'verdict-text neutral' },
      h('span', { class: 'mark', 'aria-hidden': 'true' }, '…'),
      h('span', {}, sentence(progressWords(history, job))),
    ),
    last
      ? h(
          'dl',
          { class: 'figures' },
          row('Peak pressure', last.peak_pressure, unit('stress', set)),
          row('Approach', last.approach, unit('length', set)),
          row('Contact pairs', last.contact_pairs, ''),
          row('Points that yield', last.plastic_points, ''),
        )
      : null,
  );
}

/** Whether a body yields in any step: all steps of a job are looked at in the same quantity. @param {import('../types.js').Report} report */
const hasYielded = ({ steps }) =>
  steps.some(({ plasticity: { upper, lower } }) => upper?.yielded || lower?.yielded);

/** The field of a job, its step as it is laid beside that of the first. @param {Shown} one @param {number} at @param {'x' | 'y'} axis */
function fieldOf({ job, report, raw, fields }, at, axis) {
  if (!raw || !fields) return undefined;
  const asked = { job, at, yields: hasYielded(raw), units: setOf(report.units) };
  return fields instanceof LayerSource
    ? { asked: { ...asked, report: reportOf(raw, axis) }, source: fields.planes[axis] }
    : { asked: { ...asked, report: raw }, source: fields };
}

/** The step that is seen first: that of the force that was looked for, else the last one. @param {Shown} one */
function askedStep({ report }) {
  const found = report.steps.findIndex((step) =>
    answersOf(step, report).some(({ name }) => name === 'force_found'),
  );
  return found < 0 ? report.steps.length - 1 : found;
}

/** Names the sections of half-spaces in the axes of the job. @param {HTMLElement} choice @param {import('../types.js').Step} step */
function namePlanes(choice, { three_dimensional: ellipse }) {
  const axes = axesOf(ellipse ?? { orientation: 0 });
  const [along, across] = choice.querySelectorAll('span');
  along.textContent = `${axes.y.name} = 0`;
  across.textContent = `${axes.x.name} = 0`;
}

/**
 * The units of figures that are shown in others than those of their job, as a part of the names of
 * files: those that the service writes are in the job's.
 * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} own
 * @param {import('../lib/units.js').Units | import('../lib/units.js').UnitSet} shown
 */
const otherUnits = (own, shown) =>
  /** @type {const} */ (['length', 'stress', 'force'])
    .flatMap((quantity) =>
      unit(quantity, own) === unit(quantity, shown) ? [] : [`-${unit(quantity, shown)}`],
    )
    .join('');
