/**
 * Choosing another kind of a shape, a hardening or a load: as it was given before, or else with
 * typical figures of about the same size. Whoever only looks at another kind loses nothing.
 */

import { toast } from '../lib/dom.js';
import { isObject } from '../lib/kept.js';
import { numberOf } from '../lib/number.js';
import * as pointer from '../lib/pointer.js';
import { convert, forceOf, unitsOf } from '../lib/units.js';
import { jobIn } from './draft.js';
import {
  ISO_76,
  LAWS,
  TARGETS,
  lawOf,
  loadOf,
  overDepthOf,
  plasticityLike,
  profileLike,
  ratedApproach,
  shapeLike,
  targetOf,
  tiltOf,
  typicalInitialStress,
  typicalModulus,
  typicalOverDepth,
  typicalSurface,
} from './fields.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {'upper' | 'lower'} Body */

/** Loads [mm, N] where there was none. */
const TYPICAL = { force: 600, approach: 0.02 };

export class Kinds {
  /** What was given of each kind, by place and kind: parts of jobs in mm, N, MPa. @type {Map<string, Job>} */
  #given = new Map();
  /** Hardening of the bodies that were made rigid with their shape. @type {Map<Body, string>} */
  #stiffened = new Map();

  /** @param {import('./draft.js').Draft} draft @param {string} source of its changes */
  constructor(draft, source) {
    this.draft = draft;
    this.source = source;
    draft.addEventListener('change', (event) => {
      const { detail } = /** @type {CustomEvent} */ (event);
      const own = [source, 'slider', 'page'].includes(detail);
      // Another job has nothing to do with what was given before.
      if (!own && detail !== 'undo') this.forget('');
    });
  }

  /** Forgets what was given below a place. @param {string} place */
  forget(place) {
    for (const key of this.#given.keys()) if (key.startsWith(place)) this.#given.delete(key);
    for (const body of this.#stiffened.keys())
      if (`/${body}/material`.startsWith(place)) this.#stiffened.delete(body);
  }

  /** @param {string} place of the draft @param {string} kind that it has */
  #keep(place, kind) {
    const { job } = this.draft;
    const part = /** @type {Job} */ ({ units: job.units, analysis: job.analysis });
    pointer.set(part, place, pointer.get(job, place));
    this.#given.set(`${place} ${kind}`, jobIn(part, 'mm_N_MPa'));
  }

  /** @param {string} place @param {string} kind @returns {any} in the units of the draft; `undefined` if that kind was never given */
  #before(place, kind) {
    const part = this.#given.get(`${place} ${kind}`);
    const { job } = this.draft;
    return part && pointer.get(jobIn({ ...part, analysis: job.analysis }, unitsOf(job)), place);
  }

  /** @param {Body} body @param {string} type */
  useShape(body, type) {
    const at = `/${body}/shape`;
    const job = structuredClone(this.draft.job);
    const { shape, material } = job[body] ?? {};
    this.#keep(at, String(shape?.type));
    const law = lawOf(material);
    const lent = this.#stiffened.get(body);
    pointer.set(job, at, this.#before(at, type) ?? shapeLike(type, shape, unitsOf(job)));
    if (type === 'punch' && law !== 'rigid') {
      pointer.set(job, `/${body}/material`, this.#materialOf(body, 'rigid'));
      this.#stiffened.set(body, law);
      toast('The body is rigid now, as a flat punch has to be');
    } else if (type !== 'punch' && law === 'rigid' && lent) {
      pointer.set(job, `/${body}/material`, this.#materialOf(body, lent));
      this.#stiffened.delete(body);
    }
    // Heights do not stand on a roller.
    if (type === 'roller') delete job[body].surface;
    this.draft.set(`/${body}`, job[body], this.source);
  }

  /** Another profile of a roller, with what it is given by and without what the others are. @param {Body} body @param {string} [profile] */
  useProfile(body, profile) {
    const at = `/${body}/shape`;
    const { job } = this.draft;
    const old = job[body].shape;
    this.#keep(at, `roller ${old.profile}`);
    const { crown_radius: _, design_force: __, points: ___, profile: ____, ...own } = old;
    const before = profile && this.#before(at, `roller ${profile}`);
    const given = Object.fromEntries(
      Object.keys(profile ? profileLike(profile, old, job) : {}).flatMap((key) =>
        before?.[key] === undefined ? [] : [[key, before[key]]],
      ),
    );
    const shape = profile ? { ...own, profile, ...profileLike(profile, old, job), ...given } : own;
    this.draft.set(at, shape, this.source);
  }

  /** A tilt, or a moment under which it is found. @param {Body} body @param {unknown} kind */
  useTilt(body, kind) {
    const at = `/${body}/shape`;
    const { shape } = this.draft.job[body];
    this.#keep(at, `roller ${tiltOf(shape)}`);
    const { tilt: _, moment: __, ...own } = shape;
    const before = this.#before(at, `roller ${kind}`);
    const chosen = kind === 'moment' ? { moment: before?.moment ?? 0 } : { tilt: before?.tilt };
    this.draft.set(at, { ...own, ...chosen }, this.source);
  }

  /** @param {Body} body @param {boolean} given whether heights stand on it */
  useSurface(body, given) {
    const at = `/${body}/surface`;
    const { job } = this.draft;
    if (!given) this.#keep(at, 'given');
    this.draft.set(
      at,
      given ? (this.#before(at, 'given') ?? typicalSurface(unitsOf(job))) : undefined,
      this.source,
    );
  }

  /** @param {Body} body @param {string} law */
  useLaw(body, law) {
    this.#stiffened.delete(body);
    this.draft.set(`/${body}/material`, this.#materialOf(body, law), this.source);
  }

  /** @param {Body} body @param {string} law @returns {Record<string, any>} its material with another hardening */
  #materialOf(body, law) {
    const at = `/${body}/material`;
    const units = unitsOf(this.draft.job);
    const now = this.draft.job[body]?.material;
    this.#keep(at, lawOf(now));
    if (!now?.rigid) this.#keep(at, 'deformable');
    if (now?.plasticity) this.#keep(at, 'hardening');
    if (law === 'rigid') return { rigid: true };
    const old = now?.rigid ? this.#before(at, 'deformable') : now;
    const material = {
      young_modulus: old?.young_modulus ?? typicalModulus(units),
      poisson_ratio: old?.poisson_ratio ?? 0.3,
    };
    const hardening = now?.plasticity ?? this.#before(at, 'hardening')?.plasticity;
    const { over_depth, backstress } = hardening ?? {};
    const { over_depth: _, backstress: __, ...own } = this.#before(at, law)?.plasticity ?? {};
    const plasticity =
      LAWS[law]?.fields.length && own.law
        ? own
        : plasticityLike(law, { ...material, plasticity: hardening }, units);
    if (plasticity && over_depth) plasticity.over_depth = over_depth;
    if (plasticity && backstress) plasticity.backstress = backstress;
    return {
      ...material,
      ...(plasticity && { plasticity }),
      ...(old?.initial_stress && { initial_stress: old.initial_stress }),
      ...(old?.fatigue && { fatigue: old.fatigue }),
    };
  }

  /** @param {Body} body @param {string} kind */
  useOverDepth(body, kind) {
    const at = `/${body}/material/plasticity/over_depth`;
    const { job } = this.draft;
    this.#keep(at, overDepthOf(job[body]?.material));
    this.draft.set(
      at,
      this.#before(at, kind) ?? typicalOverDepth(kind, unitsOf(job)),
      this.source,
    );
  }

  /** @param {Body} body @param {boolean} given */
  useInitialStress(body, given) {
    const at = `/${body}/material/initial_stress`;
    const { job } = this.draft;
    if (!given) this.#keep(at, 'given');
    const stress = given
      ? (this.#before(at, 'given') ?? typicalInitialStress(job, job[body]?.material))
      : undefined;
    this.draft.set(at, stress, this.source);
  }

  #keepLoad() {
    const { load } = this.draft.job;
    if (!isObject(load)) return;
    const kind = loadOf(load);
    this.#keep('/load', kind);
    if (kind === 'target') this.#keep('/load', targetOf(load));
  }

  /** @param {string} kind */
  useLoad(kind) {
    this.#keepLoad();
    const before = this.#before('/load', kind);
    if (kind === 'target') this.useTarget(targetOf(before));
    else this.draft.set('/load', before ?? loadLike(kind, this.draft.job), this.source);
  }

  /** @param {string} figure */
  useTarget(figure) {
    this.#keepLoad();
    const units = unitsOf(this.draft.job);
    const rated = ratedApproach(this.draft.job);
    const { example, quantity } = TARGETS[figure] ?? {};
    const value =
      quantity && quantity !== 'load' ? convert(example, quantity, 'mm_N_MPa', units) : example;
    const load =
      figure === ISO_76.key && rated
        ? { target: { permanent_approach: rated } }
        : (this.#before('/load', figure) ?? { target: { [figure]: value } });
    this.draft.set('/load', load, this.source);
  }
}

/**
 * A load of another kind, as large as the one that a job has.
 * @param {string} kind
 * @param {Job} job
 * @returns {object}
 */
function loadLike(kind, job) {
  const { load: old } = job;
  const units = unitsOf(job);
  // What is no list yet is text as it was typed.
  const inTurn = (/** @type {string} */ key) => (Array.isArray(old?.[key]) ? old[key] : []);
  const last = (/** @type {string} */ key) => numberOf(inTurn(key).at(-1));
  const highest = Math.max(...inTurn('history').map((load) => numberOf(load?.force) || 0));
  const rolled = numberOf(old?.rolling?.force);
  const one = [numberOf(old?.force), last('forces'), highest, rolled].find((force) => force > 0);
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
    rolling: { force },
  });
  return { [kind]: loads[kind] };
}
