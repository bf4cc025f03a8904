/** Stress and plastic strain on both deformed meshes. */

import { h } from '../lib/dom.js';
import { colour, onTheme } from '../lib/theme.js';
import { figure, unit } from '../lib/units.js';
import { Panel } from '../result/panel.js';
import { Camera } from './camera.js';
import { Renderer } from './gl.js';
import { carried } from './locate.js';
import { drawOverlay } from './overlay.js';
import { bands, rgb } from './palette.js';
import { steer } from './pointer.js';
import { QUANTITIES, colourBar, isOdd, rangeOf, readout } from './read.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('./read.js').Quantity} Quantity */
/** @typedef {{name: 'upper' | 'lower', mesh: Mesh, shift: number, polygons: ReturnType<typeof carried>}} Body */

/** Plastic strain below this part of the scale has no colour: nodes beside the zone take a little from its elements. */
const PLAIN = 0.02;
const LOUPE = [0, 1, 2, 5, 10, 20];

export class FieldPanel {
  /** @type {Body[]} */
  #bodies = [];
  /** @type {Quantity} */
  #quantity = 'von_mises';
  #camera = new Camera();
  #deformation = 1;
  #lines = false;
  #frame = 0;
  /** Whether the meshes are to be drawn anew. */
  #stale = true;
  /** @type {[number, number] | null} */
  #probe = null;
  /** @type {{report: Report, at: number} | undefined} */
  #shown;
  /** @type {Renderer | undefined} */
  #renderer;
  /** @type {import('./palette.js').Bands} */
  #bands = bands(0, 1);

  /** @param {() => void} wanted called to solve again with fields */
  constructor(wanted) {
    this.surface = h('canvas', { class: 'surface' });
    this.over = h('canvas', {
      class: 'over',
      tabindex: 0,
      role: 'img',
      'aria-label': 'Stress field',
      'aria-description':
        'Arrows move, plus and minus zoom, 0 goes back; figures of the point in the middle are read out below.',
    });
    this.bar = h('ol', { class: 'colours', 'aria-hidden': 'true' });
    this.readout = h('p', { class: 'readout', role: 'status' });
    this.stage = h('div', { class: 'stage' }, this.surface, this.over, this.bar);
    this.empty = h(
      'div',
      { class: 'empty' },
      h('p', {}, 'This job did not ask for the stress field on the mesh.'),
      h('button', { type: 'button', onclick: wanted }, 'Solve again with it'),
    );
    this.controls = this.#controls();
    this.panel = new Panel('field', 'Field', [this.controls, this.stage, this.readout, this.empty], {
      picture: () => this.picture(),
    });
    steer(this.over, this.#camera, {
      moved: () => this.#later(),
      home: () => this.#home(),
      probe: (at) => {
        this.#probe = at;
        this.#later(false);
      },
    });
    new ResizeObserver(() => this.#fit()).observe(this.stage);
    onTheme(() => this.#later());
    this.surface.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#renderer = undefined;
    });
    this.surface.addEventListener('webglcontextrestored', () => {
      if (this.#shown) this.#load();
    });
  }

  #controls() {
    const quantity = h(
      'select',
      {
        'aria-label': 'Shown',
        onchange: () => {
          this.#quantity = /** @type {Quantity} */ (quantity.value);
          this.#choose();
        },
      },
      Object.entries(QUANTITIES).map(([value, name]) => h('option', { value }, name)),
    );
    const loupe = h(
      'select',
      {
        onchange: () => {
          this.#deformation = Number(loupe.value);
          this.#later();
        },
      },
      LOUPE.map((factor) => h('option', { value: factor, selected: factor === 1 }, `×${factor}`)),
    );
    const lines = h('input', {
      type: 'checkbox',
      onchange: () => {
        this.#lines = lines.checked;
        this.#later();
      },
    });
    const button = (/** @type {string} */ sign, /** @type {string} */ name, /** @type {() => void} */ work) =>
      h(
        'button',
        {
          type: 'button',
          class: 'plain',
          'aria-label': name,
          title: name,
          onclick: () => {
            work();
            this.#later();
          },
        },
        sign,
      );
    return h(
      'div',
      { class: 'bar tools' },
      quantity,
      h('label', { title: 'Above ×1 the two pictures overlap where the bodies touch' }, 'Displacement ', loupe),
      h('label', {}, lines, ' Mesh'),
      h(
        'span',
        { class: 'group' },
        button('−', 'Zoom out', () => this.#camera.zoom(0.8)),
        button('+', 'Zoom in', () => this.#camera.zoom(1.25)),
        button('⌂', 'Whole contact', () => this.#home()),
      ),
    );
  }

  /** @param {Report} report @param {number} at */
  show(report, at) {
    const step = report.steps[at];
    const there = Boolean(step.fields?.upper ?? step.fields?.lower);
    this.panel.show(true);
    this.stage.hidden = this.readout.hidden = this.controls.hidden = !there;
    this.empty.hidden = there;
    const before = this.#shown;
    this.#shown = { report, at };
    if (!there) return;
    performance.mark('field-received');
    this.#bodies = /** @type {const} */ (['upper', 'lower']).flatMap((name) => {
      const mesh = step.fields?.[name];
      const zone = step.plasticity[name];
      return mesh
        ? [
            {
              name,
              mesh,
              shift: name === 'upper' ? -step.approach : 0,
              polygons: carried(zone?.outline ?? [], mesh, name === 'upper' ? 1 : -1, report.mesh.symmetric),
            },
          ]
        : [];
    });
    this.#load();
    this.#fit();
    if (before?.report !== report) this.#home();
  }

  /** @returns {Promise<Blob | null>} */
  async picture() {
    if (!this.#renderer) return null;
    const copy = h('canvas', { width: this.surface.width, height: this.surface.height });
    const context = copy.getContext('2d');
    if (!context) return null;
    this.#draw();
    context.fillStyle = colour('--panel');
    context.fillRect(0, 0, copy.width, copy.height);
    context.drawImage(this.surface, 0, 0);
    context.drawImage(this.over, 0, 0);
    return new Promise((resolve) => copy.toBlob(resolve));
  }

  #load() {
    const gl = this.#renderer?.gl ?? this.surface.getContext('webgl2', { antialias: false });
    if (!gl) {
      this.readout.textContent = 'This browser has no WebGL2. The field can be downloaded as VTU.';
      return;
    }
    this.#renderer ??= new Renderer(gl);
    this.#renderer.load(this.#bodies);
    this.#choose();
  }

  /** Puts the values of the chosen quantity on the meshes and their limits beside them. */
  #choose() {
    const mirrored = this.#shown?.report.mesh.symmetric ?? false;
    const meshes = this.#bodies.map(({ mesh }) => mesh);
    const [low, high] = rangeOf(meshes, this.#quantity, mirrored);
    const signed = this.#quantity.startsWith('sigma') || this.#quantity === 'tau_xy';
    this.#bands = bands(signed ? low : 0, high > low ? high : low + 1);
    this.#renderer?.choose(this.#quantity);
    this.bar.replaceChildren(...colourBar(this.#bands, this.#unit()));
    this.over.setAttribute(
      'aria-label',
      `Field of ${QUANTITIES[this.#quantity]}, from ${figure(low, 4)} to ${figure(high, 4)} ${this.#unit()}.`,
    );
    this.#later();
  }

  #unit() {
    return this.#shown && this.#quantity !== 'equivalent_plastic_strain'
      ? unit('stress', this.#shown.report.units)
      : '';
  }

  #home() {
    const contact = this.#step()?.contact;
    if (contact) this.#camera.home(1.9 * contact.half_width || 1);
    this.#later();
  }

  #step() {
    return this.#shown?.report.steps[this.#shown.at];
  }

  #fit() {
    const [width, height] = [this.stage.clientWidth, this.stage.clientHeight];
    if (!width || !height) return;
    const first = this.#camera.width === 1;
    this.#camera.scale *= width / this.#camera.width;
    Object.assign(this.#camera, { width, height });
    for (const canvas of [this.surface, this.over]) {
      canvas.width = Math.round(width * devicePixelRatio);
      canvas.height = Math.round(height * devicePixelRatio);
    }
    if (first) this.#home();
    else this.#draw();
  }

  /** @param {boolean} [meshes] whether more has changed than what lies over them */
  #later(meshes = true) {
    this.#stale ||= meshes;
    this.#frame ||= requestAnimationFrame(() => {
      this.#frame = 0;
      this.#draw(this.#stale);
    });
  }

  #draw(meshes = true) {
    const step = this.#step();
    if (!this.#renderer || !step || !this.#shown || this.stage.hidden) return;
    const { report } = this.#shown;
    if (meshes) this.#drawMeshes(this.#renderer, report);
    drawOverlay(this.over, {
      camera: this.#camera,
      deformation: this.#deformation,
      zones: this.#bodies,
      ends: step.contact.patches
        .flatMap(({ left, right }) =>
          report.analysis === 'axisymmetric' ? [left, right, -left, -right] : [left, right],
        )
        .filter((x) => x !== 0),
      cross: this.#probe,
      length: unit('length', report.units),
    });
    this.#read(report);
    performance.mark('field-drawn');
  }

  /** @param {Renderer} renderer @param {Report} report */
  #drawMeshes(renderer, report) {
    this.#stale = false;
    const strain = this.#quantity === 'equivalent_plastic_strain';
    const { low, step: width, colours } = this.#bands;
    renderer.draw({
      camera: this.#camera,
      bands: this.#bands,
      deformation: this.#deformation,
      mirrored: report.mesh.symmetric,
      odd: isOdd(this.#quantity),
      lines: this.#lines,
      floor: strain ? PLAIN * (low + width * colours.length) : -Infinity,
      plain: rgb(colour('--metal')),
    });
  }

  /** Says what is under the probe. @param {Report} report */
  #read(report) {
    this.readout.textContent = this.#probe
      ? readout(this.#bodies, report, this.#deformation, this.#camera.toWorld(...this.#probe))
      : `${matchMedia('(pointer: coarse)').matches ? 'Tap the field for its figures; two fingers move and zoom it' : 'Point at the field for its figures; drag to move; click, then scroll to zoom'}. White line: plastic zone.`;
  }
}
