/** The jobs of the service: state, tags, search, and which of them are laid over the one that is shown. */

import { ask } from '../api/client.js';
import { byId, debounce, h } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import { duration, figure, forceOf, plain, unit, unitsOf } from '../lib/units.js';
import { TARGETS, loadOf, targetOf } from '../setup/fields.js';
import { historyWords } from '../setup/history.js';
import { NAMES, finished } from '../result/watch.js';

/** @typedef {import('../types.js').JobDocument} JobDocument */

const AGAIN = 5000;
const PAGE = 30;

export class JobList {
  /** @type {JobDocument[]} */
  #jobs = [];
  /** @type {string | null} */
  #next = null;
  /** Jobs beyond the first page stay as they were fetched. */
  #pages = 1;
  /** What was asked of each job, which does not change. @type {Map<string, import('../types.js').Job>} */
  #requests = new Map();

  /** @param {{open: (id: string) => void, compare: (id: string, on: boolean) => void, colourOf: (id: string) => string | undefined, isChosen: (id: string) => boolean, current: () => string | undefined}} on */
  constructor(on) {
    this.on = on;
    this.search = h('input', {
      type: 'search',
      placeholder: 'Search tags, ids; name:value',
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
    await this.#fetch().then(
      ({ jobs, next_cursor: next }) => {
        this.#jobs = jobs;
        this.#next = next;
        this.#pages = 1;
        this.show();
        return this.#ask();
      },
      (error) => {
        byId('jobs-state').textContent = error.message;
      },
    );
  }

  async #more() {
    const { jobs, next_cursor: next } = await this.#fetch(this.#next);
    this.#jobs.push(...jobs);
    this.#next = next;
    this.#pages += 1;
    this.show();
    await this.#ask();
  }

  /** Fetches what was asked of jobs that have not been seen. */
  async #ask() {
    const unknown = this.#jobs.filter(({ id }) => !this.#requests.has(id));
    for (const { id } of unknown) {
      const request = await ask(`v1/jobs/${id}/request`).catch(() => undefined);
      if (request) this.#requests.set(id, request);
    }
    if (unknown.length) this.show();
  }

  /** @param {string | null} [cursor] */
  #fetch(cursor) {
    const query = new URLSearchParams({ limit: String(PAGE) });
    if (this.status.value) query.set('status', this.status.value);
    if (this.search.value.includes(':')) query.set('tag', this.search.value.trim());
    if (cursor) query.set('cursor', cursor);
    return ask(`v1/jobs?${query}`);
  }

  show() {
    const wanted = this.search.value.includes(':') ? '' : this.search.value.trim().toLowerCase();
    const jobs = this.#jobs.filter(
      (job) =>
        !wanted ||
        JSON.stringify([job.id, job.tags ?? {}])
          .toLowerCase()
          .includes(wanted),
    );
    byId('jobs-state').textContent = jobs.length ? `${jobs.length} shown` : '';
    const nothing =
      wanted || this.status.value || this.search.value
        ? 'No job matches.'
        : 'No jobs yet. Solve one and it appears here.';
    keepFocus(byId('jobs'), () => {
      byId('jobs-list').replaceChildren(
        ...(jobs.length ? jobs.map((job) => this.#row(job)) : [h('li', { class: 'empty' }, nothing)]),
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
      status === 'succeeded' && progress.latest
        ? `, peak ${figure(progress.latest.peak_pressure, 4)} ${unit('stress', units)}`
        : '';
    return `${loadWords(request)}${peak}`;
  }

  /** @param {JobDocument} job */
  #row(job) {
    const label = labelOf(job);
    const current = this.on.current() === job.id;
    const colour = this.on.colourOf(job.id);
    const box = h('input', {
      type: 'checkbox',
      checked: this.on.isChosen(job.id),
      disabled: current || !finished(job),
      'aria-label': `Compare ${label}`,
      title: 'Lay over the one shown',
      onchange: () => this.on.compare(job.id, box.checked),
    });
    if (colour) box.style.setProperty('accent-color', `var(${colour})`);
    const tags = Object.entries(job.tags ?? {}).map(([name, text]) => h('span', { class: 'tag' }, `${name}: ${text}`));
    const open = h(
      'button',
      { type: 'button', class: 'open', 'aria-current': current ? 'true' : null, onclick: () => this.on.open(job.id) },
      h('span', { class: `dot ${job.status}` }),
      h('span', {}, NAMES[job.status]),
      h('span', { class: 'load' }, this.#words(job)),
      h('time', { datetime: job.created_at, class: 'quiet' }, age(job.created_at)),
      h('code', { class: 'quiet' }, job.id.slice(-8)),
      tags,
    );
    return h('li', { 'data-key': job.id }, box, open);
  }
}

/** @param {{id: string, tags?: Record<string, string>}} job */
export const labelOf = ({ id, tags }) => Object.values(tags ?? {})[0]?.slice(0, 24) ?? id.slice(-8);

/** @param {import('../types.js').Job} job @returns {string} */
function loadWords(job) {
  const kind = loadOf(job.load);
  const value = job.load?.[kind];
  if (kind === 'onset') return 'onset of yield';
  if (kind === 'target') return `P for ${targetWords(job)}`;
  const far = kind.startsWith('approach');
  const name = unit(far ? 'length' : forceOf(job), unitsOf(job));
  const figures =
    kind === 'history'
      ? historyWords(value)
      : Array.isArray(value)
        ? `${plain(value[0])} … ${plain(value[value.length - 1])}`
        : plain(Number(value));
  return `${far ? 'α' : 'P'} ${figures} ${name}`;
}

/** @param {import('../types.js').Job} job */
function targetWords({ load, ...job }) {
  const figure = targetOf(load);
  const { label, quantity } = TARGETS[figure];
  const name = quantity && quantity !== 'load' ? unit(quantity, unitsOf(job)) : '';
  return `${label.toLowerCase()} ${plain(Number(load.target[figure]))} ${name}`.trim();
}

/** @param {string} time */
function age(time) {
  const ms = Date.now() - Date.parse(time);
  return ms < 5000
    ? 'just now'
    : ms < 86400e3
      ? `${duration(1000 * Math.round(ms / 1000)).replace('.00', '')} ago`
      : new Date(time).toLocaleDateString();
}
