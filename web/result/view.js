/** All that is shown of solved jobs: the first in figures and pictures, the others laid over its curves. */

import { byId, h } from '../lib/dom.js';
import { figure, forceOf, unit, unitsOf } from '../lib/units.js';
import { FieldPanel } from '../field/panel.js';
import { ConvergencePanel } from './convergence.js';
import { DepthPanel } from './depth.js';
import { showHeadline } from './headline.js';
import { HistoryPanel } from './history.js';
import { PressurePanel } from './pressure.js';
import { SweepPanel } from './sweep.js';

/** @typedef {import('../types.js').Shown} Shown */
/** @typedef {import('../types.js').Iteration} Iteration */

export class View {
  /** @type {Shown[]} */
  #shown = [];
  #at = 0;

  /** @param {() => void} fieldsWanted */
  constructor(fieldsWanted) {
    this.pressure = new PressurePanel();
    this.field = new FieldPanel(fieldsWanted);
    this.depth = new DepthPanel();
    this.convergence = new ConvergencePanel();
    this.sweep = new SweepPanel();
    this.history = new HistoryPanel();
    this.steps = h('div', { class: 'bar steps', hidden: true });
    const column = (/** @type {{panel: import('./panel.js').Panel}[]} */ ...parts) =>
      h(
        'div',
        { class: 'column' },
        parts.map(({ panel }) => panel.element),
      );
    byId('panels').replaceChildren(
      this.steps,
      column(this.pressure, this.depth, this.sweep),
      column(this.field, this.convergence),
      this.history.panel.element,
    );
  }

  /** Before there is anything. @param {Node} content */
  clear(content) {
    this.#shown = [];
    this.steps.hidden = true;
    for (const { panel } of [this.sweep, this.pressure, this.field, this.depth, this.convergence, this.history])
      panel.show(false);
    byId('headline').replaceChildren(content);
  }

  /** Before anything is solved. @param {import('../setup/check.js').Hertz | null} hertz @param {import('../types.js').Job} job */
  preview(hertz, job) {
    const highest = hertz?.steps.reduce((a, b) => (b.force > a.force ? b : a), hertz.steps[0]);
    if (highest) this.pressure.preview(highest, unitsOf(job), job.analysis === 'axisymmetric');
    else this.pressure.panel.show(false);
  }

  /** While it runs. @param {Iteration[]} history @param {import('../types.js').Job} job */
  iterate(history, job) {
    this.convergence.show(history, unitsOf(job), Number(job.solver?.tolerance ?? 1e-6));
  }

  /** @param {Shown[]} shown the first is the one in figures */
  show(shown) {
    const anew = shown[0]?.report !== this.#shown[0]?.report;
    this.#shown = shown;
    if (shown.length === 0) return;
    if (anew) this.#at = shown[0].report.steps.length - 1;
    this.#showSteps();
    this.#showStep();
  }

  #showSteps() {
    const [{ report }] = this.#shown;
    const last = report.steps.length - 1;
    this.steps.hidden = last < 1;
    if (last < 1) return;
    const label = h('output');
    const say = () => {
      const { contact } = report.steps[this.#at];
      label.textContent = `${this.#at + 1} of ${last + 1}: ${figure(contact.force)} ${unit(forceOf(report), report.units)}`;
    };
    const slider = h('input', {
      type: 'range',
      min: 0,
      max: last,
      value: this.#at,
      oninput: () => {
        this.#at = Number(slider.value);
        say();
        this.#showStep();
      },
    });
    say();
    this.steps.replaceChildren(h('label', {}, 'Step ', slider), label);
  }

  #showStep() {
    const shown = this.#shown;
    const [{ job, report }] = shown;
    const step = report.steps[this.#at];
    showHeadline(shown[0], this.#at);
    this.sweep.show(shown, this.#at);
    this.pressure.show(shown, this.#at);
    this.depth.show(shown, this.#at);
    this.convergence.show(step.history, report.units, Number(job.solver?.tolerance ?? 1e-6));
    this.history.show(step.history, report.units);
    this.field.show(report, this.#at);
  }
}
