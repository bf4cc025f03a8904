/**
 * Both bodies as they are drawn: meshes in colours, what lies over them, and the cut-out that is
 * seen.
 */

import { h } from '../lib/dom.js';
import { colour, onTheme } from '../lib/theme.js';
import { figureOf } from '../lib/digits.js';
import { factor, unit } from '../lib/units.js';
import { Camera } from './camera.js';
import { withoutLoad } from './cut.js';
import { Renderer } from './gl.js';
import { axesOf } from '../result/axes.js';
import { extentSeen } from '../result/extent.js';
import { approachIn, boundOf, peakIn } from '../result/rows.js';
import { frameOf } from './frame.js';
import { carried, locateAll, vectorAt } from './locate.js';
import { lifts, surfaceOf } from './lift.js';
import { drawOverlay } from './overlay.js';
import { bands, rgb } from './palette.js';
import { compose } from './picture.js';
import { nameOf, parityOf, valuesOf } from './quantities.js';
import { scaleOf } from './read.js';

/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('../types.js').Step} Step */
/** @typedef {import('./quantities.js').Quantity} Quantity */
/** @typedef {import('./read.js').Body & {frame: Frame, polygons: ReturnType<typeof carried>}} Body */
/** @typedef {import('./frame.js').Frame} Frame */
/** @typedef {import('./source.js').Fields} Fields */
/** @typedef {import('../types.js').Job} Job */
/** @typedef {{job: Job, report: Report, at: number, yields: boolean, units: import('../lib/units.js').UnitSet}} Asked a step, in the units of its job, whether a body yields in it, and the units that are shown */

/**
 * Plastic strain below this part of the scale has no colour: nodes beside the zone take a little
 * from its elements.
 */
const PLAIN = 0.02;
/** Answers of quantities, and how their places are marked. @type {Partial<Record<Quantity, [answer: string, end: 'max' | 'tension']>>} */
const SAID = {
  equivalent_plastic_strain: ['max_plastic_strain', 'max'],
  sigma_x: ['residual_tension', 'tension'],
};

export class Scene {
  /** What is drawn. @type {Asked | undefined} */
  shown;
  /** @type {Body[]} */
  bodies = [];
  /** Quantity that is drawn. @type {Quantity} */
  quantity = 'von_mises';
  camera = new Camera();
  deformation = 1;
  lines = false;
  isolines = false;
  /** Place under the pointer, in pixels. @type {[number, number] | null} */
  probe = null;
  /** Colours, in the units shown. @type {import('./palette.js').Bands} */
  bands = bands(0, 1);
  /** Largest and least value, which are marked. @type {import('./read.js').Extreme[]} */
  ends = [];
  #frame = 0;
  /** Whether the meshes are to be drawn anew. */
  #stale = true;
  /** @type {Renderer | undefined} */
  #renderer;
  /** @type {(deformation: number) => import('./lift.js').Lifts} */
  #lifts = () => ({ upper: 0, lower: 0, contact: 0, unloaded: 0 });

  /** Of the body that the ends of the contact are drawn on. @type {ReturnType<typeof surfaceOf>} */
  #surface = () => undefined;

  /**
   * @param {import('./cut-tool.js').CutTool} cutter
   * @param {Node} bar scale of the colours
   * @param {{drawn: (scales: import('./read.js').Scales) => void, lost: () => void, restored: () => void}} on
   */
  constructor(cutter, bar, on) {
    this.cutter = cutter;
    this.on = on;
    this.surface = h('canvas', { class: 'surface' });
    this.over = h('canvas', {
      class: 'over',
      tabindex: 0,
      role: 'img',
      'aria-label': 'Stress field',
      'aria-description':
        'Arrows move, plus and minus zoom, 0 goes back; figures of the point in the middle are read out below.',
    });
    this.stage = h('div', { class: 'stage' }, this.surface, this.over, bar);
    new ResizeObserver(() => this.fit()).observe(this.stage);
    onTheme(() => this.later());
    this.surface.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#renderer = undefined;
      on.lost();
    });
    this.surface.addEventListener('webglcontextrestored', () => on.restored());
  }

  /** Gives back the room of what was drawn. */
  forget() {
    this.shown = undefined;
    this.bodies = [];
    this.#renderer?.load([]);
  }

  /** @param {Fields} fields of the step that is shown */
  take(fields) {
    const step = this.#step();
    if (!this.shown || !step) return;
    const { job, report } = this.shown;
    const framed = bodiesOf(report, step, fields).map((body) => ({
      ...body,
      frame: frameOf(job, body.name, body.mesh),
    }));
    const [upper, lower] = ['upper', 'lower'].map(
      (name) => framed.find((body) => body.name === name) ?? null,
    );
    this.#lifts = lifts(upper, lower, step.contact.nodes.x, peakIn(step), loweredBy(report, step));
    const body = lower ?? upper;
    if (body) this.#surface = surfaceOf(body, step.contact.nodes.x);
    this.bodies = framed.map((body) => ({
      ...body,
      polygons:
        /** @type {any} */ (body.mesh).outline ??
        carried(step.plasticity?.[body.name]?.outline ?? [], body, report.mesh.symmetric),
    }));
    this.#place();
  }

  /** Raises the bodies so that they do not overlap. */
  #place() {
    const lifted = this.#lifts(this.deformation);
    for (const body of this.bodies) body.lift = lifted[body.name];
  }

  /** @param {number} times of the displacements */
  exaggerate(times) {
    this.deformation = times;
    this.#place();
  }

  /** Gives the meshes to the graphics. @returns {boolean} whether there are any */
  load() {
    const gl = this.#renderer?.gl ?? this.surface.getContext('webgl2', { antialias: false });
    if (!gl) return false;
    this.#renderer ??= new Renderer(gl);
    this.#renderer.load(this.bodies);
    return true;
  }

  /** Puts the values of a quantity on the meshes. @param {Quantity} quantity */
  choose(quantity) {
    this.quantity = quantity;
    this.#renderer?.choose((mesh, moved) => valuesOf(mesh, quantity, moved));
  }

  /** What the answers say of the quantity that is drawn, at its place. @returns {import('./read.js').Extreme | undefined} */
  said() {
    const [answer, end] = SAID[this.quantity] ?? [];
    const found = this.#step()?.answers?.find(({ name, place }) => name === answer && place);
    if (!this.shown || !end || !found?.place || !found.value) return undefined;
    const { place, value } = found;
    const body = this.bodies.find(({ name }) => place.body === 'both' || name === place.body);
    const axes = axesOf(/** @type {import('../types.js').Step} */ (this.#step()));
    const axis = this.shown.report.analysis === `section_${axes.y.name}` ? 'y' : 'x';
    const along = axes[axis].sign * (place[axis] ?? 0);
    const at = body?.frame.point(along, place.depth);
    const there = body && at && locateAll(body.mesh, [at])[0];
    if (!body || !at || !there) return undefined;
    const [u, v] = vectorAt(there, body.mesh.displacement);
    return { end, value, error: boundOf(found), name: body.name, x: at[0], y: at[1], u, v };
  }

  /** Of the quantity that is drawn. */
  scale() {
    return scaleOf(this.quantity, this.scales());
  }

  /** @returns {import('./read.js').Scales} */
  scales() {
    if (!this.shown) throw new Error('nothing is shown');
    const { report, units } = this.shown;
    const own = /** @type {import('../lib/units.js').Units} */ (report.units);
    return {
      analysis: report.analysis,
      symmetric: report.mesh.symmetric,
      own,
      units,
      length: factor('length', own, units),
      stress: factor('stress', own, units),
    };
  }

  /**
   * Where the contact is, and half of its width; where the load is taken away, those of the widest
   * one, whose traces are to be seen. `drawn`: its height in the picture; `unloaded`: in the
   * bodies without load.
   */
  contact() {
    const { contact: drawn, unloaded } = this.#lifts(this.deformation);
    const extent =
      this.shown && extentSeen(this.shown.report.steps, this.shown.at, this.#isRound());
    const { left, right } = extent ?? { left: -1 / 1.9, right: 1 / 1.9 };
    return { x: (left + right) / 2, half: (right - left) / 2, drawn, unloaded };
  }

  /** @param {number} [least] width to be seen at least, in the units shown */
  home(least = 0) {
    const { x, drawn } = this.contact();
    const half = Math.max(this.reach, least) / (this.shown ? this.scales().length : 1);
    if (this.shown) this.camera.home(1.9 * half, x, drawn);
    this.later();
  }

  /** Half of the contact's width, in the units shown. */
  get reach() {
    return this.shown ? this.contact().half * this.scales().length : 0;
  }

  /** Looks at the same part of its contact as another scene does. @param {Scene} other */
  match(other) {
    if (!this.shown || !other.shown) return;
    const [own, its] = [this.contact(), other.contact()];
    const times = other.scales().length / this.scales().length;
    this.camera.scale = other.camera.scale / times;
    this.camera.x = own.x + (other.camera.x - its.x) * times;
    this.camera.y = own.drawn + (other.camera.y - its.drawn) * times;
    this.later();
  }

  #isRound() {
    return this.shown?.report.analysis === 'axisymmetric';
  }

  #step() {
    return this.shown?.report.steps[this.shown.at];
  }

  /** Where a place of the picture is in the bodies without load. @param {[number, number]} at in pixels */
  withoutLoad(at) {
    const mirrored = this.shown?.report.mesh.symmetric ?? false;
    return withoutLoad(this.bodies, this.deformation, mirrored, this.camera.toWorld(...at));
  }

  fit() {
    const [width, height] = [this.stage.clientWidth, this.stage.clientHeight];
    if (!width || !height) return;
    const first = this.camera.width === 1;
    this.camera.scale *= width / this.camera.width;
    Object.assign(this.camera, { width, height });
    const [pixels, lines] = [width, height].map((size) => Math.round(size * devicePixelRatio));
    if (first) this.home();
    if (this.surface.width === pixels && this.surface.height === lines) return;
    // A canvas that is given its size is made anew, and empty.
    for (const canvas of [this.surface, this.over])
      Object.assign(canvas, { width: pixels, height: lines });
    if (!first) this.#draw();
  }

  /** @param {boolean} [meshes] whether more has changed than what lies over them */
  later(meshes = true) {
    this.#stale ||= meshes;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#draw(this.#stale);
    });
  }

  /** @param {string} title @param {(name: string) => string} colours of the page, or of paper @returns {HTMLCanvasElement | null} the field with its scale of colours */
  picture(title, colours) {
    if (
      !this.#renderer ||
      !this.#step() ||
      this.stage.hidden ||
      this.stage.classList.contains('stale')
    )
      return null;
    this.#draw(true, colours);
    // The page has its own colours again.
    this.later();
    const { unit: name } = this.scale();
    return compose([this.surface, this.over], this.bands, {
      title,
      quantity: `${nameOf(this.quantity, this.shown?.report.analysis ?? '')}${name ? ` [${name}]` : ''}${
        this.deformation === 1 ? '' : `, displacements ×${this.deformation}`
      }`,
      colours,
    });
  }

  #draw(meshes = true, colours = colour) {
    const step = this.#step();
    if (!this.#renderer || !step || !this.shown || !this.bodies.length || this.stage.hidden)
      return;
    const { report } = this.shown;
    const scales = this.scales();
    const { factor: times, unit: name } = this.scale();
    if (meshes) this.#drawMeshes(this.#renderer, report, colours);
    if (meshes || this.cutter.stale)
      this.cutter.read(this.bodies, this.deformation, {
        quantity: this.quantity,
        mirrored: report.mesh.symmetric,
        scales,
      });
    drawOverlay(this.over, {
      camera: this.camera,
      deformation: this.deformation,
      zones: this.bodies,
      edges: this.#edges(step),
      cross: this.probe,
      ends: this.ends.map((end) => ({
        ...end,
        lift: this.bodies.find(({ name }) => name === end.name)?.lift ?? 0,
        text: `${end.end} ${figureOf(end.value * times, end.error)} ${name}`,
      })),
      path: this.cutter.path,
      colours,
      length: unit('length', scales.units),
      factor: scales.length,
    });
    this.on.drawn(scales);
    performance.mark('field-drawn');
  }

  /** Ends of the parts of the contact where they are drawn on one of the bodies. @param {Step} step @returns {import('./overlay.js').Over['edges']} */
  #edges({ contact: { patches } }) {
    const [{ frame, lift }] = this.bodies.slice(-1);
    const halved = this.shown?.report.mesh.symmetric;
    const ends = patches.flatMap(({ left, right }) =>
      this.#isRound() ? [left, right, -left, -right] : [left, right],
    );
    return ends.flatMap((along) => {
      const side = halved && along < 0 ? -1 : 1;
      const end = along === 0 ? undefined : this.#surface(side * along);
      if (!end) return [];
      const at = /** @type {[number, number]} */ ([
        side * (end.x + this.deformation * end.u),
        end.y + this.deformation * end.v + lift,
      ]);
      return [{ at, across: frame.outward(along) }];
    });
  }

  /** @param {Renderer} renderer @param {Report} report @param {(name: string) => string} colours */
  #drawMeshes(renderer, report, colours) {
    this.#stale = false;
    const strain = this.quantity === 'equivalent_plastic_strain';
    const { factor: times } = this.scale();
    const { low, step, colours: swatches } = this.bands;
    renderer.draw({
      camera: this.camera,
      bands: { low: low / times, step: step / times, colours: swatches },
      deformation: this.deformation,
      mirrored: report.mesh.symmetric,
      odd: parityOf(this.quantity, report.analysis, -1) < 0,
      lines: this.lines,
      isolines: this.isolines,
      floor: strain ? (PLAIN * (low + step * swatches.length)) / times : -Infinity,
      plain: rgb(colours('--metal')),
    });
  }
}

/** How far the upper body is lowered; in a section of half-spaces both surfaces are where they touch. @param {Report} report @param {Step} step */
const loweredBy = ({ analysis }, step) => (analysis.startsWith('section') ? 0 : approachIn(step));

/** @param {Report} report @param {Step} step @param {Fields} fields @returns {import('./read.js').Body[]} */
export const bodiesOf = (report, step, fields) =>
  /** @type {const} */ (['upper', 'lower']).flatMap((name) => {
    const mesh = fields[name];
    return mesh
      ? [{ name, mesh, lift: 0, moved: name === 'upper' ? -loweredBy(report, step) : 0 }]
      : [];
  });
