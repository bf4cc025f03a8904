/**
 * The jobs of the service: state, tags, search, and which of them are laid over the one that is
 * shown.
 */

import { Problem, ask, post, request } from '../api/client.js';
import { dialogue } from '../lib/dialogue.js';
import { byId, debounce, h, plainButton, toast } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import { duration, figure, unit, unitsOf } from '../lib/units.js';
import { asked } from '../result/loads.js';
import { NAMES, finished, keptWords } from '../result/watch.js';
import { loadWords } from './load.js';
import { materialNames, pairOf, titleOf } from './names.js';

/** @typedef {import('../types.js').JobDocument} JobDocument */

const AGAIN = 5000;
const PAGE = 30;
/** Jobs that one search fetches, in pages of a hundred. */
const [THROUGH, WIDE] = [1000, 100];

export class JobList {
  /** @type {JobDocument[]} */
  #jobs = [];
  /** @type {string | null} */
  #next = null;
  /** Jobs beyond the first page stay as they were fetched. */
  #pages = 1;
  /** Most jobs that a search fetches. */
  #through = THROUGH;
  /**
   * The request of each job, which does not change.
   * @type {Map<string, import('../types.js').Job>}
   */
  #requests = new Map();

  /**
   * @param {{open: (id: string) => void, compare: (id: string, on: boolean) => void, colourOf:
   *   (id: string) => string | undefined, isChosen: (id: string) => boolean, current: () => string
   *   | undefined, deleted: (id: string) => void, refreshed: () => void}} on
   */
  constructor(on) {
    this.on = on;
    this.search = h('input', {
      type: 'search',
      placeholder: 'Search titles, tags, ids; name:value',
      'aria-label': 'Search jobs',
    });
    this.status = h(
      'select',
      { 'aria-label': 'State' },
      h('option', { value: '' }, 'all states'),
      Object.entries(NAMES).map(([value, name]) => h('option', { value }, name)),
    );
    byId('jobs-filter').append(this.search, this.status);
    const again = () => {
      this.#pages = 1;
      this.refresh();
    };
    this.search.addEventListener('input', debounce(again, 250));
    this.status.addEventListener('change', again);
    byId('jobs-more').addEventListener('click', () => this.#more());
    setInterval(() => {
      if (!byId('jobs').hidden && !document.hidden && this.#pages === 1) this.refresh();
    }, AGAIN);
  }

  async refresh() {
    if (byId('jobs').hidden) return;
    await this.#fill(async () => {
      const { jobs, next_cursor: next } = await this.#fetch();
      this.#jobs = jobs;
      this.#next = next;
      this.#pages = 1;
      this.#through = THROUGH;
      this.on.refreshed();
    });
  }

  async #more() {
    await this.#fill(async () => {
      const { jobs, next_cursor: next } = await this.#fetch(this.#next);
      this.#jobs.push(...jobs);
      this.#next = next;
      this.#pages += 1;
      this.#through = this.#jobs.length + THROUGH;
    });
  }

  /** Shows the fetched jobs, or why there are none. @param {() => Promise<void>} fetched */
  async #fill(fetched) {
    try {
      await fetched();
      this.show();
      await this.#lookThrough();
      await this.#ask();
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      byId('jobs-state').textContent = `Could not list the jobs: ${error.message}.`;
    }
  }

  /**
   * Fetches older jobs until some match the word that is looked for, or many have been looked
   * through.
   */
  async #lookThrough() {
    const wanted = this.search.value;
    while (
      this.#word &&
      this.#next &&
      this.#jobs.length < this.#through &&
      this.#matching().length < PAGE
    ) {
      const { jobs, next_cursor: next } = await this.#fetch(this.#next, WIDE);
      if (this.search.value !== wanted) return;
      this.#jobs.push(...jobs);
      this.#next = next;
      this.show();
    }
  }

  /**
   * What is looked for in ids and tags here; a tag with its value is looked for by the service.
   */
  get #word() {
    const text = this.search.value.trim();
    return isTag(text) ? '' : text.replace(/:$/, '').toLowerCase();
  }

  /** What the row of a job says of its set-up. @param {string} id */
  #said(id) {
    const request = this.#requests.get(id);
    return request ? [request.title ?? '', pairOf(request), materialNames(request)] : [];
  }

  #matching() {
    const word = this.#word;
    return this.#jobs.filter(
      ({ id, tags }) =>
        !word ||
        JSON.stringify([id, tags ?? {}, this.#said(id)])
          .toLowerCase()
          .includes(word),
    );
  }

  /** Fetches what was asked of jobs that have not been seen. */
  async #ask() {
    const unknown = this.#matching().filter(({ id }) => !this.#requests.has(id));
    for (const { id } of unknown) {
      const request = await ask(`v1/jobs/${id}/request`).catch(() => undefined);
      if (request) this.#requests.set(id, request);
    }
    if (unknown.length) this.show();
  }

  /** @param {string | null} [cursor] @param {number} [limit] */
  #fetch(cursor, limit = PAGE) {
    const query = new URLSearchParams({ limit: String(limit) });
    if (this.status.value) query.set('status', this.status.value);
    const text = this.search.value.trim();
    if (isTag(text)) query.set('tag', text);
    if (cursor) query.set('cursor', cursor);
    return ask(`v1/jobs?${query}`);
  }

  show() {
    const jobs = this.#matching();
    const among = this.#next ? ` among the ${this.#jobs.length} newest` : '';
    byId('jobs-state').textContent = jobs.length
      ? `${jobs.length} shown${this.#word ? among : ''}`
      : '';
    const nothing =
      this.status.value || this.search.value
        ? this.#word && this.#next
          ? `No job matches${among}.`
          : 'No job matches.'
        : 'No jobs yet. Solve one and it appears here.';
    keepFocus(byId('jobs'), () => {
      byId('jobs-list').replaceChildren(
        ...(jobs.length
          ? jobs.map((job) => this.#row(job))
          : [h('li', { class: 'empty' }, nothing)]),
      );
      byId('jobs-more').hidden = !this.#next;
    });
  }

  /** Load and peak pressure. @param {JobDocument} job */
  #words({ id, progress, status }) {
    const request = this.#requests.get(id);
    if (!request) return '';
    const units = unitsOf(request);
    const peak =
      status === 'succeeded' && progress.latest && progress.latest.peak_pressure > 0
        ? `, ${asked(request) > 1 ? 'last peak' : 'peak'} ${figure(progress.latest.peak_pressure, 4)} ${unit('stress', units)}`
        : '';
    return `${loadWords(request)}${peak}`;
  }

  /** @param {JobDocument} job */
  #row(job) {
    const request = this.#requests.get(job.id);
    const title = titleOf({ tags: job.tags, ...request });
    const label = title || job.id.slice(-8);
    const current = this.on.current() === job.id;
    const colour = this.on.colourOf(job.id);
    const box = h('input', {
      type: 'checkbox',
      checked: current || this.on.isChosen(job.id),
      disabled: current || !finished(job),
      'aria-label': `Compare ${label}`,
      title: current ? 'This one is shown' : 'Lay over the one shown',
      onchange: () => this.on.compare(job.id, box.checked),
    });
    if (colour) box.style.setProperty('accent-color', `var(${colour})`);
    const tags = Object.entries(job.tags ?? {}).map(([name, text]) =>
      h('span', { class: 'tag' }, `${name}: ${text}`),
    );
    const open = h(
      'button',
      {
        type: 'button',
        class: 'open',
        'aria-current': current ? 'true' : null,
        onclick: () => this.on.open(job.id),
      },
      h('span', { class: `dot ${job.status}` }),
      request?.title ? h('b', { class: 'title' }, title) : null,
      h('span', {}, NAMES[job.status]),
      h('span', { class: 'load' }, this.#words(job)),
      h(
        'time',
        { datetime: job.created_at, class: 'quiet', title: keptWords(job) },
        age(job.created_at),
      ),
      h('code', { class: 'quiet' }, job.id.slice(-8)),
      request &&
        h('span', { class: 'quiet bodies' }, `${pairOf(request)}, ${materialNames(request)}`),
      tags,
    );
    return h(
      'li',
      { 'data-key': job.id },
      open,
      h('label', { class: 'compare' }, box, 'Compare'),
      this.#ending(job, label),
    );
  }

  /** Cancels a job; removes a finished one. @param {JobDocument} job @param {string} label */
  #ending(job, label) {
    const [word, work] = finished(job)
      ? [`Delete ${label}`, () => this.#askToDelete(job, label)]
      : [
          `Cancel ${label}`,
          () => this.#do(() => post(`v1/jobs/${job.id}/cancel`, ''), `${label} is asked to stop`),
        ];
    const stopping = job.cancel_requested && !finished(job);
    return plainButton('×', stopping ? () => {} : work, {
      title: stopping ? 'Stopping…' : word,
      'aria-label': word,
      'aria-disabled': stopping ? 'true' : null,
    });
  }

  /** @param {JobDocument} job @param {string} label */
  #askToDelete({ id }, label) {
    const words = `“${label}” and its result are removed from the service, for everyone. Links to it no longer work.`;
    dialogue('Delete a job', [h('p', {}, words)], 'Delete', () => {
      this.#do(async () => {
        await request(`v1/jobs/${id}`, { method: 'DELETE' }, () => {});
        this.on.deleted(id);
      }, `${label} is deleted`);
      return '';
    });
  }

  /** @param {() => Promise<unknown>} work @param {string} done what it came to */
  async #do(work, done) {
    try {
      await work();
      toast(done);
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      toast(error.message);
    }
    await this.refresh();
  }
}

/** A tag with its value. @param {string} text */
const isTag = (text) => /^[^:]+:./.test(text);

/** @param {string} time */
function age(time) {
  const ms = Date.now() - Date.parse(time);
  return ms < 5000
    ? 'just now'
    : ms < 86400e3
      ? `${duration(1000 * Math.round(ms / 1000)).replace('.00', '')} ago`
      : new Date(time).toLocaleDateString();
}
