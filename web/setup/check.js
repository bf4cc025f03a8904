/**
 * Asks the service about the draft as one types: is it in order, what would it cost, what does
 * Hertz say, when does it yield. An answer that has been overtaken is dropped.
 */

import { Problem, post } from '../api/client.js';
import { onReconnect } from '../api/connection.js';
import { byId, debounce, h } from '../lib/dom.js';
import { hasInitialStress } from './fields.js';
import { closedForm } from './hertz.js';
import { sentence } from './send.js';
import { inWords } from './words.js';
import { figure, forceOf, grouped, megabytes, unit, unitsOf } from '../lib/units.js';

/** Time to go on typing. */
const QUIET = 150;

/** @typedef {import('../api/client.js').FieldError} FieldError */
/** @typedef {import('./hertz.js').Hertz} Hertz */

export class Check {
  /** @type {AbortController | undefined} */
  #running;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #again;
  /** @type {Hertz | null} */
  hertz = null;
  valid = true;

  /**
   * @param {import('./draft.js').Draft} draft
   * @param {import('./form.js').Form} form
   * @param {{remark: (words: string) => void}} json
   * @param {(hertz: Hertz | null) => void} on
   */
  constructor(draft, form, json, on) {
    this.draft = draft;
    this.form = form;
    this.json = json;
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
    clearTimeout(this.#again);
    const { signal } = (this.#running = new AbortController());
    const job = structuredClone(this.draft.job);
    try {
      const [validation, { hertz, why }] = await Promise.all([
        post('v1/validate', job, { signal }).then(
          (answer) => ({ estimate: answer.estimate, problem: undefined }),
          (error) => {
            if (error instanceof Problem && !isElsewhere(error))
              return { estimate: undefined, problem: error };
            throw error;
          },
        ),
        closedForm(job, signal),
      ]);
      if (signal.aborted) return;
      this.hertz = hertz;
      this.#show(job, validation, why);
    } catch (error) {
      if (signal.aborted) return;
      if (!(error instanceof Problem)) throw error;
      // What is too long is so the next time too.
      if (error.status === 413) this.refuse(error, job);
      else this.#wait(error);
    }
  }

  /** Nothing is known of this draft: it is asked again, when the service is back or after a while. @param {Problem} problem */
  #wait({ status, message, retryAfter }) {
    if (status === 401) {
      // Figures of another draft go with what hides them.
      delete document.body.dataset.check;
      byId('cost').textContent = '';
      return byId('check').replaceChildren(
        h('p', { class: 'error' }, 'The service asks for an API key.'),
      );
    }
    if (status === 0) return;
    this.#again = setTimeout(() => this.now(), 1000 * retryAfter);
    byId('check').replaceChildren(
      h('p', { class: 'quiet' }, `The set-up is not checked yet: ${message}. It is asked again.`),
    );
  }

  /** @param {Problem} problem a refusal of the job as a whole or in parts @param {import('../types.js').Job} job */
  refuse(problem, job) {
    delete document.body.dataset.check;
    this.valid = false;
    const others = this.form.showError(problem.errors, job);
    const whole =
      problem.errors.length === 0 ? [h('p', { class: 'error' }, sentence(problem.message))] : [];
    const rest = others.map(({ pointer, detail }) =>
      h('p', { class: 'error' }, pointer ? [h('code', {}, pointer), ' '] : null, inWords(detail)),
    );
    byId('check').replaceChildren(...whole, ...rest);
    this.json.remark(unknownWords(problem.errors));
    const { estimate } = problem.body;
    byId('cost').textContent = estimate ? cost(estimate, job) : '';
  }

  /** @param {import('../types.js').Job} job @param {{estimate?: {equations: number, bytes: number}, problem?: Problem}} validation @param {string} why Hertz has no figures */
  #show(job, { estimate, problem }, why) {
    delete document.body.dataset.check;
    if (problem) {
      this.refuse(problem, job);
    } else {
      this.valid = true;
      this.form.showError([]);
      this.json.remark('');
      byId('check').replaceChildren(
        ...(this.hertz && isTelling(this.hertz) ? [figures(job, this.hertz)] : []),
        ...(why ? [h('p', { class: 'quiet' }, `Hertz’s theory does not apply: ${why}.`)] : []),
      );
      byId('cost').textContent = estimate ? cost(estimate, job) : '';
    }
    this.on(this.hertz);
  }
}

/** Keys that no job has, for who writes one as JSON. @param {FieldError[]} errors */
function unknownWords(errors) {
  const keys = errors
    .filter(({ code }) => code === 'unknown_key')
    .map(({ pointer }) => `“${pointer.split('/').at(-1)}”`);
  return keys.length ? `no job has ${keys.join(', ')}` : '';
}

/** Whether a problem is none of the draft. @param {Problem} problem */
const isElsewhere = ({ status, passing }) => passing || status === 401 || status >= 500;

/**
 * Bytes of the fields at a node, in single precision: its place, its displacement, six figures,
 * and its part of the elements.
 */
const NODE = 4 * (2 + 2 + 6) + 16;

/** @param {{equations: number, bytes: number}} estimate @param {import('../types.js').Job} job @returns {string} what it takes to solve it, and to look at it */
function cost({ equations, bytes }, job) {
  const steps = (job.load?.forces ?? job.load?.approaches ?? job.load?.history)?.length ?? 1;
  // The estimate is that of the finest mesh.
  const most = job.mesh?.accuracy ? 'at most ' : '';
  const parts = [`${most}${grouped(equations)} equations, ${megabytes(bytes)}`];
  if (steps > 1) parts.push(`${steps} steps`);
  if (job.output?.fields) parts.push(`fields ${megabytes((steps * equations * NODE) / 2)}`);
  return parts.join(', ');
}

/** Whether the theory has more to say than the curvature. @param {Hertz} hertz */
const isTelling = ({ steps, yield_onset_force: onset }) =>
  onset !== null || steps.some(({ peak_pressure: peak }) => peak > 0);

/** @param {import('../types.js').Job} job @param {Hertz} hertz */
function figures(job, hertz) {
  const units = unitsOf(job);
  const at = hertz.steps.reduce(
    (a, b) => (b.force > (a?.force ?? 0) ? b : a),
    /** @type {Hertz['steps'][0] | undefined} */ (undefined),
  );
  const row = (
    /** @type {string} */ name,
    /** @type {number | null} */ value,
    /** @type {string} */ unit,
  ) =>
    value !== null &&
    h(
      'div',
      {},
      h('dt', {}, name),
      h('dd', {}, figure(value), ' ', h('span', { class: 'unit' }, unit)),
    );
  const onset = hertz.yield_onset_force;
  const verdict =
    at && onset
      ? at.yields
        ? h(
            'p',
            { class: 'verdict yields' },
            `Yields: the force is ${figure(at.force / onset, 3)} times that of first yield.`,
          )
        : h(
            'p',
            { class: 'verdict' },
            `Elastic: ${figure((100 * at.force) / onset, 3)} % of the force of first yield.`,
          )
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
      onset === null &&
        (hasInitialStress(job.upper?.material) || hasInitialStress(job.lower?.material))
        ? h(
            'div',
            {},
            h('dt', {}, 'first yield'),
            h('dd', {}, 'not known beside stress before the load'),
          )
        : onset === null &&
            [job.upper, job.lower].some(
              (body) => body?.material?.plasticity?.reference_stress !== undefined,
            )
          ? h('div', {}, h('dt', {}, 'first yield'), h('dd', {}, 'from the first load on'))
          : row('first yield at', onset, unit(forceOf(job), units)),
      row('effective radius', hertz.effective_radius, unit('length', units)),
    ),
    verdict,
  );
}
