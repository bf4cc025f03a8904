/**
 * The form: shows the draft, changes it, and puts the service's errors beside the fields they are
 * about.
 */

import { arrange, byId, h, toast } from '../lib/dom.js';
import { keepFocus } from '../lib/focus.js';
import * as pointer from '../lib/pointer.js';
import { convert, forceOf, unit, unitsOf } from '../lib/units.js';
import { jobFor } from './draft.js';
import { entry } from './entry.js';
import {
  BACKSTRESS,
  DEFAULTS,
  ELASTIC,
  INITIAL_STRESS,
  ISO_76,
  LAWS,
  OVER_DEPTH,
  LOADS,
  NAME,
  SETTINGS,
  SUPPORTS,
  SURFACE,
  TARGETS,
  THEORIES,
  TITLE,
  UNIT_SYSTEMS,
  ANALYSES,
  hasInitialStress,
  hasSurface,
  initialStressOf,
  lawOf,
  loadOf,
  overDepthOf,
  ratedApproach,
  shapeFields,
  shapesFor,
  targetOf,
  tiltOf,
  usualElements,
} from './fields.js';
import { Kinds, hasTerms } from './kinds.js';
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

/** @typedef {import('./fields.js').Field} Field */
/** @typedef {import('../api/client.js').FieldError} FieldError */
/** @typedef {{entry: import('./entry.js').Entry, field: Field}} Made */
/** @typedef {'upper' | 'lower'} Body */

const SOURCE = 'form';

export class Form {
  /** @type {Map<string, Made>} by pointer */
  #fields = new Map();
  /** Those that there were before the form was built last. @type {Map<string, Made>} */
  #before = new Map();
  #shape = '';
  /** Whether there is something not as usual below the fields that every body has. */
  #unusual = { upper: false, lower: false };
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
          draft.set(`/${body}/material`, material, SOURCE);
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

  /** How many fields are wrong. */
  get faults() {
    return this.root.querySelectorAll('[aria-invalid=true]').length;
  }

  /** Puts the cursor into the first field at fault. */
  focusFault() {
    const fault = /** @type {HTMLElement | null} */ (
      this.root.querySelector('[aria-invalid=true]')
    );
    fault?.closest('details')?.setAttribute('open', '');
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
      job.upper?.shape?.profile,
      job.lower?.shape?.profile,
      tiltOf(job.upper?.shape),
      tiltOf(job.lower?.shape),
      hasSurface(job.upper),
      hasSurface(job.lower),
      ratedApproach(job) !== undefined,
      job.analysis === 'axisymmetric',
      job.analysis === 'three_dimensional',
    ]);
    if (shape !== this.#shape) this.#build();
    this.#shape = shape;
    const units = unitsOf(job);
    for (const [place, { entry, field }] of this.#fields) {
      const usual = place === '/mesh/elements_per_half_width' ? usualElements(job) : undefined;
      entry.show(
        valueIn(job, place),
        usual ?? /** @type {Record<string, unknown>} */ (DEFAULTS)[place],
      );
      const quantity = field.quantity === 'load' ? forceOf(job) : field.quantity;
      if (quantity) entry.setUnit(field.unit ?? unit(quantity, units));
      if (field.columns)
        entry.setUnit(field.columns.map((one) => unit(one, units) || '1').join(', '));
    }
    const alike = pointer.same(job.upper, job.lower);
    for (const body of /** @type {const} */ (['upper', 'lower'])) {
      this.materials[body].show();
      this.#showPreview(body);
      // With nothing to copy it is no stop of Tab; hidden, it would lose the focus that it has.
      this.parts[body].copy.tabIndex = alike ? -1 : 0;
      // What is not as usual is seen, until somebody closes it.
      const unusual = isUnusual(job[body]);
      if (unusual && !this.#unusual[body]) this.parts[body].more.open = true;
      this.#unusual[body] = unusual;
    }
    this.#showErrors();
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

  #build() {
    [this.#before, this.#fields] = [this.#fields, new Map()];
    arrange(this.parts.title, [this.#field('', TITLE)]);
    arrange(this.parts.general, [
      this.#choice('/analysis', 'Analysis', ANALYSES, (analysis) =>
        this.#useAnalysis(String(analysis)),
      ),
      this.#choice('/units', 'Units', UNIT_SYSTEMS, (units) => {
        this.draft.changeUnits(/** @type {any} */ (units), SOURCE);
        this.#readAgain();
      }),
    ]);
    for (const body of /** @type {const} */ (['upper', 'lower'])) {
      const { fields, more, rare } = this.parts[body];
      arrange(fields, this.#body(body));
      arrange(rare, this.#rare(body));
      const { job } = this.draft;
      const law = lawOf(job[body]?.material);
      const words = [
        job.analysis !== 'three_dimensional' && 'support',
        LAWS[law]?.fields.length && 'strength over depth',
        law !== 'rigid' && 'initial stress',
      ].filter(Boolean);
      more.hidden = words.length === 0;
      /** @type {HTMLElement} */ (more.firstChild).textContent = words
        .join(', ')
        .replace(/^./, (letter) => letter.toUpperCase());
    }
    arrange(this.parts.load, this.#load());
    arrange(
      this.parts.settings,
      SETTINGS.map((field) => this.#field('', field)),
    );
    this.#before.clear();
  }

  /** What holds the fields, and stays when they change. */
  #layOut() {
    const grid = () => h('div', { class: 'grid' });
    const body = (/** @type {Body} */ own, /** @type {Body} */ other) => {
      const take = () => {
        this.kinds.forget(`/${own}/`);
        this.draft.set(`/${own}`, structuredClone(this.draft.job[other]), SOURCE);
      };
      const [fields, rare] = [grid(), grid()];
      const copy = h(
        'button',
        { type: 'button', class: 'plain', onclick: take },
        `same as ${other}`,
      );
      return { fields, rare, copy, more: h('details', {}, h('summary'), rare) };
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
      /** @type {ReturnType<typeof body>} */ { fields, more, copy },
      /** @type {string} */ title,
    ) => h('fieldset', {}, h('legend', {}, title, copy), fields, more);
    this.root.replaceChildren(
      parts.title,
      parts.general,
      fieldset(parts.upper, 'Upper body'),
      fieldset(parts.lower, 'Lower body'),
      h('fieldset', {}, h('legend', {}, 'Load'), parts.load),
      h('details', {}, h('summary', {}, 'Mesh, solver, output, tags'), parts.settings),
    );
    return parts;
  }

  /** Fields of a body. Their listeners read the draft when they are called: the form is not built anew by every change. @param {Body} body */
  #body(body) {
    const { job } = this.draft;
    const { shape, material } = job[body] ?? {};
    const at = `/${body}`;
    const law = lawOf(material);
    const laws = Object.fromEntries(Object.entries(LAWS).map(([key, { label }]) => [key, label]));
    const { shape: ofShape, curve } = this.previews[body];
    return [
      this.#choice(`${at}/shape/type`, 'Shape', shapesFor(job.analysis, shape?.type), (type) =>
        this.kinds.useShape(body, String(type)),
      ),
      ...shapeFields(shape).flatMap((field) =>
        field.key === 'profile'
          ? this.#place(`${at}/shape/profile`, field, (profile) =>
              this.kinds.useProfile(body, profile ? String(profile) : undefined),
            )
          : field.key === tiltOf(shape)
            ? this.#tilt(body, field)
            : this.#field(`${at}/shape`, field),
      ),
      ...this.#surface(body),
      ofShape,
      ...this.materials[body].elements,
      this.#field(`${at}/material`, NAME),
      ...(law === 'rigid' ? [] : ELASTIC.map((field) => this.#field(`${at}/material`, field))),
      this.#choice(`${at}/material/law`, 'Hardening', laws, (law) =>
        this.kinds.useLaw(body, String(law)),
      ),
      ...(LAWS[law]?.fields ?? [])
        .filter((field) => !isOverruled(material, field))
        .map((field) => this.#field(`${at}/material/plasticity`, field)),
      ...(hasBackstress(job, body) ? [this.#field(`${at}/material/plasticity`, BACKSTRESS)] : []),
      curve,
    ];
  }

  /** @param {Body} body @param {Field} field */
  #tilt(body, field) {
    const at = `/${body}/shape`;
    const kinds = { tilt: 'Tilt given', moment: 'Moment given' };
    return [
      this.#choice(`${at}/tilt_kind`, 'Misalignment', kinds, (kind) =>
        this.kinds.useTilt(body, kind),
      ),
      // A moment that is emptied to take another stays where it is; the choice takes it away.
      this.#place(`${at}/${field.key}`, field, (value) =>
        this.draft.set(
          `${at}/${field.key}`,
          value ?? (field.key === 'moment' ? '' : undefined),
          SOURCE,
        ),
      ),
    ];
  }

  /** @param {Body} body */
  #surface(body) {
    const { analysis, [body]: of } = this.draft.job;
    if (analysis !== 'three_dimensional' || of?.shape?.type === 'roller') return [];
    return [
      this.#choice(
        `/${body}/surface_kind`,
        'Surface',
        { none: 'Smooth', given: 'Heights' },
        (kind) => this.kinds.useSurface(body, kind === 'given'),
      ),
      ...(hasSurface(of) ? SURFACE.map((field) => this.#field(`/${body}`, field)) : []),
    ];
  }

  /** Fields that few bodies need. @param {Body} body */
  #rare(body) {
    const law = lawOf(this.draft.job[body]?.material);
    return [
      // A half-space has no far boundary.
      ...(this.draft.job.analysis === 'three_dimensional'
        ? []
        : [this.#choice(`/${body}/support`, 'Support', SUPPORTS)]),
      ...(LAWS[law]?.fields.length ? this.#overDepth(body) : []),
      ...(law === 'rigid' ? [] : this.#initialStress(body)),
      this.previews[body].stress,
    ];
  }

  /** @param {Body} body */
  #overDepth(body) {
    const plasticity = `/${body}/material/plasticity`;
    const kinds = Object.entries(OVER_DEPTH).map(([key, { label }]) => [key, label]);
    const { fields = [] } = OVER_DEPTH[overDepthOf(this.draft.job[body]?.material)] ?? {};
    return [
      this.#choice(
        `${plasticity}/depth_kind`,
        'Strength over depth',
        { uniform: 'Uniform', ...Object.fromEntries(kinds) },
        (kind) => this.kinds.useOverDepth(body, String(kind)),
      ),
      ...fields.map((field) => this.#field(plasticity, field)),
      ...(LAWS[lawOf(this.draft.job[body]?.material)]?.fields ?? [])
        .filter((field) => isOverruled(this.draft.job[body]?.material, field))
        .map((field) =>
          this.#field(plasticity, {
            ...field,
            hint: 'Strength comes from the hardness; this law gives the shape of its curve.',
          }),
        ),
    ];
  }

  /** @param {Body} body */
  #initialStress(body) {
    const at = `/${body}/material`;
    const place = `${at}/${INITIAL_STRESS.key}`;
    // A table that is emptied to take another stays where it is; the choice above takes it away.
    const field = initialStressOf(this.draft.job.analysis);
    const stresses = () =>
      this.#place(place, field, (value) => this.draft.set(place, value ?? [], SOURCE));
    return [
      this.#choice(
        `${at}/stress_kind`,
        'Initial stress',
        { none: 'None', given: 'Over depth' },
        (kind) => this.kinds.useInitialStress(body, kind === 'given'),
      ),
      ...(hasInitialStress(this.draft.job[body]?.material) ? [stresses()] : []),
    ];
  }

  #load() {
    const { load } = this.draft.job;
    const kind = loadOf(load);
    const { fields } = LOADS[kind];
    const kinds = Object.fromEntries(
      Object.entries(LOADS).map(([key, { label }]) => [key, label]),
    );
    const figures = {
      ...Object.fromEntries(Object.entries(TARGETS).map(([key, { label }]) => [key, label])),
      ...(ratedApproach(this.draft.job) && { [ISO_76.key]: ISO_76.label }),
    };
    const target = () => [
      this.#choice('/load/target_kind', 'Figure', figures, (figure) =>
        this.kinds.useTarget(String(figure)),
      ),
      this.#field('/load', TARGETS[targetOf(load)]),
    ];
    return [
      this.#choice('/load/kind', 'Given', kinds, (kind) => this.kinds.useLoad(String(kind))),
      ...fields.map((field) => this.#field('/load', field)),
      ...(kind === 'target' ? target() : []),
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
      wire: (value, { quantity }) =>
        quantity && quantity !== 'load'
          ? convert(value, quantity, 'mm_N_MPa', unitsOf(this.draft.job))
          : value,
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
}

/** Places of the pictures of a body. @param {Body} body */
function previews(body) {
  const place = (/** @type {string} */ name) => h('div', { 'data-preview': `${body}-${name}` });
  return { shape: place('shape'), curve: place('curve'), stress: place('stress') };
}

/** Whether hardness over depth stands in place of a figure of the law. @param {any} material @param {Field} field */
const isOverruled = (material, { key }) =>
  ['hardness', 'case'].includes(overDepthOf(material)) &&
  (key === 'yield_stress' || key === 'reference_stress');

/** Whether a body has something in the fields that few need. @param {Record<string, any> | undefined} body */
const isUnusual = (body) =>
  (body?.support ?? 'clamped') !== 'clamped' ||
  overDepthOf(body?.material) !== 'uniform' ||
  hasInitialStress(body?.material);

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

/** Whether there is a place for the terms of the backstress, which flow theory alone knows. @param {import('../types.js').Job} job @param {Body} body */
const hasBackstress = (job, body) =>
  Boolean(LAWS[lawOf(job[body]?.material)]?.fields.length) &&
  (job.solver?.theory === 'flow' || hasTerms(job[body]));

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
