/**
 * The jobs of the service: state, tags, search, and which of them are laid over the one that is
 * shown.
 */

import { Problem, ask, post, request } from '../api/client.js';
import { dialogue } from '../lib/dialogue.js';
import { byId, debounce, h, plainButton, toast } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import { duration, figure, unit, unitsOf } from '../lib/units.js';
import { NAMES, finished, keptWords } from '../result/watch.js';
import { labelOf, tagWords } from './names.js';

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
    } catch (error) {
      if (!(error instanceof Problem)) throw error;
      byId('jobs-state').textContent = `Could not list the jobs: ${error.message}.`;
    }
  }

  /** Jobs of a run that stand below each other are one row, which opens. @returns {JobDocument[][]} */
  #rows() {
    const rows = /** @type {JobDocument[][]} */ ([]);
    for (const job of this.#jobs) {
      const run = job.tags?.run;
      const last = rows.at(-1);
      if (run && last?.[0].tags?.run === run) last.push(job);
      else rows.push([job]);
    }
    return rows;
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
          ? rows.flatMap((jobs) => (jobs.length > 1 ? this.#run(jobs) : this.#row(jobs[0])))
          : [h('li', { class: 'empty' }, nothing)]),
      );
      byId('jobs-more').hidden = !this.#next;
    });
  }

  /** A run of several jobs, and each of them where it is open. @param {JobDocument[]} jobs */
  #run(jobs) {
    const [job] = jobs;
    const run = job.tags?.run ?? '';
    const isOpen = this.#opened.has(run);
    const varied = jobs.flatMap(({ tags }) => (tags?.varied ? [tags.varied] : []));
    const states = [...new Set(jobs.map(({ status }) => NAMES[status].toLowerCase()))];
    const turn = () => {
      if (!this.#opened.delete(run)) this.#opened.add(run);
      this.show();
    };
    const row = h(
      'li',
      { 'data-key': run },
      h(
        'button',
        { type: 'button', class: 'open', 'aria-expanded': String(isOpen), onclick: turn },
        h('span', { class: `dot ${job.status}` }),
        h(
          'b',
          { class: 'title' },
          `${jobs.length} jobs: ${varied.length ? spanOf(varied) : job.title}`,
        ),
        h('span', {}, states.join(', ')),
        h('time', { datetime: job.created_at, class: 'quiet' }, age(job.created_at)),
      ),
    );
    return isOpen ? [row, ...jobs.map((one) => this.#row(one))] : [row];
  }

  /** @param {JobDocument} job */
  #row(job) {
    const { title, description } = job;
    const label = labelOf(job);
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
    const open = h(
      'button',
      {
        type: 'button',
        class: 'open',
        'aria-current': current ? 'true' : null,
        onclick: () => this.on.open(job.id),
      },
      h('span', { class: `dot ${job.status}` }),
      h('b', { class: 'title' }, title),
      h('span', {}, NAMES[job.status]),
      h('span', { class: 'peak' }, peakOf(job)),
      h(
        'time',
        { datetime: job.created_at, class: 'quiet', title: keptWords(job) },
        age(job.created_at),
      ),
      h('code', { class: 'quiet' }, job.id.slice(-8)),
      title !== description && h('span', { class: 'quiet bodies' }, description),
      tagWords(job.tags).map((words) => h('span', { class: 'tag' }, words)),
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

/** The first and the last value of a run, without the words that both have: `Radius 10 … 40 mm`. @param {string[]} varied the newest first */
function spanOf(varied) {
  const [last, first] = [varied[0], varied.at(-1) ?? ''].map((words) => words.split(' '));
  const other = last.findIndex((word, k) => word !== first[k]);
  return other < 0 ? first.join(' ') : `${first.join(' ')} … ${last.slice(other).join(' ')}`;
}

/** Peak pressure of the last load. @param {JobDocument} job */
function peakOf({ progress, status, units }) {
  const peak = status === 'succeeded' && progress.latest?.peak_pressure;
  return peak ? `peak ${figure(peak, 4)} ${unit('stress', unitsOf({ units }))}` : '';
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
