/**
 * The form: shows the draft, changes it, and puts the service's errors beside the fields they are
 * about.
 */

import { arrange, byId, h, plainButton, toast } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import { browser } from '../lib/kept.js';
import * as pointer from '../lib/pointer.js';
import { convert, forceOf, unit, unitsOf } from '../lib/units.js';
import { timeWords } from './accuracy.js';
import { jobFor } from './draft.js';
import { entry } from './entry.js';
import {
  DEFAULTS,
  INITIAL_STRESS,
  ISO_76,
  hasInitialStress,
  hasSurface,
  lawOf,
  loadOf,
  overDepthOf,
  ratedApproach,
  targetOf,
  tiltOf,
  usualElements,
} from './fields.js';
import { Kinds } from './kinds.js';
import { isFirst, layoutOf } from './layout.js';
import { onMaterials } from './library.js';
import { MaterialChoice } from './material-choice.js';
import { inWords } from './words.js';
import {
  curvePreview,
  heightsPreview,
  initialStressPreview,
  profilePreview,
  rollerPreview,
} from './preview.js';

/** @typedef {import('./field.js').Field} Field */
/** @typedef {import('../api/client.js').FieldError} FieldError */
/** @typedef {{entry: import('./entry.js').Entry, field: Field}} Made */
/** @typedef {'upper' | 'lower'} Body */

const SOURCE = 'form';
/** Whether all fields are shown, as this browser keeps it. */
const WHOLE = 'form-whole';

export class Form {
  /** @type {Map<string, Made>} by pointer */
  #fields = new Map();
  /** Those that there were before the form was built last. @type {Map<string, Made>} */
  #before = new Map();
  /** @type {import('./layout.js').Place[]} */
  #layout = [];
  /** The last job that was solved on one mesh. @type {import('./accuracy.js').Solved | undefined} */
  #solved;
  /** What the service has said of each field, and of which value. @type {Map<string, {message: string, of: unknown}>} */
  #reported = new Map();

  /**
   * @param {import('./draft.js').Draft} draft
   * @param {(moving: boolean) => void} slid called when a slider has changed the draft
   */
  constructor(draft, slid) {
    this.draft = draft;
    this.kinds = new Kinds(draft, SOURCE);
    this.slid = slid;
    this.root = byId('form');
    this.previews = { upper: previews('upper'), lower: previews('lower') };
    this.parts = this.#layOut();
    draft.addEventListener('change', () => keepFocus(this.root, () => this.#show()));
    // Who leaves a field, or takes hold of a slider again, begins another change.
    for (const leaves of ['focusout', 'pointerdown'])
      this.root.addEventListener(leaves, () => draft.settle());
    const choice = (/** @type {Body} */ body) =>
      new MaterialChoice(
        body,
        draft,
        (material) => {
          this.kinds.forget(`/${body}/material`);
          const place = `/${body}/material`;
          this.#followed(place, () => draft.set(place, material, SOURCE));
        },
        () => this.root.querySelector(`[data-place^="/${body}/material"] [aria-invalid=true]`),
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
        {
          message: more.length ? `${first} (and ${more.length} more)` : first,
          of: valueIn(job, place),
        },
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

  /** Says beside each accuracy how long it takes. @param {import('./accuracy.js').Solved} [solved] a job that is shown now */
  showTimes(solved) {
    if (solved?.report.status === 'converged' && !solved.job.mesh?.accuracy) this.#solved = solved;
    const { entry, field } = /** @type {Made} */ (this.#fields.get('/mesh/accuracy'));
    const { options } = /** @type {HTMLSelectElement} */ (entry.input);
    for (const option of options) {
      const words = timeWords(Number(option.value), this.draft.job, this.#solved);
      const label = field.choices?.[option.value];
      if (label) option.textContent = words ? `${label}, ${words}` : label;
    }
  }

  /** How many fields are wrong. */
  get faults() {
    return this.root.querySelectorAll('[aria-invalid=true]').length;
  }

  /** Puts the cursor into the first field at fault. */
  focusFault() {
    const fault = /** @type {HTMLElement | null} */ (
      this.root.querySelector('[aria-invalid=true]')
    );
    fault?.focus();
  }

  /** @param {string} place @returns {string | undefined} the field that shows it, or a part of it */
  #responsible(place) {
    for (let at = place; at; at = at.slice(0, at.lastIndexOf('/')))
      if (this.#fields.has(at)) return at;
    const below = [...this.#fields.keys()].find((at) => at.startsWith(`${place}/`));
    return place && below;
  }

  #show() {
    const { job } = this.draft;
    const layout = layoutOf(job);
    if (!pointer.same(layout, this.#layout)) this.#build(layout);
    this.#layout = layout;
    const units = unitsOf(job);
    for (const [place, { entry, field }] of this.#fields) {
      const usual =
        place === '/mesh/elements_per_half_width'
          ? usualElements(job)
          : /** @type {Record<string, unknown>} */ (DEFAULTS)[place];
      const value = valueIn(job, place);
      entry.show(value, usual);
      const first = isFirst(job, { part: 'title', place, field }, value, usual);
      entry.element.toggleAttribute('data-rest', !first);
      const quantity = field.quantity === 'load' ? forceOf(job) : field.quantity;
      if (quantity) entry.setUnit(field.unit ?? unit(quantity, units));
      if (field.columns)
        entry.setUnit(field.columns.map((one) => unit(one, units) || '1').join(', '));
    }
    // The indenter of a hardness test is no part of the job.
    const isTest = loadOf(job.load) === 'hardness';
    for (const part of [this.parts.general, this.parts.upper.fields.parentElement])
      if (part) part.hidden = isTest;
    const { settings } = this.parts;
    const rest = settings.querySelector(':scope > :not([data-rest])') === null;
    settings.parentElement?.toggleAttribute('data-rest', rest);
    const alike = pointer.same(job.upper, job.lower);
    this.parts.lower.copy.textContent = alike ? 'follows the upper' : 'same as upper';
    for (const body of /** @type {const} */ (['upper', 'lower'])) {
      this.materials[body].show();
      this.#showPreview(body);
      // With nothing to copy it is no stop of Tab; hidden, it would lose the focus that it has.
      this.parts[body].copy.tabIndex = alike ? -1 : 0;
    }
    this.#showErrors();
    this.showTimes();
  }

  /** @param {Body} body */
  #showPreview(body) {
    const { job } = this.draft;
    const { shape, curve, stress } = this.previews[body];
    shape.replaceChildren(
      ...profilePreview(job[body]?.shape, unitsOf(job)),
      ...rollerPreview(job, body),
      ...heightsPreview(job[body]?.surface, unitsOf(job)),
    );
    stress.replaceChildren(
      ...initialStressPreview(job[body]?.material, unitsOf(job), job.analysis === 'axisymmetric'),
    );
    curve.replaceChildren(...curvePreview(job[body]?.material, unitsOf(job)));
  }

  /** @param {import('./layout.js').Place[]} layout */
  #build(layout) {
    [this.#before, this.#fields] = [this.#fields, new Map()];
    const elements = /** @type {Map<string, Element[]>} */ (new Map());
    for (const { part, place, field } of layout) {
      const [body] = /** @type {[Body]} */ (part.split('/'));
      const made = field
        ? [this.#place(place, field, (value) => this.#change(place, value))]
        : this.#always(body, place);
      elements.set(part, [...(elements.get(part) ?? []), ...made]);
    }
    const of = (/** @type {import('./layout.js').Part} */ part) => elements.get(part) ?? [];
    for (const part of /** @type {const} */ (['title', 'general', 'load', 'settings']))
      arrange(this.parts[part], of(part));
    for (const body of /** @type {const} */ (['upper', 'lower']))
      arrange(this.parts[body].fields, of(body));
    this.#before.clear();
  }

  /** What a body has at a place whatever the job. @param {Body} body @param {string} place @returns {Element[]} */
  #always(body, place) {
    if (place === 'material') return this.materials[body].elements;
    return [this.previews[body][/** @type {'shape' | 'curve' | 'stress'} */ (place)]];
  }

  /** Takes what somebody has entered. @param {string} place @param {any} value */
  #change(place, value) {
    this.#followed(place, () => this.#take(place, value));
  }

  /**
   * The lower body follows the upper for as long as it is the same: in its measures and its
   * material. Of another shape the upper is alone.
   * @param {string} place that is changed @param {() => void} change
   */
  #followed(place, change) {
    const { upper, lower } = this.draft.job;
    const type = upper?.shape?.type;
    const follows = /^\/upper\/(shape|material)\b/.test(place) && pointer.same(upper, lower);
    change();
    const { job } = this.draft;
    if (follows && job.upper?.shape?.type === type)
      this.draft.amend('/lower', structuredClone(job.upper), SOURCE);
  }

  /** @param {string} place @param {any} value */
  #take(place, value) {
    const [, own, rest] = /^\/(upper|lower)\/(.*)$/.exec(place) ?? [];
    const [body, { kinds }] = [/** @type {Body} */ (own), this];
    switch (rest ?? place) {
      case '/analysis':
        return this.#useAnalysis(String(value));
      case '/units':
        this.draft.changeUnits(value, SOURCE);
        return this.#readAgain();
      case 'shape/type':
        return kinds.useShape(body, String(value));
      case 'shape/profile':
        return kinds.useProfile(body, value ? String(value) : undefined);
      case 'shape/tilt_kind':
        return kinds.useTilt(body, value);
      case 'surface_kind':
        return kinds.useSurface(body, value === 'given');
      case 'material/law':
        return kinds.useLaw(body, String(value));
      case 'material/plasticity/depth_kind':
        return kinds.useOverDepth(body, String(value));
      case 'material/stress_kind':
        return kinds.useInitialStress(body, value === 'given');
      case '/load/kind':
        return kinds.useLoad(String(value));
      case '/load/target_kind':
        return kinds.useTarget(String(value));
      // What is emptied to take another stays where it is; the choice above takes it away.
      case 'shape/moment':
        return this.draft.set(place, value ?? '', SOURCE);
      case `material/${INITIAL_STRESS.key}`:
        return this.draft.set(place, value ?? [], SOURCE);
      default:
        return this.draft.set(place, value, SOURCE);
    }
  }

  /** What holds the fields, and stays when they change. */
  #layOut() {
    const grid = () => h('div', { class: 'grid' });
    const body = (/** @type {Body} */ own, /** @type {Body} */ other) => {
      const take = () => {
        this.kinds.forget(`/${own}/`);
        this.draft.set(`/${own}`, structuredClone(this.draft.job[other]), SOURCE);
      };
      const copy = plainButton(`same as ${other}`, take);
      return { fields: grid(), copy };
    };
    const parts = {
      title: grid(),
      general: h('div', { class: 'pair' }),
      upper: body('upper', 'lower'),
      lower: body('lower', 'upper'),
      load: grid(),
      settings: grid(),
    };
    const fieldset = (
      /** @type {string} */ title,
      /** @type {Element} */ fields,
      /** @type {Element | undefined} */ copy = undefined,
    ) =>
      h(
        'fieldset',
        { class: copy && title.split(' ')[0].toLowerCase() },
        h('legend', {}, title, copy),
        fields,
      );
    const more = h('button', {
      type: 'button',
      class: 'plain more',
      'aria-controls': 'form',
      onclick: () => whole(!this.root.classList.contains('whole')),
    });
    const whole = (/** @type {boolean} */ on) => {
      this.root.classList.toggle('whole', on);
      more.setAttribute('aria-expanded', String(on));
      more.textContent = on ? 'Fewer fields' : 'More: all fields, mesh, solver, output';
      browser.set(WHOLE, String(on));
    };
    whole(browser.get(WHOLE) === 'true');
    this.root.replaceChildren(
      parts.title,
      parts.general,
      fieldset('Upper body', parts.upper.fields, parts.upper.copy),
      fieldset('Lower body', parts.lower.fields, parts.lower.copy),
      fieldset('Load', parts.load),
      fieldset('Mesh, solver, output, tags', parts.settings),
      more,
    );
    return parts;
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

  /** @param {string} place @param {Field} field @param {(value: unknown) => void} change */
  #place(place, field, change) {
    const body = place.split('/')[1];
    const before = this.#before.get(place);
    // A field that is the same stays: with the focus, and with what is being typed to choose from
    // a list.
    if (before && pointer.same(before.field, field)) {
      this.#fields.set(place, before);
      return before.entry.element;
    }
    const made = entry(field, change, {
      units: () => unitsOf(this.draft.job),
      quantity: ({ quantity }) => (quantity === 'load' ? forceOf(this.draft.job) : quantity),
      parent: () => this.draft.job[body]?.material,
      beside: (values) => {
        const whole = place.slice(0, place.lastIndexOf('/'));
        const merged = { ...pointer.get(this.draft.job, whole), ...values };
        this.draft.set(whole, merged, SOURCE);
      },
      inMaterial: (values) => {
        const whole = `/${body}/material`;
        const merged = { ...this.draft.job[body]?.material, ...values };
        this.#followed(whole, () => this.draft.set(whole, merged, SOURCE));
      },
      wire: (value, { quantity }) =>
        quantity && quantity !== 'load'
          ? convert(value, quantity, 'mm_N_MPa', unitsOf(this.draft.job))
          : value,
      slide: /^\/(solver|mesh)/.test(place)
        ? undefined
        : (value, moving) => {
            this.#followed(place, () => this.draft.set(place, value, 'slider'));
            this.slid(moving);
          },
    });
    made.element.dataset.place = place;
    this.#fields.set(place, { entry: made, field });
    return made.element;
  }
}

/** Places of the pictures of a body. @param {Body} body */
function previews(body) {
  const place = (/** @type {string} */ name) => h('div', { 'data-preview': `${body}-${name}` });
  const [shape, curve, stress] = ['shape', 'curve', 'stress'].map(place);
  curve.dataset.rest = '';
  return { shape, curve, stress };
}

/** What the field of a place shows: a part of the job, or which of its kinds it is. @param {import('../types.js').Job} job @param {string} place */
function valueIn(job, place) {
  const within = (/** @type {string} */ end) => pointer.get(job, place.slice(0, -end.length));
  if (place.endsWith('/plasticity/depth_kind'))
    return overDepthOf(within('/plasticity/depth_kind'));
  if (place.endsWith('/stress_kind'))
    return hasInitialStress(within('/stress_kind')) ? 'given' : 'none';
  if (place.endsWith('/surface_kind'))
    return hasSurface(within('/surface_kind')) ? 'given' : 'none';
  if (place.endsWith('/tilt_kind')) return tiltOf(within('/tilt_kind'));
  if (place.endsWith('/law')) return lawOf(within('/law'));
  if (place === '/load/kind') return loadOf(job.load);
  if (place === '/load/target_kind') {
    const rated = ratedApproach(job);
    return rated && job.load?.target?.permanent_approach === rated
      ? ISO_76.key
      : targetOf(job.load);
  }
  return pointer.get(job, place);
}

/** @param {string} place @param {FieldError} error @returns {string} with the part of the field that it is about */
function inner(place, { pointer, detail: reported }) {
  // A history has loads of nothing too.
  const detail = inWords(
    place === '/load/history'
      ? reported.replace('must be greater than 0', 'must be 0 or greater')
      : reported,
  );
  const part = pointer
    .slice(place.length + 1)
    .split('/')
    .filter((key) => /^\d+$/.test(key))
    .map((key) => Number(key) + 1);
  return part.length
    ? `${/(points|profile|over_depth|backstress|initial_stress|heights)$/.test(place) ? 'line' : place === '/load/history' ? 'load' : 'number'} ${part[0]}: ${detail}`
    : detail;
}
