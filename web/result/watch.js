/** Follows one job from the queue to its result, and shows its state. */

import { Problem, ask, post } from '../api/client.js';
import { reconnected } from '../api/connection.js';
import { follow } from '../api/events.js';
import { fetchResult, prepare } from '../api/result.js';
import { button, byId, copy, h, plainButton, toast } from '../lib/dom.js';
import { duration, loaded } from '../lib/units.js';
import { pause, sentence } from '../setup/send.js';
import { inWords } from '../setup/words.js';
import { jobLink } from '../jobs/link.js';
import { tagWords } from '../jobs/names.js';
import { solvedWords } from './loads.js';
import { progressOf } from './progress.js';

/** @typedef {import('../types.js').JobDocument} JobDocument */
/** @typedef {import('../types.js').Iteration} Iteration */
/** @typedef {import('../types.js').Report} Report */

/** Time between two queries of the place in the queue, which no event reports. */
const LOOK = 2000;

/**
 * @typedef {object} Handlers
 * @property {(state: string) => void} titled
 * @property {() => import('../types.js').Job} job that is followed
 * @property {(history: Iteration[]) => void} iterated
 * @property {(id: string, report: Report) => void} solved
 * @property {(document: JobDocument) => void} ended in whatever state
 * @property {(id: string) => void} removed the service no longer has the job
 * @property {() => void} again the job that is shown is to be solved again
 */

export class Watch {
  /** @type {AbortController | undefined} */
  #running;
  /** What the bar on the page is of. */
  #bar = '';
  /** The job that is shown, where it has ended. */
  #shown = '';

  /** @param {Handlers} on */
  constructor(on) {
    this.on = on;
    this.place = byId('watch');
  }

  stop() {
    this.#running?.abort();
    this.#shown = '';
    this.#put('');
  }

  /** Whether a job is followed that has not ended. */
  get isRunning() {
    return this.place.querySelector('[data-status=queued], [data-status=running]') !== null;
  }

  /** Checks whether the service still has the shown job. */
  async look() {
    const id = this.#shown;
    if (!id) return;
    const gone = await ask(`v1/jobs/${id}`).then(() => false, isGone);
    if (gone && this.#shown === id) this.#removed(id, 'Its figures stay here.');
  }

  /** @param {string} id @param {string} meaning what follows of it */
  #removed(id, meaning) {
    this.#shown = '';
    this.on.titled('Removed');
    this.#put(
      'removed',
      h(
        'div',
        { class: 'state failed', role: 'alert', 'data-status': 'removed' },
        h('b', {}, 'Removed'),
        ` The service no longer has this job. ${meaning}`,
      ),
    );
    this.on.removed(id);
  }

  /** An older version has solved the job, whose results have another form. */
  #older() {
    this.on.titled('Older result');
    this.#put(
      'older',
      h(
        'div',
        { class: 'state failed', role: 'alert', 'data-status': 'older' },
        h('b', {}, 'Solved by an older version'),
        ' Its result has another form; the job is in the form.',
        h('span', { class: 'actions' }, button('Solve again', this.on.again)),
      ),
    );
  }

  /** @param {string} bar what it is of @param {...Node} content */
  #put(bar, ...content) {
    this.#bar = bar;
    this.place.replaceChildren(...content);
  }

  /** Shows that the state of a job is not known yet. @param {Problem} problem */
  #wait({ message }) {
    if (!this.#bar) {
      this.on.titled('Waiting');
      this.#put(
        'unknown',
        h(
          'div',
          { class: 'state queued', role: 'status' },
          h('b', {}, 'No answer yet'),
          h('span', { class: 'words' }),
        ),
      );
    }
    this.#say(`${message}; it is asked again`);
  }

  /** Says what is shown while a slider moves. @param {string} words */
  showLive(words) {
    this.#running?.abort();
    this.#shown = '';
    this.on.titled('Live');
    if (this.#bar !== 'live')
      this.#put(
        'live',
        h(
          'div',
          { class: 'state live', 'data-status': 'live' },
          h('b', {}, 'Live'),
          h('span', { class: 'words' }),
        ),
      );
    this.#say(words);
  }

  /** @param {string} id */
  async start(id) {
    this.#running?.abort();
    const { signal } = (this.#running = new AbortController());
    prepare();
    this.#shown = '';
    this.#put('');
    try {
      const last = await this.#follow(id, signal);
      if (signal.aborted || !last) return;
      this.on.ended(last);
      this.#show(last, undefined, true);
      const report = await this.#fetch(id, signal, (received, total) => {
        if (!signal.aborted) this.#say(`loading the result, ${loaded(received, total)}`);
      });
      if (signal.aborted) return;
      if (report) this.on.solved(id, report);
      else if (last.has_result) return this.#older();
      this.#show(last, report);
      this.#shown = id;
    } catch (error) {
      if (signal.aborted) return;
      if (isGone(error)) return this.#removed(id, 'press Solve to solve it again.');
      this.on.titled('No answer');
      this.#put(
        '',
        h(
          'div',
          { class: 'state failed', role: 'alert' },
          h('b', {}, 'No answer'),
          ` ${sentence(/** @type {Error} */ (error).message)}`,
        ),
      );
    }
  }

  /**
   * @param {string} id
   * @param {AbortSignal} signal
   * @param {(received: number, total: number) => void} progress
   * @returns {Promise<Report | undefined>} nothing if there is no result
   */
  async #fetch(id, signal, progress) {
    while (!signal.aborted) {
      try {
        return await fetchResult(id, progress);
      } catch (error) {
        if (!(error instanceof Problem)) throw error;
        if (error.status === 409) return undefined;
        if (!error.passing) throw error;
        this.#say(`${error.message}; it is asked again`);
        await Promise.all([
          reconnected(),
          error.status === 0 ? undefined : pause(error.retryAfter),
        ]);
      }
    }
    return undefined;
  }

  /**
   * @param {string} id
   * @param {AbortSignal} signal
   * @returns {Promise<JobDocument | undefined>} as it ended
   */
  async #follow(id, signal) {
    const history = /** @type {Iteration[]} */ ([]);
    /** @type {JobDocument | undefined} */
    let last;
    let frame = 0;
    const draw = () => {
      frame = 0;
      const isRunning = last?.status === 'running';
      // Of a job that has begun before one looks, its state has the latest of them.
      const latest = isRunning && last?.progress.latest;
      const seen = history.length === 0 && latest ? [latest] : history;
      if (signal.aborted || (seen.length === 0 && !isRunning)) return;
      this.on.iterated(seen);
      if (isRunning) this.#say('');
    };
    const looking = setInterval(async () => {
      if (last?.status !== 'queued' || document.hidden) return;
      const now = await ask(`v1/jobs/${id}`, { signal }).catch(() => undefined);
      if (now?.status === 'queued' && last?.status === 'queued') this.#show(now);
    }, LOOK);
    try {
      await follow(
        `v1/jobs/${id}/events`,
        (event, data) => {
          if (event === 'iteration') history.push(data);
          // A job that is run anew begins at its first iteration; one that is asked to stop goes
          // on.
          if (event === 'state' && data.status === 'running' && !data.cancel_requested)
            history.length = 0;
          if (event === 'state') last = /** @type {JobDocument} */ (data);
          if (event === 'state' && !finished(data)) this.#show(data);
          frame ||= requestAnimationFrame(draw);
          return last !== undefined && finished(last);
        },
        signal,
        async (problem) => {
          // The job goes on without somebody who looks: its state is asked for instead.
          const now = await ask(`v1/jobs/${id}`, { signal }).catch(() => undefined);
          if (signal.aborted) return true;
          if (now) last = /** @type {JobDocument} */ (now);
          if (now && finished(now)) return true;
          if (now) this.#show(now);
          else this.#wait(problem);
          return false;
        },
      );
    } finally {
      clearInterval(looking);
      cancelAnimationFrame(frame);
      draw();
    }
    return last;
  }

  /**
   * @param {JobDocument} document
   * @param {Report} [report]
   * @param {boolean} [loading] whether the result is on its way
   */
  #show(document, report, loading = false) {
    const { id, status } = document;
    const bar = `${id} ${status} ${document.cancel_requested} ${Boolean(report)} ${loading}`;
    // Buttons stay where they are while figures change: a click takes longer than an iteration.
    if (this.#bar !== bar) this.#put(bar, this.#build(document, loading));
    this.on.titled(`${document.title ?? id.slice(-8)}, ${NAMES[status]}`);
    this.#say(loading ? 'loading the result' : words(document, report, this.on.job()));
  }

  /** @param {string} text beside the state */
  #say(text) {
    const place = this.place.querySelector('.words');
    if (place) place.textContent = text;
  }

  /** @param {JobDocument} document @param {boolean} loading */
  #build(document, loading) {
    const { id, status, tags } = document;
    const title = String(this.on.job().title ?? '');
    const word = document.cancel_requested ? 'Stopping…' : 'Cancel';
    const cancel = button(word, () => this.#cancel(id));
    cancel.disabled = document.cancel_requested;
    const take = () => {
      copy(jobLink(String(this.on.job().title ?? '')), 'Link');
      this.look();
    };
    const link = plainButton('Copy link', take);
    return h(
      'div',
      {
        class: `state ${status}`,
        role: finished(document) ? 'status' : null,
        'data-status': loading ? 'loading' : status,
      },
      title ? h('b', { class: 'title' }, title) : null,
      h(title ? 'span' : 'b', {}, NAMES[status]),
      h('span', { class: 'words' }),
      finished(document) ? h('span', { class: 'quiet' }, keptWords(document)) : null,
      tagWords(tags).map((words) => h('span', { class: 'tag' }, words)),
      h(
        'span',
        { class: 'actions' },
        h('code', { class: 'quiet', title: id }, id.slice(-8)),
        finished(document) ? null : cancel,
        link,
      ),
    );
  }

  /** @param {string} id */
  async #cancel(id) {
    await post(`v1/jobs/${id}/cancel`, '').catch((error) => toast(error.message));
  }
}

/** Until when the service keeps a job. @param {JobDocument} document @returns {string} */
export function keptWords({ expires_at: until }) {
  if (!until) return '';
  const date = new Date(until);
  const year = date.getFullYear() === new Date().getFullYear() ? undefined : 'numeric';
  return `kept until ${date.toLocaleDateString('en-GB', { day: 'numeric', month: 'long', year })}`;
}

/** @param {unknown} error */
const isGone = (error) => error instanceof Problem && error.status === 404;

/** @param {JobDocument} document */
export const finished = ({ status }) => status !== 'queued' && status !== 'running';

/** @type {Record<import('../types.js').JobState, string>} */
export const NAMES = {
  queued: 'Waiting',
  running: 'Running',
  succeeded: 'Converged',
  not_converged: 'Not converged',
  failed: 'Failed',
  cancelled: 'Cancelled',
  timed_out: 'Out of time',
};

/**
 * @param {JobDocument} document
 * @param {Report | undefined} report
 * @param {import('../types.js').Job} job
 * @returns {string}
 */
function words(
  {
    status,
    queue_position: position,
    progress,
    error,
    created_at: created,
    started_at: started,
    finished_at: ended,
  },
  report,
  job,
) {
  switch (status) {
    case 'queued':
      return position ? `${position} job${position === 1 ? '' : 's'} ahead` : 'next in line';
    case 'running':
      return progressOf(progress.latest ? [progress.latest] : [], job).words;
    case 'failed':
      return [error?.detail, ...(error?.errors ?? []).map(({ detail }) => detail)]
        .filter(Boolean)
        .map((text) => inWords(String(text)))
        .join('; ');
    case 'succeeded':
      return `${report && report.steps.length > 1 ? `${report.steps.length} steps ` : ''}solved in ${duration(report?.timings_ms.total ?? since(started, ended))}${waited(created, started)}`;
    default:
      return report ? shownOf(report, job) : `after ${iterations(progress.iterations)}, no result`;
  }
}

/**
 * What the figures of a job are that did not come to its end.
 * @param {Report} report
 * @param {import('../types.js').Job} job
 */
function shownOf(report, job) {
  const { steps } = report;
  if (steps.some(({ status }) => status === 'converged') || steps.length > 1)
    return solvedWords(job, report);
  return `after ${iterations(steps.at(-1)?.history.length ?? 0)}; its figures are no answer`;
}

/** @param {number} n */
const iterations = (n) => `${n} iteration${n === 1 ? '' : 's'}`;

/** @param {string | null} from @param {string | null} to */
const since = (from, to) => (from && to ? Date.parse(to) - Date.parse(from) : 0);

/** @param {string} created @param {string | null} started */
const waited = (created, started) =>
  since(created, started) > 500 ? `, waited ${duration(since(created, started))}` : '';
