/** Puts the page together. */

import { Problem, ask, post } from './api/client.js';
import { fetchResult } from './api/result.js';
import { byId, copy, h, toast } from './lib/dom.js';
import { same } from './lib/pointer.js';
import { startTheme } from './lib/theme.js';
import { startKeys, startParts } from './shell.js';
import { Check } from './setup/check.js';
import { Draft } from './setup/draft.js';
import { Form } from './setup/form.js';
import { startJson } from './setup/json.js';
import { startSketch } from './setup/sketch.js';
import { JobList, labelOf } from './jobs/list.js';
import * as link from './jobs/link.js';
import { View } from './result/view.js';
import { Watch } from './result/watch.js';

/** @typedef {import('./types.js').Shown} Shown */

/** Curves of compared jobs; the one shown has the first. */
const COLOURS = ['--curve-1', '--curve-2', '--curve-3', '--curve-4', '--curve-5', '--curve-6'];
const KEPT = 'draft';

startTheme();
const draft = new Draft();
const form = new Form(draft);
startJson(draft);
const sketch = startSketch(draft);
const view = new View(() => {
  draft.set('/output/fields', true, 'page');
  solve();
});
const check = new Check(draft, form, (hertz) => {
  sketch(hertz);
  if (!current) view.preview(hertz, draft.job);
});
const compared = /** @type {Map<string, Shown>} */ (new Map());
/** @type {{id: string, job: import('./types.js').Job} | undefined} */
let current;
/** @type {Shown | undefined} */
let first;

const watch = new Watch({
  iterated: (history) => {
    if (current) view.iterate(history, current.job);
  },
  solved: (id, report) => {
    first = { id, report, job: current?.job ?? {}, colour: COLOURS[0], label: labelOf({ id, tags: report.tags }) };
    show();
    if (innerWidth < 900) byId('result').scrollIntoView({ behavior: 'smooth' });
  },
  ended: (document) => {
    list.refresh();
    const errors = document.error?.errors ?? [];
    if (errors.length) form.complain(errors);
    if (!first) nothing(document.status === 'cancelled' ? 'The job was stopped before its first iteration.' : '');
  },
});

const list = new JobList({
  open: (id) => {
    location.hash = `job=${id}`;
  },
  compare,
  isCompared: (id) => compared.get(id)?.colour,
  current: () => current?.id,
});

function show() {
  if (first) view.show([first, ...[...compared.values()].filter(({ id }) => id !== first?.id)]);
}

/** @param {string} text */
function nothing(text) {
  view.clear(h('div', { class: 'empty' }, h('p', {}, text)));
}

async function solve() {
  const button = /** @type {HTMLButtonElement} */ (byId('solve'));
  button.disabled = true;
  try {
    const job = structuredClone(draft.job);
    const { id } = await post('v1/jobs', job);
    current = { id, job };
    history.pushState(null, '', `#job=${id}`);
    follow(id);
  } catch (error) {
    if (!(error instanceof Problem)) throw error;
    check.refuse(error);
    form.focusFault();
    if (error.status === 429) toast('The queue is full. Try again in a moment.');
  } finally {
    button.disabled = false;
  }
}

/** Says so where the form no longer shows the job whose result is seen. */
function compareWithDraft() {
  byId('stale').hidden = !current || same(draft.job, current.job);
}

/** @param {string} id */
function follow(id) {
  first = undefined;
  nothing('');
  list.refresh();
  watch.start(id);
  compareWithDraft();
}

/** Shows a job that somebody made. @param {string} id */
async function open(id) {
  if (current?.id === id) return;
  try {
    const job = await ask(`v1/jobs/${id}/request`);
    current = { id, job };
    draft.replace(job, 'link');
    follow(id);
  } catch (error) {
    nothing(
      error instanceof Problem && error.status === 404
        ? 'This link leads to a job that is not here: removed after its time, or made on another service.'
        : String(/** @type {Error} */ (error).message),
    );
  }
}

/** @param {string} id @param {boolean} on @param {string} label */
async function compare(id, on, label) {
  if (!on) compared.delete(id);
  else {
    const used = new Set([...compared.values()].map(({ colour }) => colour));
    const colour = COLOURS.slice(1).find((one) => !used.has(one));
    if (!colour) {
      toast(`${COLOURS.length} jobs are as many as can be told apart`);
    } else {
      try {
        const [report, job] = await Promise.all([fetchResult(id), ask(`v1/jobs/${id}/request`)]);
        if (first && report.units !== first.report.units)
          toast('The jobs differ in units; figures are laid over each other as they are.');
        compared.set(id, { id, report, job, label, colour });
      } catch (error) {
        toast(/** @type {Error} */ (error).message);
      }
    }
  }
  show();
  list.show();
}

/** Does what the address says. */
async function obey() {
  const { job, draft: packed } = link.read();
  if (job) return open(job);
  if (packed) {
    const definition = await link.unpack(packed).catch(() => undefined);
    if (definition) return draft.replace(definition, 'link');
    toast('The link is damaged');
  }
}

/** @param {import('./types.js').Job} job with the stress field, which is what one comes here to see */
const withFields = (job) => ({ ...job, output: { ...job.output, fields: true } });

async function begin() {
  const { examples } = await ask('v1/examples').catch(() => ({ examples: [] }));
  const choice = /** @type {HTMLSelectElement} */ (byId('example'));
  choice.append(
    ...examples.map((/** @type {{name: string}} */ { name }) =>
      h('option', { value: name }, name.replaceAll('_', ' ')),
    ),
  );
  choice.addEventListener('change', () => {
    const example = examples.find((/** @type {{name: string}} */ { name }) => name === choice.value);
    if (example) draft.replace(withFields(example.job), 'example');
  });
  const kept = sessionStorage.getItem(KEPT);
  if (kept) draft.replace(JSON.parse(kept), 'kept');
  else if (examples.length)
    draft.replace(
      withFields(
        (examples.find((/** @type {{name: string}} */ { name }) => name === 'two_cylinders') ?? examples[0]).job,
      ),
      'example',
    );
  nothing('Set up a contact and solve it. Until then: what Hertz’s theory says of elastic bodies.');
  draft.addEventListener('change', () => sessionStorage.setItem(KEPT, JSON.stringify(draft.job)));
  await obey();
  addEventListener('hashchange', obey);
}

byId('form').addEventListener('submit', (event) => {
  event.preventDefault();
  solve();
});
addEventListener('keydown', (event) => {
  if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
    event.preventDefault();
    solve();
  }
});
draft.addEventListener('change', compareWithDraft);
byId('restore').addEventListener('click', () => {
  if (current) draft.replace(current.job, 'job');
});
byId('share-job').addEventListener('click', async () =>
  copy(await link.draftLink(draft.job), 'Link to this definition'),
);
document.querySelector('[data-skip]')?.addEventListener('click', (event) => {
  event.preventDefault();
  byId('result').focus();
});

startParts(() => list.refresh());
startKeys();
begin();
