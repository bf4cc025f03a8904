/** The form: shows the draft, changes it, and puts the service's errors beside the fields they are about. */

import { arrange, byId, h, toast } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import * as pointer from '../lib/pointer.js';
import { numberOf } from '../lib/number.js';
import { convert, forceOf, unit, unitsOf } from '../lib/units.js';
import { jobFor } from './draft.js';
import { entry } from './entry.js';
import {
  ANALYSES,
  BACKSTRESS,
  DEFAULTS,
  ELASTIC,
  INITIAL_STRESS,
  LAWS,
  OVER_DEPTH,
  LOADS,
  SETTINGS,
  SHAPES,
  PERMANENT,
  SUPPORTS,
  TARGETS,
  THEORIES,
  UNIT_SYSTEMS,
  hasInitialStress,
  lawOf,
  loadOf,
  overDepthOf,
  plasticityLike,
  shapeLabel,
  shapeLike,
  targetOf,
  typicalInitialStress,
  typicalOverDepth,
} from './fields.js';
import { onMaterials } from './library.js';
import { MaterialChoice } from './material-choice.js';
import { inWords } from './words.js';
import { curvePreview, initialStressPreview, profilePreview } from './preview.js';

/** @typedef {import('./fields.js').Field} Field */
/** @typedef {import('../api/client.js').FieldError} FieldError */

const SOURCE = 'form';
/** Loads [mm, N] where there was none. */
const TYPICAL = { force: 600, approach: 0.02 };

export class Form {
  /** @type {Map<string, {entry: import('./entry.js').Entry, field: Field}>} by pointer */
  #fields = new Map();
  /** Those before the form was put together anew: what is needed again stays as it is. */
  #former = this.#fields;
  #shape = '';
  /** What the service has said of each field, and of which value. @type {Map<string, {message: string, of: unknown}>} */
  #reported = new Map();

  /** Where the fields stand. */
  #parts = {
    general: h('div', { class: 'pair' }),
    upper: h('div', { class: 'grid' }),
    lower: h('div', { class: 'grid' }),
    load: h('div', { class: 'grid' }),
    settings: h('div', { class: 'grid' }),
  };
  #previews = { upper: previewsOf('upper'), lower: previewsOf('lower') };

  /** Whether flow theory was chosen with a load that it alone knows. */
  #lent = false;

  /**
   * @param {import('./draft.js').Draft} draft
   * @param {(moving: boolean) => void} slid called when a slider has changed the draft
   */
  constructor(draft, slid) {
    this.draft = draft;
    draft.addEventListener('change', (event) => {
      const { detail } = /** @type {CustomEvent} */ (event);
      if (![SOURCE, 'slider', 'page'].includes(detail) || draft.job.solver?.theory !== 'flow') this.#lent = false;
    });
    this.slid = slid;
    this.root = byId('form');
    draft.addEventListener('change', () => keepFocus(this.root, () => this.#show()));
    // Who leaves a field, or takes hold of a slider again, begins another change.
    for (const leaves of ['focusout', 'pointerdown']) this.root.addEventListener(leaves, () => draft.settle());
    const choice = (/** @type {'upper' | 'lower'} */ body) =>
      new MaterialChoice(body, draft, SOURCE, () =>
        this.root.querySelector(`[data-place^="/${body}/material"] [aria-invalid=true]`),
      );
    this.materials = { upper: choice('upper'), lower: choice('lower') };
    onMaterials(() => {
      this.materials.upper.list();
      this.materials.lower.list();
    });
  }

  /**
   * @param {FieldError[]} errors
   * @param {import('../types.js').Job} [job] that they are of
   * @returns {FieldError[]} those that no field is responsible for
   */
  showError(errors, job = this.draft.job) {
    const messages = /** @type {Map<string, string[]>} */ (new Map());
    const others = [];
    for (const error of errors) {
      const place = this.#responsible(error.pointer);
      if (place === undefined) others.push(error);
      else messages.set(place, [...(messages.get(place) ?? []), inner(place, error)]);
    }
    this.#reported = new Map(
      [...messages].map(([place, [first, ...more]]) => [
        place,
        { message: more.length ? `${first} (and ${more.length} more)` : first, of: valueIn(job, place) },
      ]),
    );
    this.#showErrors();
    return others;
  }

  #showErrors() {
    for (const [place, { entry }] of this.#fields) {
      const reported = this.#reported.get(place);
      // A message is of the value that was at fault, not of what stands there since.
      const holds = reported && pointer.same(reported.of, valueIn(this.draft.job, place));
      entry.showError(holds ? reported.message : '');
    }
  }

  /** How many fields are wrong. */
  get faults() {
    return this.root.querySelectorAll('[aria-invalid=true]').length;
  }

  /** Puts the cursor into the first field at fault. */
  focusFault() {
    const fault = /** @type {HTMLElement | null} */ (this.root.querySelector('[aria-invalid=true]'));
    fault?.closest('details')?.setAttribute('open', '');
    fault?.focus();
  }

  /** @param {string} place @returns {string | undefined} the field that shows it, or a part of it */
  #responsible(place) {
    for (let at = place; at; at = at.slice(0, at.lastIndexOf('/'))) if (this.#fields.has(at)) return at;
    const below = [...this.#fields.keys()].find((at) => at.startsWith(`${place}/`));
    return place && below;
  }

  #show() {
    const { job } = this.draft;
    const shape = JSON.stringify([
      lawOf(job.upper?.material),
      lawOf(job.lower?.material),
      overDepthOf(job.upper?.material),
      overDepthOf(job.lower?.material),
      hasBackstress(job, 'upper'),
      hasBackstress(job, 'lower'),
      hasInitialStress(job.upper?.material),
      hasInitialStress(job.lower?.material),
      loadOf(job.load),
      targetOf(job.load),
      job.upper?.shape?.type,
      job.lower?.shape?.type,
      job.analysis === 'axisymmetric',
    ]);
    if (shape !== this.#shape) this.#build();
    this.#shape = shape;
    const units = unitsOf(job);
    for (const [place, { entry, field }] of this.#fields) {
      entry.show(valueIn(job, place), /** @type {Record<string, unknown>} */ (DEFAULTS)[place]);
      const quantity = field.quantity === 'load' ? forceOf(job) : field.quantity;
      if (quantity) entry.setUnit(unit(quantity, units));
      if (field.columns) entry.setUnit(field.columns.map((one) => unit(one, units) || '1').join(', '));
    }
    for (const body of /** @type {const} */ (['upper', 'lower'])) {
      this.materials[body].show();
      this.#showPreview(body);
    }
    this.#showErrors();
  }

  /** @param {'upper' | 'lower'} body */
  #showPreview(body) {
    const { job } = this.draft;
    const { shape, stress, curve } = this.#previews[body];
    shape.replaceChildren(...profilePreview(job[body]?.shape, unitsOf(job)));
    stress.replaceChildren(...initialStressPreview(job[body]?.material, unitsOf(job)));
    curve.replaceChildren(...curvePreview(job[body]?.material, unitsOf(job)));
  }

  /** Puts the form together for the kinds that the draft has. */
  #build() {
    this.#former = this.#fields;
    this.#fields = new Map();
    if (!this.root.firstChild)
      this.root.append(
        this.#parts.general,
        this.#fieldset('upper', 'Upper body'),
        this.#fieldset('lower', 'Lower body'),
        h('fieldset', {}, h('legend', {}, 'Load'), this.#parts.load),
        h('details', {}, h('summary', {}, 'Mesh, solver, output, tags'), this.#parts.settings),
      );
    arrange(this.#parts.general, [
      this.#choice('/analysis', 'Analysis', ANALYSES, (analysis) => this.#useAnalysis(String(analysis))),
      this.#choice('/units', 'Units', UNIT_SYSTEMS, (units) => {
        this.draft.changeUnits(/** @type {any} */ (units), SOURCE);
        this.#readAgain();
      }),
    ]);
    for (const body of /** @type {const} */ (['upper', 'lower'])) arrange(this.#parts[body], this.#body(body));
    arrange(this.#parts.load, this.#load());
    arrange(
      this.#parts.settings,
      SETTINGS.map((field) => this.#field('', field)),
    );
  }

  /** @param {'upper' | 'lower'} body @param {string} title */
  #fieldset(body, title) {
    const other = body === 'upper' ? 'lower' : 'upper';
    const copy = () => this.draft.set(`/${body}`, structuredClone(this.draft.job[other]), SOURCE);
    return h(
      'fieldset',
      {},
      h('legend', {}, title, h('button', { type: 'button', class: 'plain', onclick: copy }, `same as ${other}`)),
      this.#parts[body],
    );
  }

  /** @param {'upper' | 'lower'} body @returns {(Node | false)[]} */
  #body(body) {
    const { job } = this.draft;
    const at = `/${body}`;
    const law = lawOf(job[body]?.material);
    const shape = job[body]?.shape?.type;
    const shapes = Object.fromEntries(Object.keys(SHAPES).map((key) => [key, shapeLabel(key, job.analysis)]));
    return [
      this.#choice(`${at}/shape/type`, 'Shape', shapes, (type) =>
        this.draft.set(`${at}/shape`, this.#shapeLike(body, String(type)), SOURCE),
      ),
      ...(SHAPES[shape]?.fields ?? []).map((field) => this.#field(`${at}/shape`, field)),
      this.#previews[body].shape,
      this.#choice(`${at}/support`, 'Support', SUPPORTS),
      ...this.materials[body].elements,
      ...(law === 'rigid' ? [] : ELASTIC.map((field) => this.#field(`${at}/material`, field))),
      this.#choice(
        `${at}/material/law`,
        'Hardening',
        Object.fromEntries(Object.entries(LAWS).map(([key, { label }]) => [key, label])),
        (law) => this.#useLaw(body, String(law)),
      ),
      ...(LAWS[law]?.fields.map((field) => this.#field(`${at}/material/plasticity`, field)) ?? []),
      ...(LAWS[law]?.fields.length ? this.#overDepth(body) : []),
      hasBackstress(job, body) && this.#field(`${at}/material/plasticity`, BACKSTRESS),
      this.#previews[body].curve,
      ...(law === 'rigid' ? [] : this.#initialStress(body)),
      this.#previews[body].stress,
    ];
  }

  /** @param {'upper' | 'lower'} body @param {string} type */
  #shapeLike(body, type) {
    const { job } = this.draft;
    return shapeLike(type, job[body]?.shape, unitsOf(job));
  }

  /** @param {'upper' | 'lower'} body */
  #overDepth(body) {
    const { job } = this.draft;
    const plasticity = `/${body}/material/plasticity`;
    const kinds = Object.entries(OVER_DEPTH).map(([key, { label }]) => [key, label]);
    return [
      this.#choice(
        `${plasticity}/depth_kind`,
        'Strength over depth',
        { uniform: 'Uniform', ...Object.fromEntries(kinds) },
        (kind) =>
          this.draft.set(`${plasticity}/over_depth`, typicalOverDepth(String(kind), unitsOf(this.draft.job)), SOURCE),
      ),
      ...(OVER_DEPTH[overDepthOf(job[body]?.material)]?.fields ?? []).map((field) => this.#field(plasticity, field)),
    ];
  }

  /** @param {'upper' | 'lower'} body */
  #initialStress(body) {
    const at = `/${body}/material`;
    const make = () => typicalInitialStress(this.draft.job, this.draft.job[body]?.material);
    return [
      this.#choice(`${at}/stress_kind`, 'Initial stress', { none: 'None', given: 'Over depth' }, (kind) =>
        this.draft.set(`${at}/initial_stress`, kind === 'given' ? make() : undefined, SOURCE),
      ),
      hasInitialStress(this.draft.job[body]?.material) && this.#field(at, INITIAL_STRESS),
    ];
  }

  #load() {
    const kind = loadOf(this.draft.job.load);
    const { field } = LOADS[kind];
    const kinds = Object.fromEntries(Object.entries(LOADS).map(([key, { label }]) => [key, label]));
    return [
      this.#choice('/load/kind', 'Given', kinds, (kind) => this.#useLoad(String(kind))),
      field && this.#field('/load', field),
      ...(kind === 'target' ? this.#target() : []),
      this.#choice('/solver/theory', 'Theory', THEORIES),
    ];
  }

  /** @param {string} analysis */
  #useAnalysis(analysis) {
    const { job } = this.draft;
    const before = forceOf(job);
    this.draft.replace(jobFor(job, analysis), SOURCE);
    this.#readAgain();
    const now = forceOf(this.draft.job);
    const given = ['force', 'forces', 'history'].includes(loadOf(job.load));
    if (given && now !== before)
      toast(
        now === 'force'
          ? `The load is that of the whole contact now, in ${unit(now, unitsOf(job))}`
          : `The load is that of each length now, in ${unit(now, unitsOf(job))}`,
      );
  }

  /** Reads anew what could not be read: a unit may be right where it was wrong. */
  #readAgain() {
    for (const [place, { entry }] of [...this.#fields]) {
      if (typeof pointer.get(this.draft.job, place) !== 'string' || !entry.read) continue;
      const value = entry.read();
      if (typeof value !== 'string') this.draft.amend(place, value, SOURCE);
    }
  }

  #target() {
    const figures = Object.fromEntries(Object.entries(TARGETS).map(([key, { label }]) => [key, label]));
    return [
      this.#choice('/load/target_kind', 'Figure', figures, (figure) => this.#useTarget(String(figure))),
      this.#field('/load', TARGETS[targetOf(this.draft.job.load)]),
    ];
  }

  /** @param {string} figure */
  #useTarget(figure) {
    const job = structuredClone(this.draft.job);
    const { example, quantity } = TARGETS[figure];
    const value = quantity && quantity !== 'load' ? convert(example, quantity, 'mm_N_MPa', unitsOf(job)) : example;
    this.#setLoad(job, { target: { [figure]: value } }, PERMANENT.has(figure));
  }

  /** Gives the job another load, and flow theory as long as that alone knows the load. @param {import('../types.js').Job} job @param {object} load @param {boolean} flow */
  #setLoad(job, load, flow) {
    const theory = job.solver?.theory;
    const needed = flow || job.solver?.increments != null || hasTerms(job.upper) || hasTerms(job.lower);
    const back = this.#lent && !needed;
    const solver = { ...job.solver, theory: flow ? 'flow' : 'deformation' };
    this.draft.replace({ ...job, load, ...((flow || back) && { solver }) }, SOURCE);
    this.#lent = flow && (theory !== 'flow' || this.#lent);
    if (back) toast('Deformation theory again: this load does not need flow theory');
  }

  /** @param {string} parent @param {Field} field */
  #field(parent, field) {
    return this.#place(`${parent}/${field.key}`, field, (value) =>
      this.draft.set(`${parent}/${field.key}`, value, SOURCE),
    );
  }

  /** @param {string} place @param {string} label @param {Record<string, string>} choices @param {(value: unknown) => void} [change] */
  #choice(place, label, choices, change) {
    return this.#place(
      place,
      { key: place.slice(place.lastIndexOf('/') + 1), label, kind: 'choice', choices },
      change ?? ((value) => this.draft.set(place, value, SOURCE)),
    );
  }

  /** @param {string} place @param {Field} field @param {(value: unknown) => void} change */
  #place(place, field, change) {
    const former = this.#former.get(place);
    if (former && JSON.stringify(former.field) === JSON.stringify(field)) {
      this.#fields.set(place, former);
      return former.entry.element;
    }
    const body = place.split('/')[1];
    const made = entry(field, change, {
      units: () => unitsOf(this.draft.job),
      quantity: ({ quantity }) => (quantity === 'load' ? forceOf(this.draft.job) : quantity),
      parent: () => this.draft.job[body]?.material,
      wire: (value, { quantity }) =>
        quantity && quantity !== 'load' ? convert(value, quantity, 'mm_N_MPa', unitsOf(this.draft.job)) : value,
      slide: /^\/(solver|mesh)/.test(place)
        ? undefined
        : (value, moving) => {
            this.draft.set(place, value, 'slider');
            this.slid(moving);
          },
    });
    made.element.dataset.place = place;
    this.#fields.set(place, { entry: made, field });
    return made.element;
  }

  /** @param {'upper' | 'lower'} body @param {string} law */
  #useLaw(body, law) {
    const { job } = this.draft;
    const old = job[body]?.material;
    const steel = convert(210_000, 'stress', 'mm_N_MPa', unitsOf(job));
    const elastic = { young_modulus: old?.young_modulus ?? steel, poisson_ratio: old?.poisson_ratio ?? 0.3 };
    const { over_depth, backstress } = old?.plasticity ?? {};
    const plasticity = plasticityLike(law, { ...elastic, ...old });
    if (plasticity && over_depth) plasticity.over_depth = over_depth;
    if (plasticity && backstress) plasticity.backstress = backstress;
    this.draft.set(
      `/${body}/material`,
      law === 'rigid'
        ? { rigid: true }
        : {
            ...elastic,
            ...(plasticity && { plasticity }),
            ...(old?.initial_stress && { initial_stress: old.initial_stress }),
          },
      SOURCE,
    );
  }

  /** @param {string} kind */
  #useLoad(kind) {
    if (kind === 'target') return this.#useTarget('peak_pressure');
    const { job } = this.draft;
    const { load: old } = job;
    const units = unitsOf(job);
    // What is no list yet is text as it was typed.
    const inTurn = (/** @type {string} */ key) => (Array.isArray(old?.[key]) ? old[key] : []);
    const last = (/** @type {string} */ key) => numberOf(inTurn(key).at(-1));
    const highest = Math.max(...inTurn('history').map((load) => numberOf(load?.force) || 0));
    const one = [numberOf(old?.force), last('forces'), highest].find((force) => force > 0);
    const deep = [numberOf(old?.approach), last('approaches')].find((approach) => approach > 0);
    const force = one ?? convert(TYPICAL.force, forceOf(job), 'mm_N_MPa', units);
    const approach = deep ?? convert(TYPICAL.approach, 'length', 'mm_N_MPa', units);
    const sweep = (/** @type {number} */ end) =>
      Array.from({ length: 10 }, (_, k) => Number(((end * (k + 1)) / 10).toPrecision(6)));
    const loads = /** @type {Record<string, unknown>} */ ({
      force,
      forces: sweep(force),
      approach,
      approaches: sweep(approach),
      history: [{ force }, { force: 0 }],
      onset: true,
    });
    this.#setLoad(job, { [kind]: loads[kind] }, kind === 'history');
  }
}

/** @param {string} body */
const previewsOf = (body) => ({
  shape: h('div', { 'data-preview': `${body}-shape` }),
  curve: h('div', { 'data-preview': `${body}-curve` }),
  stress: h('div', { 'data-preview': `${body}-stress` }),
});

/** What the field of a place shows: a part of the job, or which of its kinds it is. @param {import('../types.js').Job} job @param {string} place */
function valueIn(job, place) {
  const within = (/** @type {string} */ end) => pointer.get(job, place.slice(0, -end.length));
  if (place.endsWith('/plasticity/depth_kind')) return overDepthOf(within('/plasticity/depth_kind'));
  if (place.endsWith('/stress_kind')) return hasInitialStress(within('/stress_kind')) ? 'given' : 'none';
  if (place.endsWith('/law')) return lawOf(within('/law'));
  if (place === '/load/kind') return loadOf(job.load);
  if (place === '/load/target_kind') return targetOf(job.load);
  return pointer.get(job, place);
}

/** Whether a body has backstress, which flow theory alone knows. @param {any} body */
const hasTerms = (body) => Boolean(body?.material?.plasticity?.backstress);

/** Whether there is a place for the terms of the backstress, which flow theory alone knows. @param {import('../types.js').Job} job @param {'upper' | 'lower'} body */
const hasBackstress = (job, body) =>
  Boolean(LAWS[lawOf(job[body]?.material)]?.fields.length) && (job.solver?.theory === 'flow' || hasTerms(job[body]));

/** @param {string} place @param {FieldError} error @returns {string} with the part of the field that it is about */
function inner(place, { pointer, detail: reported }) {
  const detail = inWords(reported);
  const part = pointer
    .slice(place.length + 1)
    .split('/')
    .filter((key) => /^\d+$/.test(key))
    .map((key) => Number(key) + 1);
  return part.length
    ? `${/(points|profile|over_depth|backstress|initial_stress)$/.test(place) ? 'line' : place === '/load/history' ? 'load' : 'number'} ${part[0]}: ${detail}`
    : detail;
}
