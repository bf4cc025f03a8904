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
/** Jobs of a page, and rows that a page begins with at least: a run of many jobs is one row. */
const [PAGE, ROWS] = [100, 30];
const DAY = 86_400_000;
/** Times to look in, in days. */
const TIMES = {
  '': 'any time',
  1: 'last day',
  7: 'last week',
  31: 'last month',
  366: 'last year',
};

export class JobList {
  /** @type {JobDocument[]} */
  #jobs = [];
  /** @type {string | null} */
  #next = null;
  /** Jobs beyond the first page stay as they were fetched. */
  #pages = 1;
  /** Runs whose jobs are seen, each in a row. @type {Set<string>} */
  #opened = new Set();
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
      placeholder: 'Search titles, materials, tags, ids; name:value',
      'aria-label': 'Search jobs',
    });
    this.status = h(
      'select',
      { 'aria-label': 'State' },
      h('option', { value: '' }, 'all states'),
      Object.entries(NAMES).map(([value, name]) => h('option', { value }, name)),
    );
    const times = Object.entries(TIMES).sort(([a], [b]) => Number(a) - Number(b));
    this.since = h(
      'select',
      { 'aria-label': 'Time' },
      times.map(([value, name]) => h('option', { value }, name)),
    );
    byId('jobs-filter').append(this.search, this.status, this.since);
    const again = () => {
      this.#pages = 1;
      this.refresh();
    };
    this.search.addEventListener('input', debounce(again, 250));
    this.status.addEventListener('change', again);
    this.since.addEventListener('change', again);
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
      this.on.refreshed();
    });
  }

  async #more() {
    await this.#fill(async () => {
      const { jobs, next_cursor: next } = await this.#fetch(this.#next);
      this.#jobs.push(...jobs);
      this.#next = next;
      this.#pages += 1;
    });
  }

  /** Shows the fetched jobs, or why there are none. @param {() => Promise<void>} fetched */
  async #fill(fetched) {
    try {
      const asked = this.#query();
      await fetched();
      while (this.#next && this.#rows().length < Math.min(ROWS, this.#jobs.length)) {
        const { jobs, next_cursor: next } = await this.#fetch(this.#next);
        if (this.#query() !== asked) return;
        this.#jobs.push(...jobs);
        this.#next = next;
      }
      this.show();
      await this.#ask();
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      byId('jobs-state').textContent = `Could not list the jobs: ${error.message}.`;
    }
  }

  /** Jobs of a run that stand below each other are one row, until it is opened. @returns {JobDocument[][]} */
  #rows() {
    const rows = /** @type {JobDocument[][]} */ ([]);
    for (const job of this.#jobs) {
      const run = job.tags?.run;
      const last = rows.at(-1);
      if (run && !this.#opened.has(run) && last?.[0].tags?.run === run) last.push(job);
      else rows.push([job]);
    }
    return rows;
  }

  /** Fetches what was asked of jobs that have not been seen. */
  async #ask() {
    const unknown = this.#rows().flatMap(([job]) => (this.#requests.has(job.id) ? [] : [job]));
    for (const { id } of unknown) {
      const request = await ask(`v1/jobs/${id}/request`).catch(() => undefined);
      if (request) this.#requests.set(id, request);
    }
    if (unknown.length) this.show();
  }

  /** What is looked for. */
  #query() {
    const query = new URLSearchParams();
    if (this.status.value) query.set('status', this.status.value);
    const text = this.search.value.trim();
    if (isTag(text)) query.set('tag', text);
    else if (ID.test(text)) query.set('id', text);
    else if (text) query.set('search', text);
    if (this.since.value)
      query.set('since', new Date(Math.floor(Date.now() / DAY - Number(this.since.value)) * DAY).toISOString()); // prettier-ignore
    return query.toString();
  }

  /** @param {string | null} [cursor] */
  #fetch(cursor) {
    const query = new URLSearchParams(`limit=${PAGE}&${this.#query()}`);
    if (cursor) query.set('cursor', cursor);
    return ask(`v1/jobs?${query}`);
  }

  show() {
    const rows = this.#rows();
    byId('jobs-state').textContent = rows.length ? `${this.#jobs.length} shown` : '';
    const nothing = this.#query()
      ? 'No job matches. Whole words are looked for.'
      : 'No jobs yet. Solve one and it appears here.';
    keepFocus(byId('jobs'), () => {
      byId('jobs-list').replaceChildren(
        ...(rows.length
          ? rows.map((jobs) => (jobs.length > 1 ? this.#run(jobs) : this.#row(jobs[0])))
          : [h('li', { class: 'empty' }, nothing)]),
      );
      byId('jobs-more').hidden = !this.#next;
    });
  }

  /** A run of several jobs, which opens. @param {JobDocument[]} jobs */
  #run(jobs) {
    const [job] = jobs;
    const request = this.#requests.get(job.id);
    const varied = jobs.flatMap(({ tags }) => (tags?.varied ? [tags.varied] : [])).reverse();
    const states = [...new Set(jobs.map(({ status }) => NAMES[status].toLowerCase()))];
    const open = () => {
      this.#opened.add(job.tags?.run ?? '');
      this.show();
      this.#ask();
    };
    return h(
      'li',
      { 'data-key': job.tags?.run },
      h(
        'button',
        { type: 'button', class: 'open', 'aria-expanded': 'false', onclick: open },
        h('span', { class: `dot ${job.status}` }),
        h('b', { class: 'title' }, `${jobs.length} jobs: ${varied.length ? `${varied[0]} … ${varied.at(-1)}` : states.join(', ')}`), // prettier-ignore
        request && h('span', {}, titleOf(request)),
        h('span', {}, states.join(', ')),
        h('time', { datetime: job.created_at, class: 'quiet' }, age(job.created_at)),
      ),
    );
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
    const label = titleOf({ ...request, tags: job.tags }) || job.id.slice(-8);
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
    const tags = Object.entries(job.tags ?? {}).flatMap(([name, text]) =>
      name === 'run' ? [] : [h('span', { class: 'tag' }, `${name}: ${text}`)],
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
      request && h('b', { class: 'title' }, titleOf({ ...request, tags: undefined })),
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

/** An id as the address of a job has it. */
const ID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/i;

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
