/** Puts the page together. */

import { Address } from './address.js';
import { Problem, ask, faultsOf } from './api/client.js';
import { onReconnect } from './api/connection.js';
import { fetchResult } from './api/result.js';
import { byId, copy, h, toast } from './lib/dom.js';
import { keepFocus } from './lib/focus.js';
import { isObject, kept, tab } from './lib/kept.js';
import { same } from './lib/pointer.js';
import { duration, forceOf } from './lib/units.js';
import { startTheme } from './lib/theme.js';
import { showPart, showTitle, startKeys, startMemory, startMenus, startParts } from './shell.js';
import { Check } from './setup/check.js';
import { Doors } from './setup/doors.js';
import { Draft } from './setup/draft.js';
import { DEFAULTS } from './setup/fields.js';
import { examplesOf } from './setup/examples.js';
import { Form } from './setup/form.js';
import { startJson } from './setup/json.js';
import { allMaterials } from './setup/library.js';
import { Live } from './setup/live.js';
import { Sending, refusalWords, send, sentence, waitingWords } from './setup/send.js';
import { startSketch } from './setup/sketch.js';
import { LayerSource } from './field/layers.js';
import { FieldSource } from './field/source.js';
import { JobList } from './jobs/list.js';
import { names } from './jobs/names.js';
import * as link from './jobs/link.js';
import { Store } from './state.js';
import { View } from './result/view.js';
import { Watch } from './result/watch.js';

/** @typedef {import('./shown.js').Shown} Shown */

/** Curves of compared jobs; the one shown has the first. */
const COLOURS = ['--curve-1', '--curve-2', '--curve-3', '--curve-4', '--curve-5', '--curve-6'];
/** Their dashes, for eyes and paper that do not tell colours apart. */
const DASHES = [undefined, [8, 3], [2, 3], [8, 3, 2, 3], [14, 4], [5, 2, 2, 2, 2, 2]];
/** What this tab keeps of the draft: the job, and the address at which it was changed last. */
const [KEPT, KEPT_AT] = ['draft', 'draft-at'];
/** Whether the user prefers reduced motion. */
const isStill = matchMedia('(prefers-reduced-motion: reduce)');

/**
 * Where the fields of a job come from.
 * @param {string} id
 * @param {import('./types.js').Report} report
 * @param {import('./types.js').Job} job
 * @returns {FieldSource | LayerSource | undefined} nothing where it did not ask for them, or the report has them
 */
function sourceOf(id, report, job) {
  // A track has no mesh.
  const inside = report.steps.some(({ fields, layers, passes }) => fields ?? layers ?? passes);
  if (!job.output?.fields || inside) return undefined;
  return report.analysis === 'three_dimensional'
    ? new LayerSource(id, report)
    : new FieldSource(id, report);
}

startMemory();
startTheme();
const store = new Store();
const address = new Address();
const sending = new Sending();
/** Example jobs. */
const examples = ask('v1/examples')
  .catch(() => ({ examples: [] }))
  .then(({ examples }) => examplesOf(examples));
const draft = new Draft();
draft.known = (/** @type {unknown} */ name) => allMaterials().some((one) => one.name === name);
const doors = new Doors(draft, examples, () => {
  showPart('jobs');
  list.refresh();
});
const form = new Form(draft, (moving) => live.ask(draft.job, moving));
const json = startJson(draft);
const sketch = startSketch(draft);
/** The job that is shown, whatever the form has come to since. */
const takeShown = () => {
  const { current } = store.state;
  if (current && !same(current.job, draft.job)) draft.replace(current.job, 'job');
};
/** Ids of the job that was shown before the last one, and of that. */
let [before, last] = ['', ''];
const view = new View({
  fieldsWanted: () => {
    takeShown();
    draft.set('/output/fields', true, 'page');
    solve();
  },
  spread: (ids) => {
    const { current } = store.state;
    if (current?.id) location.hash = link.jobFragment(current.id, ids);
  },
  open: openBeside,
  before: () => (before && before !== store.state.current?.id && !isChosen(before) ? before : ''),
  compare: (id) => compare(id, true),
  use: (job) => draft.replace(job, 'page'),
  solve: (job) => {
    draft.replace(job, 'page');
    solve();
  },
  listed: () => list.refresh(),
});
const check = new Check(draft, form, json, (hertz) => {
  sketch(hertz);
  if (!store.state.current) view.preview(hertz, draft.job);
});
const watch = new Watch({
  titled: showTitle,
  job: () => store.state.current?.job ?? {},
  iterated: (history) => {
    const { current } = store.state;
    if (current) view.iterate(history, current.job);
  },
  solved: (id, report) => {
    [before, last] = id === last ? [before, last] : [last, id];
    const job = store.state.current?.job ?? {};
    const fields = sourceOf(id, report, job);
    store.take({
      type: 'solved',
      shown: { id, report, job, fields, colour: COLOURS[0], label: '' },
    });
    form.showTimes({ job, report });
    show();
    if (innerWidth < 900)
      byId('result').scrollIntoView({ behavior: isStill.matches ? 'auto' : 'smooth' });
  },
  ended: (document) => {
    list.refresh();
    const errors = faultsOf(document.error ?? {});
    if (errors.length) form.showError(errors);
    if (!store.state.first)
      nothing(
        document.status === 'cancelled' ? 'The job was stopped before its first iteration.' : '',
      );
  },
  removed: (id) => {
    list.refresh();
    if (store.state.first?.id !== id) return;
    store.take({ type: 'removed', id });
    show();
    view.refreshReport();
  },
  again: () => {
    takeShown();
    solve();
  },
});

/** Answers that are shown while a slider moves. */
const live = new Live({
  begun: (job) => {
    if (store.state.current?.id !== '') return;
    const elements =
      job.mesh?.elements_per_half_width ?? DEFAULTS['/mesh/elements_per_half_width'];
    watch.showLive(`the figures are those while it moved; solving on ${elements} elements…`);
  },
  solved: ({ job, solved }, report) => {
    if (address.isLeft) return;
    if (watch.isRunning)
      toast('The job before goes on: Back shows it, and so does the list of jobs');
    // What a slider shows has no address.
    if (location.hash) address.name('pushState', location.pathname);
    store.take({ type: 'opened', id: '', job });
    store.take({
      type: 'solved',
      shown: { id: '', report, job: solved, colour: COLOURS[0], label: '' },
    });
    form.showTimes({ job: solved, report });
    const { total } = report.timings_ms;
    const elements = solved.mesh?.elements_per_half_width;
    const coarse =
      elements !== job.mesh?.elements_per_half_width
        ? `, on ${elements} elements while it moves`
        : '';
    watch.showLive(
      `solved in ${duration(total)}${coarse}; press Solve to keep it as a job with a link`,
    );
    compareWithDraft();
    show(true);
  },
  failed: ({ status, message }) => {
    if (store.state.current?.id === '')
      watch.showLive('where the slider was left is not solved; the figures are those before');
    if (status !== 422) refuse(`${sentence(message)} Move the slider again, or press Solve.`);
  },
});

const list = new JobList({
  open: openBeside,
  compare,
  colourOf: (id) => store.state.compared.get(id)?.colour,
  isChosen: (id) => isChosen(id),
  current: () => store.state.current?.id,
  deleted: (id) => {
    if (isChosen(id)) compare(id, false);
  },
  // Another user may have deleted the shown job.
  refreshed: () => watch.look(),
});

/**
 * Leaves out of the comparison what has another kind of force: whole in axisymmetry, for each
 * length otherwise.
 */
function leaveUnlike() {
  const { first, compared } = store.state;
  const unlike = [...compared.values()].filter(
    ({ job }) => first && forceOf(job) !== forceOf(first.job),
  );
  store.take({ type: 'dropped', ids: unlike.map(({ id }) => id) });
  if (unlike.length > 0)
    toast(
      'An axisymmetric job and a plane one are not compared: the force of one is whole, that of the other per length',
    );
}

/** @param {boolean} [moving] whether a slider moves */
function show(moving = false) {
  const { first } = store.state;
  if (!first) return;
  leaveUnlike();
  const beside = [...store.state.compared.values()].filter(({ id }) => id !== first.id);
  const shown = [first, ...beside];
  const labels = names(shown);
  view.show(
    shown.map((one, k) => ({ ...one, label: labels[k] })),
    moving,
  );
}

/** @param {string} text */
function nothing(text) {
  view.clear(h('div', { class: 'empty' }, h('p', {}, text)));
}

/** What the page is for, where no job is shown. @param {string} text that goes before */
function welcome(text) {
  view.clear(h('div', {}, text ? h('p', { class: 'empty' }, text) : null, doors.element));
}

/** Shows beside the button why nothing is solved. @param {string} words */
function refuse(words) {
  byId('solve-state').textContent = words;
}

/** Another set-up than the one that is being sent may be solved. */
const showSending = () =>
  byId('solve').setAttribute('aria-disabled', String(sending.isOf(draft.job)));

async function solve() {
  const damaged = json.read();
  if (damaged) {
    showPart('json');
    json.focusFault();
    return refuse(`The JSON beside is not a job: ${damaged}`);
  }
  draft.settle();
  const job = structuredClone(draft.job);
  // A key that is held down, or a second click, makes no second job; another set-up goes before
  // the one that waits.
  if (sending.isOf(job)) return;
  const [mine, visit] = [sending.begin(job), address.signal];
  showSending();
  try {
    const { id } = await send(job, mine, (problem) => {
      if (!mine.aborted) refuse(waitingWords(problem));
    });
    if (mine.aborted) return;
    refuse('');
    if (visit.aborted || address.isLeft) {
      toast('The job is made: the list of jobs has it');
      return list.refresh();
    }
    live.stop();
    store.take({ type: 'opened', id, job });
    address.name('pushState', link.jobFragment(id, [...store.state.compared.keys()]));
    address.follow();
    keep();
    follow(id);
  } catch (error) {
    if (mine.aborted) return;
    if (!(error instanceof Problem)) throw error;
    if (error.status === 422 || error.status === 400) check.refuse(error, job);
    form.focusFault();
    refuse(refusalWords(error, form.faults));
  } finally {
    sending.end(mine);
    showSending();
  }
}

/** Marks a result whose job the form no longer shows. */
function compareWithDraft() {
  const { current } = store.state;
  byId('stale').hidden = !current || same(draft.job, current.job);
}

/** @param {string} id */
function follow(id) {
  nothing('');
  list.refresh();
  watch.start(id);
  compareWithDraft();
}

/** Shows no job. @param {string} [words] that say why */
function leave(words = '') {
  watch.stop();
  live.stop();
  store.take({ type: 'left' });
  compareWithDraft();
  showTitle();
  welcome(words);
  list.refresh();
}

/** Keeps the draft for when this tab is loaded again. */
function keep() {
  tab.set(KEPT, JSON.stringify(draft.job));
  tab.set(KEPT_AT, location.hash);
}

/**
 * Shows a job that somebody made.
 * @param {string} id
 * @param {boolean} edited whether the draft has been changed since it was shown
 * @param {AbortSignal} visit
 */
async function open(id, edited, visit) {
  if (store.state.current?.id === id) return;
  try {
    const job = await ask(`v1/jobs/${id}/request`);
    if (visit.aborted) return;
    store.take({ type: 'opened', id, job });
    if (!edited) draft.replace(job, 'link');
    follow(id);
  } catch (error) {
    if (visit.aborted) return;
    const problem = error instanceof Problem ? error : undefined;
    const { status, message } = problem ?? { status: -1, message: String(error) };
    // An unreachable service is asked again when it is back.
    if (problem?.passing && status !== 0)
      setTimeout(() => visit.aborted || open(id, edited, visit), 1000 * problem.retryAfter);
    leave(
      status === 404
        ? 'This link leads to a job that is not here: removed after its time, or made on another service.'
        : status === 401
          ? 'This job is shown to holders of an API key.'
          : status === 0
            ? 'The service does not answer. The job is shown when it does.'
            : `${sentence(message)}${problem?.passing ? ' It is asked again.' : ''}`,
    );
  }
}

/** Whether a job is compared, or is to be. @param {string} id */
const isChosen = (id) => store.state.compared.has(id) || store.state.chosen.has(id);

/** Shows a job; those that are laid over stay. @param {string} id */
function openBeside(id) {
  location.hash = link.jobFragment(
    id,
    [...store.state.compared.keys()].filter((one) => one !== id),
  );
}

/** @param {string} id @param {boolean} on */
async function compare(id, on) {
  // Beside nothing, the first one is shown.
  const { current } = store.state;
  if (on && !current) return openBeside(id);
  if (on) {
    store.take({ type: 'chosen', id });
    await layOver(id, () => store.state.current?.id === current?.id && store.state.chosen.has(id));
    if (!store.state.compared.has(id)) store.take({ type: 'dropped', ids: [id] });
  } else {
    store.take({ type: 'dropped', ids: [id] });
  }
  show();
  nameCompared();
}

/** Writes the compared jobs into the address and the list. */
function nameCompared() {
  const { current, compared } = store.state;
  const others = [...compared.keys()].filter((one) => one !== current?.id);
  if (current?.id && !address.isLeft)
    address.name('replaceState', link.jobFragment(current.id, others));
  keep();
  list.show();
}

/**
 * Fetches a job to be compared.
 * @param {string} id
 * @param {() => boolean} still whether it is wanted when it is here
 */
async function layOver(id, still) {
  try {
    const [report, job] = await Promise.all([fetchResult(id), ask(`v1/jobs/${id}/request`)]);
    if (!still()) return;
    // Others may have come meanwhile.
    const used = new Set([...store.state.compared.values()].map(({ colour }) => colour));
    const free = COLOURS.findIndex((one, k) => k > 0 && !used.has(one));
    if (free < 0) return toast(`${COLOURS.length} jobs are as many as can be told apart`);
    const fields = sourceOf(id, report, job);
    const [colour, dash] = [COLOURS[free], DASHES[free]];
    store.take({ type: 'laid', shown: { id, report, job, fields, label: '', colour, dash } });
  } catch (error) {
    if (still()) toast(/** @type {Error} */ (error).message);
  }
}

/**
 * Compares exactly the jobs that the address names.
 * @param {string[]} wanted
 * @param {() => boolean} still whether it names them
 */
async function compareOnly(wanted, still) {
  if (!still()) return;
  store.take({ type: 'only', ids: wanted });
  for (const id of wanted) if (still() && !store.state.compared.has(id)) await layOver(id, still);
  if (!still()) return;
  show();
  list.show();
}

/**
 * Shows the state that the address describes.
 * @param {boolean} [edited] whether the draft has been changed at this address
 */
async function applyAddress(edited = false) {
  view.closeReport();
  const visit = address.follow();
  const { job, compared: named, draft: packed, damaged } = link.read();
  if (job) {
    const all = [...new Set(named)].filter((id) => id !== job);
    const others = all.slice(0, COLOURS.length - 1);
    if (others.length < all.length) {
      toast(`${COLOURS.length} jobs are as many as can be told apart: the link names these now`);
      address.name('replaceState', link.jobFragment(job, others));
    }
    const { hash } = location;
    await open(job, edited, visit);
    // Who chooses another job to compare meanwhile names another address.
    return compareOnly(others, () => !visit.aborted && location.hash === hash);
  }
  if (damaged) return leave('This link is damaged: it does not name a job.');
  if (packed === undefined || edited) {
    // What a slider shows has no address.
    if (store.state.current?.id !== '') leave();
    return view.preview(check.hertz, draft.job);
  }
  const definition = await link.unpack(packed).catch(() => undefined);
  if (visit.aborted || address.isLeft) return;
  leave(isObject(definition) ? '' : 'This link is damaged: it does not carry a whole definition.');
  draft.replace(isObject(definition) ? definition : ((await examples)[0]?.job ?? {}), 'link');
}

async function begin() {
  const all = await examples;
  const choice = /** @type {HTMLSelectElement} */ (byId('example'));
  choice.append(...all.map(({ title }) => h('option', { value: title }, title)));
  choice.addEventListener('change', () => {
    const example = all.find(({ title }) => title === choice.value);
    if (example) draft.replace(example.job, 'example');
  });
  draft.addEventListener('change', () => {
    choice.value = all.find(({ job }) => same(job, draft.job))?.title ?? '';
  });
  const before = kept(tab, KEPT, (job) => (isObject(job) ? job : undefined));
  draft.replace(before ?? all[0]?.job ?? {}, before ? 'kept' : 'example');
  draft.addEventListener('change', keep);
  addEventListener('hashchange', () => {
    live.stop();
    applyAddress();
  });
  await applyAddress(before !== undefined && tab.get(KEPT_AT) === location.hash);
}

byId('solve').addEventListener('click', (event) => {
  if (event.detail > 1) event.preventDefault();
});
byId('form').addEventListener('submit', (event) => {
  event.preventDefault();
  solve();
});
addEventListener('keydown', (event) => {
  if (event.key === 'Escape') view.closeReport();
  // What is before the form is not to be solved around.
  const hidden =
    document.querySelector('dialog[open]') || document.documentElement.dataset.view === 'sheet';
  if (event.key === 'Enter' && (event.ctrlKey || event.metaKey) && !event.repeat && !hidden) {
    event.preventDefault();
    solve();
  }
});
draft.addEventListener('change', () => {
  compareWithDraft();
  // What is said of a job that waits to be sent stays.
  if (!sending.isOn) refuse('');
  showSending();
  // Not `disabled`: a button that has the focus would lose it.
  byId('undo').setAttribute('aria-disabled', String(!draft.undoable));
  byId('redo').setAttribute('aria-disabled', String(!draft.redoable));
});
byId('undo').addEventListener('click', () => draft.undo());
byId('redo').addEventListener('click', () => draft.redo());
addEventListener('keydown', (event) => {
  const key = event.key.toLowerCase();
  const inText = event.target instanceof Element && event.target.closest('#json, #jobs, dialog');
  if (!(event.ctrlKey || event.metaKey) || inText || !['z', 'y'].includes(key)) return;
  event.preventDefault();
  keepFocus(document.body, () => {
    // What is typed is shown as the draft has it: the field no longer counts as being typed in.
    /** @type {HTMLElement | null} */ (document.activeElement)?.blur();
    if (key === 'y' || event.shiftKey) draft.redo();
    else draft.undo();
  });
});
onReconnect(() => {
  if (!sending.isOn) refuse('');
  // A definition that the address carries has come, and may have been changed since.
  if (link.read().job) applyAddress();
  list.refresh();
  watch.look();
});
document.addEventListener('visibilitychange', () => {
  if (!document.hidden) watch.look();
});
byId('report').addEventListener('click', () => watch.look());
byId('restore').addEventListener('click', () => {
  const { current } = store.state;
  if (current) draft.replace(current.job, 'job');
  // The button is gone: what it was about is the result.
  byId('result').focus({ preventScroll: true });
});
byId('share-job').addEventListener('click', async () =>
  copy(await link.draftLink(draft.job), 'Link to this definition'),
);
for (const skip of document.querySelectorAll('[data-skip]'))
  skip.addEventListener('click', (event) => {
    event.preventDefault();
    byId(/** @type {HTMLElement} */ (skip).dataset.skip ?? '').focus();
  });

startParts(() => list.refresh());
startKeys();
startMenus();
begin();
