/**
 * Asks the service about the draft as one types: is it in order, what would it cost, what does Hertz say, when does it
 * yield. An answer that has been overtaken is dropped.
 */

import { Problem, post } from '../api/client.js';
import { onReconnect } from '../api/connection.js';
import { byId, debounce, h } from '../lib/dom.js';
import { inWords } from './words.js';
import { figure, forceOf, grouped, megabytes, unit, unitsOf } from '../lib/units.js';

/** Time to go on typing. */
const QUIET = 150;

/** @typedef {import('../api/client.js').FieldError} FieldError */
/** @typedef {{effective_radius: number, yield_onset_force: number | null, steps: {force: number, half_width: number, peak_pressure: number, yields: boolean}[]}} Hertz */

export class Check {
  /** @type {AbortController | undefined} */
  #running;
  /** @type {Hertz | null} */
  hertz = null;
  valid = true;

  /**
   * @param {import('./draft.js').Draft} draft
   * @param {import('./form.js').Form} form
   * @param {(hertz: Hertz | null) => void} on
   */
  constructor(draft, form, on) {
    this.draft = draft;
    this.form = form;
    this.on = on;
    const later = debounce(() => this.now(), QUIET);
    draft.addEventListener('change', () => {
      // What has been said so far is of another draft.
      document.body.dataset.check = 'asking';
      later();
    });
    onReconnect(() => this.now());
  }

  async now() {
    this.#running?.abort();
    const { signal } = (this.#running = new AbortController());
    const job = structuredClone(this.draft.job);
    try {
      const [validation, hertz] = await Promise.all([
        post('v1/validate', job, signal).then(
          (answer) => ({ estimate: answer.estimate, problem: undefined }),
          notAborted,
        ),
        closedForm(job, signal),
      ]);
      if (signal.aborted) return;
      this.hertz = hertz;
      this.#show(job, validation);
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }

  /** @param {Problem} problem a refusal of the job as a whole or in parts @param {import('../types.js').Job} job */
  refuse(problem, job) {
    delete document.body.dataset.check;
    this.valid = false;
    const others = this.form.showError(problem.errors, job);
    const whole = problem.errors.length === 0 ? [h('p', { class: 'error' }, inWords(problem.message))] : [];
    const rest = others.map(({ pointer, detail }) =>
      h('p', { class: 'error' }, pointer ? [h('code', {}, pointer), ' '] : null, detail),
    );
    byId('check').replaceChildren(...whole, ...rest);
    const { estimate } = problem.body;
    byId('cost').textContent = estimate ? cost(estimate, job) : '';
  }

  /** @param {import('../types.js').Job} job @param {{estimate?: {equations: number, bytes: number}, problem?: Problem}} validation */
  #show(job, { estimate, problem }) {
    // Nothing is known of this draft: it is asked again after a while.
    if (problem?.status === 0) return;
    delete document.body.dataset.check;
    if (problem) {
      this.refuse(problem, job);
    } else {
      this.valid = true;
      this.form.showError([]);
      byId('check').replaceChildren(...(this.hertz ? [figures(job, this.hertz)] : []));
      byId('cost').textContent = estimate ? cost(estimate, job) : '';
    }
    this.on(this.hertz);
  }
}

/** @param {unknown} error */
function notAborted(error) {
  if (error instanceof Problem) return { estimate: undefined, problem: error };
  throw error;
}

/** Bytes of the fields at a node, in single precision: its place, its displacement, six figures, and its part of the elements. */
const NODE = 4 * (2 + 2 + 6) + 16;

/** @param {{equations: number, bytes: number}} estimate @param {import('../types.js').Job} job @returns {string} what it takes to solve it, and to look at it */
function cost({ equations, bytes }, job) {
  const steps = (job.load?.forces ?? job.load?.approaches ?? job.load?.history)?.length ?? 1;
  const parts = [`${grouped(equations)} equations, ${megabytes(bytes)}`];
  if (steps > 1) parts.push(`${steps} steps`);
  if (job.output?.fields) parts.push(`fields ${megabytes((steps * equations * NODE) / 2)}`);
  return parts.join(', ');
}

/**
 * Hertz for the job's forces; where it prescribes something else, for a unit of force, which still tells the onset.
 * @param {import('../types.js').Job} job
 * @param {AbortSignal} signal
 * @returns {Promise<Hertz | null>} nothing where the theory does not apply
 */
async function closedForm(job, signal) {
  const loads = Array.isArray(job.load?.history) ? job.load.history : [];
  const highest = Math.max(0, ...loads.map((/** @type {any} */ load) => Number(load?.force) || 0));
  const forced = job.load?.force !== undefined || job.load?.forces !== undefined || highest > 0;
  const load = highest > 0 ? { force: highest } : forced ? job.load : { force: 1 };
  try {
    const answer = await post('v1/hertz', { ...job, load }, signal);
    return forced ? answer : { ...answer, steps: [] };
  } catch (error) {
    if (error instanceof Problem) return null;
    throw error;
  }
}

/** @param {import('../types.js').Job} job @param {Hertz} hertz */
function figures(job, hertz) {
  const units = unitsOf(job);
  const at = hertz.steps.reduce(
    (a, b) => (b.force > (a?.force ?? 0) ? b : a),
    /** @type {Hertz['steps'][0] | undefined} */ (undefined),
  );
  const row = (/** @type {string} */ name, /** @type {number | null} */ value, /** @type {string} */ unit) =>
    h(
      'div',
      {},
      h('dt', {}, name),
      h('dd', {}, figure(value), ' ', h('span', { class: 'unit' }, value === null ? '' : unit)),
    );
  const onset = hertz.yield_onset_force;
  const verdict =
    at && onset
      ? at.yields
        ? h(
            'p',
            { class: 'verdict yields' },
            `Yields: the force is ${figure(at.force / onset, 3)} times that of first yield, Hertz no longer holds.`,
          )
        : h('p', { class: 'verdict' }, `Elastic: ${figure((100 * at.force) / onset, 3)} % of the force of first yield.`)
      : null;
  return h(
    'div',
    { class: 'hertz' },
    h('h3', {}, 'Hertz, elastic'),
    h(
      'dl',
      {},
      at && row('half-width', at.half_width, unit('length', units)),
      at && row('peak pressure', at.peak_pressure, unit('stress', units)),
      row('first yield at', onset, unit(forceOf(job), units)),
      row('effective radius', hertz.effective_radius, unit('length', units)),
    ),
    verdict,
  );
}
