/**
 * All that is shown of solved jobs: the first in figures and pictures, the others laid over its
 * curves.
 */

import { arrange, button, byId, h } from '../lib/dom.js';
import { browser } from '../lib/kept.js';
import { paper } from '../lib/theme.js';
import { figure, setOf, unit, unitsOf } from '../lib/units.js';
import { sentence } from '../setup/send.js';
import { LayerSource, reportOf } from '../field/layers.js';
import { stemOf } from '../jobs/names.js';
import { FieldPanel } from '../field/panel.js';
import { through } from './answers.js';
import { axesOf } from './axes.js';
import { ConvergencePanel } from './convergence.js';
import { inUnits } from './converted.js';
import { DentPanel } from './dent.js';
import { DepthPanel } from './depth.js';
import { DifferencesPanel } from './differences.js';
import { DisplayUnits } from './display.js';
import { Downloads } from './downloads.js';
import { FiguresPanel } from './figures.js';
import { showHeadline } from './headline.js';
import { beside, isUnloaded, loadWords } from './loads.js';
import { MapPanel } from './map.js';
import { nextSteps } from './next.js';
import { segments } from './panel.js';
import { passesPanels } from './passes.js';
import { PressurePanel } from './pressure.js';
import { progressOf } from './progress.js';
import { hasYielded, rowOf } from './rows.js';
import { SpreadPanel } from './spread.js';
import { close, showSheet } from './sheet.js';
import { Steps } from './steps.js';
import { SweepPanel } from './sweep.js';
import { VaryPanel } from './vary.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Iteration} Iteration */

/** Whether more panels are shown, as this browser keeps it. */
const MORE = 'panels-more';
/** Panels that are seen before one asks for more. */
const FIRST = 3;

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

  /** @param {{fieldsWanted: () => void, before: () => string, compare: (id: string) => void, solve: (job: import('../types.js').Job) => void} & ConstructorParameters<typeof VaryPanel>[0]} on */
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
    this.steps = new Steps(
      (step) => this.#go(step),
      () => !this.field.busy,
    );
    this.units = new DisplayUnits(() => this.#again());
    this.downloads = new Downloads();
    this.before = button('Compare with the job before', () => on.compare(on.before()));
    const report = button('Report', () => this.report(), { id: 'report' });
    this.tools = h(
      'div',
      { class: 'bar view-tools', hidden: true },
      this.steps.element,
      this.before,
      report,
      this.downloads.element,
      this.units.element,
    );
    const solver = h(
      'details',
      { class: 'solver', hidden: true },
      h('summary', {}, 'Convergence'),
      this.convergence.panel.element,
    );
    this.solver = solver;
    this.columns = h('div', { class: 'columns' });
    this.rest = h('div', { class: 'columns' });
    this.more = h(
      'details',
      {
        class: 'rest-of-panels',
        open: browser.get(MORE) === 'true',
        ontoggle: () => browser.set(MORE, String(this.more.open)),
      },
      h('summary'),
      this.rest,
    );
    byId('panels').replaceChildren(
      this.tools,
      this.differences.panel.element,
      this.columns,
      this.vary.panel.element,
      this.more,
      this.figures.panel.element,
      solver,
    );
    addEventListener('beforeprint', () => {
      if (this.#shown.length) this.#sheet();
    });
  }

  get #panels() {
    const { vary, figures, differences, convergence } = this;
    const beside = [vary, figures, differences, convergence];
    return [...this.#ordered, ...beside].map(({ panel }) => panel);
  }

  get #charts() {
    const { pressure, spread, map, depth, sweep, dent, passes } = this;
    return [...passes, pressure, map, spread, dent, depth, sweep];
  }

  /** Panels beside the tools, those that answer the question first: strains over passes, the curve of a sweep, the dent of a history. */
  get #ordered() {
    const { sweep, dent, map, passes, pressure, field, other, spread, depth } = this;
    const step = this.#shown[0]?.report.steps[this.#at];
    const [ofPasses, ...others] = passes;
    const left = map.panel.element.hidden ? dent : map;
    const first = step && isUnloaded(step) ? [left] : [ofPasses];
    const curve = step && !step.increments ? [sweep] : [];
    const all = [...first, ...curve, map, pressure, field, other, depth, spread, ...others];
    return [...new Set([...all, dent, sweep])];
  }

  /** Three panels are seen, a field beside another counting as one; the others are behind “more”. */
  #arrange() {
    const all = this.#ordered;
    const seen = all.filter(({ panel }) => !panel.element.hidden);
    const first = seen.filter((one) => one !== this.other).slice(0, FIRST);
    if (first.includes(this.field) && seen.includes(this.other))
      first.splice(first.indexOf(this.field) + 1, 0, this.other);
    const rest = seen.filter((one) => !first.includes(one));
    // The field beside is on the page only where jobs are compared: it has the tools of the other.
    const hidden = all.filter(({ panel }) => panel.element.hidden && panel !== this.other.panel);
    const elements = (/** @type {typeof all} */ list) => list.map(({ panel }) => panel.element);
    arrange(this.columns, elements(first));
    arrange(this.rest, elements([...rest, ...hidden]));
    this.more.hidden = rest.length === 0;
    /** @type {HTMLElement} */ (this.more.firstChild).textContent =
      `More: ${rest.map(({ panel }) => panel.title.toLowerCase()).join(', ')}`;
  }

  /** Shows a message instead of a result. @param {Node} content */
  clear(content) {
    this.#given = this.#shown = [];
    this.tools.hidden = true;
    this.steps.stop();
    for (const panel of this.#panels) panel.show(false);
    // What is drawn from here on is of another job.
    performance.clearMarks('field-drawn');
    this.field.clear();
    this.other.clear();
    this.solver.hidden = this.more.hidden = true;
    byId('headline').replaceChildren(content);
  }

  /**
   * Before anything is solved.
   * @param {import('../setup/check.js').Hertz | null} hertz
   * @param {import('../types.js').Job} job
   */
  preview(hertz, job) {
    const highest = hertz?.steps.reduce((a, b) => (b.force > a.force ? b : a), hertz.steps[0]);
    if (highest && highest.peak_pressure > 0)
      this.pressure.preview(highest, unitsOf(job), job.analysis === 'axisymmetric');
    else this.pressure.panel.show(false);
    this.#arrange();
  }

  /** While it runs. @param {Iteration[]} history @param {import('../types.js').Job} job */
  iterate(history, job) {
    const units = unitsOf(job);
    const set = this.units.set(units);
    const shown = inUnits(history, { analysis: job.analysis, units }, set);
    this.convergence.show(shown, set, Number(job.solver?.tolerance ?? 1e-6));
    byId('headline').replaceChildren(soFar(history, job));
    this.solver.hidden = history.length === 0;
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

  /** Whether a job that is shown has several loads. */
  get #isCurve() {
    return this.#shown.some(({ report }) => report.steps.length > 1);
  }

  #sheet() {
    // There is one page: of a load that rolls the pressure is in figures, of a line the groove too; one load has neither curve nor dent.
    const [{ report }] = this.#shown;
    const rolled = report.steps[this.#at].passes !== undefined;
    const left = [
      ...(rolled ? ['pressure'] : []),
      ...(rolled && report.analysis !== 'three_dimensional' ? ['groove'] : []),
      ...(this.#isCurve ? [] : ['sweep', 'dent']),
    ];
    showSheet({
      shown: this.#shown,
      at: this.#at,
      drawings: this.#charts.flatMap(({ panel, chart }) =>
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
    for (const { panel } of [...this.#charts, this.field, this.convergence]) {
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
    this.before.hidden = this.on.before() === '';
    const next = id && raw ? nextSteps(job, raw, this.#at) : [];
    showHeadline(shown, this.#at, next, this.on.solve);
    for (const panel of [...this.#charts, this.vary, this.figures]) panel.show(shown, this.#at);
    this.differences.show(shown);
    this.convergence.show(step.history, report.units, Number(job.solver?.tolerance ?? 1e-6));
    this.solver.hidden = step.history.length === 0;
    this.#showField(this.#anew);
    this.#anew = false;
    // Its map has the cuts.
    if (!this.map.panel.element.hidden && this.map.hasCuts) this.pressure.panel.show(false);
    this.#arrange();
    this.downloads.show({ ...shown[0], report: raw ?? report }, this.#at, this.#panels);
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
    // All steps of a job are looked at in the same quantity.
    const yields = raw.steps.some(hasYielded);
    const asked = { job, at: this.#at, yields, units: setOf(report.units) };
    if (report.steps[0]?.passes) this.field.clear();
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

/** How far it is, until there is an answer. @param {Iteration[]} history @param {import('../types.js').Job} job */
function soFar(history, job) {
  const { words, part } = progressOf(history, job);
  return h(
    'div',
    { class: 'so-far' },
    h(
      'p',
      { class: 'verdict-text' },
      h('span', { class: 'mark', 'aria-hidden': 'true' }, '…'),
      h('span', {}, sentence(words)),
    ),
    h('progress', { max: 1, value: part, 'aria-label': 'Part of the work that is done' }),
  );
}

/** The field of a job, its step as it is laid beside that of the first. @param {Shown} one @param {number} at @param {'x' | 'y'} axis */
function fieldOf({ job, report, raw, fields }, at, axis) {
  if (!raw || !fields) return undefined;
  const asked = { job, at, yields: raw.steps.some(hasYielded), units: setOf(report.units) };
  return fields instanceof LayerSource
    ? { asked: { ...asked, report: reportOf(raw, axis) }, source: fields.planes[axis] }
    : { asked: { ...asked, report: raw }, source: fields };
}

/** The step that is seen first: that of the force that was looked for, else the last one. @param {Shown} one */
const askedStep = ({ report }) => (rowOf(report, 'force_found') ? 0 : report.steps.length - 1);

/** Names the sections of half-spaces in the axes of the job, by the place that both go through. @param {HTMLElement} choice @param {import('../types.js').Step} step */
function namePlanes(choice, step) {
  const axes = axesOf(step);
  const place = through(step);
  const name = (/** @type {'x' | 'y'} */ axis) =>
    `${axes[axis].name} = ${figure(axes[axis].sign * place[axis] || 0, 3)}`;
  const [along, across] = choice.querySelectorAll('span');
  along.textContent = name('y');
  across.textContent = name('x');
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
