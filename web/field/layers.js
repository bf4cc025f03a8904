/**
 * Sections through the layers of half-spaces, as meshes: two planes of a contact in three
 * dimensions, through the place that its sentence is about, are looked at with the tools of plane
 * ones. Layers are fetched whole, a step at a time, and only both planes of them are kept.
 */

import { fetchFields } from '../api/result.js';
import { through } from '../result/answers.js';
import { alongJob, axesOf } from '../result/axes.js';

/** @typedef {import('../types.js').Mesh} Mesh */
/** @typedef {import('../types.js').Report} Report */
/** @typedef {import('./source.js').Fields} Fields */
/** @typedef {'x' | 'y'} Axis along which a section lies */
/** @typedef {Record<string, ArrayLike<number>>} Layers of one body */

/** Numbers of both bodies, of all steps that are fetched to have the same colours. */
const FEW = 6e6;

/** Arrays of the plane along x and of that along y by their names in a section. @type {Record<Axis, Record<string, string>>} */
const NAMES = {
  x: { sigma_x: 'sigma_xx', sigma_y: 'sigma_zz', sigma_z: 'sigma_yy', tau_xy: 'sigma_xz' },
  y: { sigma_x: 'sigma_yy', sigma_y: 'sigma_zz', sigma_z: 'sigma_xx', tau_xy: 'sigma_yz' },
};
const SAME = ['von_mises', 'equivalent_plastic_strain'];

export class LayerSource {
  /** By step. @type {Map<number, Record<Axis, Fields>>} */
  #steps = new Map();
  /** What was asked for last. @type {Promise<unknown>} */
  #last = Promise.resolve();

  /** @param {string} id of a job @param {Report} report */
  constructor(id, { steps, mesh }) {
    this.id = id;
    this.steps = steps;
    /** Whether every step is fetched. */
    this.whole = steps.length * mesh.elements * 15 < FEW;
    this.axes = axesOf(steps[0]);
    this.planes = { x: this.#plane('x'), y: this.#plane('y') };
  }

  /** @param {Axis} axis */
  #plane(axis) {
    return {
      whole: this.whole,
      peek: (/** @type {number} */ step) => this.#steps.get(step)?.[axis],
      get: async (
        /** @type {number} */ step,
        /** @type {unknown} */ _names,
        /** @type {((received: number, total: number) => void) | undefined} */ progress,
      ) => (await this.#get(step, progress))[axis],
      close: () => {},
    };
  }

  /** @param {number} step @param {(received: number, total: number) => void} [progress] */
  #get(step, progress) {
    const next = this.#last
      .catch(() => {})
      .then(async () => {
        const kept = this.#steps.get(step);
        if (kept) return kept;
        const layers = /** @type {any} */ (await fetchFields(this.id, step, [], { progress }));
        const made = planesOf(layers, this.axes, through(this.steps[step]));
        this.#steps.set(step, made);
        return made;
      });
    this.#last = next;
    return next;
  }

  /** Gives everything back, when another job is looked at. */
  close() {
    this.#steps.clear();
  }
}

/** @param {Record<'upper' | 'lower', Layers | null>} layers of both bodies @param {import('../result/axes.js').Axes} [axes] of the contact @param {{x: number, y: number}} [place] that both go through @returns {Record<Axis, Fields>} along the axes of the contact, in the directions of the job's */
export const planesOf = ({ upper, lower }, axes, place) => {
  const plane = (/** @type {Axis} */ axis) => {
    const at = place?.[axis === 'x' ? 'y' : 'x'];
    return {
      upper: upper && section(upper, axis, 1, axes?.[axis].sign, at),
      lower: lower && section(lower, axis, -1, axes?.[axis].sign, at),
    };
  };
  return { x: plane('x'), y: plane('y') };
};

/** The cells on both sides of a plane, or those in it. @param {ArrayLike<number>} across @param {number} [at] @returns {number[]} */
function cellsAt(across, at) {
  if (!at) return [across.length - 1, across.length].map((twice) => twice >> 1);
  const nearest = Array.from(across).reduce(
    (best, place, k) => (Math.abs(place - at) < Math.abs(across[best] - at) ? k : best),
    0,
  );
  return [nearest, nearest];
}

/**
 * Nodes are the middles of the cells; the surface has the values of the first layer.
 * @param {Layers} layers @param {Axis} axis @param {1 | -1} up where depth points in the picture @param {1 | -1} [way] whether the axis runs as that of the job @param {number} [place] of the section @returns {Mesh}
 */
function section({ x, y, z, ...arrays }, axis, up, way = 1, place = undefined) {
  const [given, across] = axis === 'x' ? [x, y] : [y, x];
  const along = way > 0 ? given : Array.from(given, (place) => -place).reverse();
  const [many, rows] = [along.length, z.length + 1];
  const [before, behind] = cellsAt(across, place);
  const nodes = new Float32Array(2 * many * rows);
  const elements = new Uint32Array(4 * (many - 1) * (rows - 1));
  for (let row = 0; row < rows; row++)
    for (let k = 0; k < many; k++)
      nodes.set([along[k], row ? up * z[row - 1] : 0], 2 * (row * many + k));
  let at = 0;
  for (let row = 0; row + 1 < rows; row++)
    for (let k = 0; k + 1 < many; k++) {
      const [one, other] = [row * many + k, (row + 1) * many + k];
      const corners = up > 0 ? [one, one + 1, other + 1, other] : [other, other + 1, one + 1, one];
      elements.set(corners, at);
      at += 4;
    }
  const values = (/** @type {ArrayLike<number>} */ of, sign = 1) => {
    const made = new Float32Array(many * rows);
    const cell = (/** @type {number} */ layer, /** @type {number} */ k, /** @type {number} */ l) =>
      of[
        axis === 'x'
          ? (layer * many + k) * across.length + l
          : (layer * across.length + l) * many + k
      ];
    for (let row = 0; row < rows; row++)
      for (let k = 0; k < many; k++) {
        const layer = Math.max(0, row - 1);
        const at = way > 0 ? k : many - 1 - k;
        made[row * many + k] = (sign * (cell(layer, at, before) + cell(layer, at, behind))) / 2;
      }
    return made;
  };
  const mesh = /** @type {any} */ ({
    nodes,
    elements,
    displacement: new Float32Array(2 * many * rows),
  });
  for (const name of SAME) mesh[name] = values(arrays[name]);
  mesh.outline = outlineOf(mesh, many, rows);
  // z points into each body; shear is that of the section, upward.
  for (const [name, own] of Object.entries(NAMES[axis]))
    mesh[name] = values(arrays[own], name === 'tau_xy' ? up * way : 1);
  return mesh;
}

/**
 * Lines between nodes that have yielded and nodes that have not.
 * @param {Record<string, ArrayLike<number>>} mesh @param {number} many nodes to a row @param {number} rows
 */
function outlineOf({ nodes, equivalent_plastic_strain: strain }, many, rows) {
  const between = (/** @type {number} */ a, /** @type {number} */ b) => ({
    x: (nodes[2 * a] + nodes[2 * b]) / 2,
    y: (nodes[2 * a + 1] + nodes[2 * b + 1]) / 2,
    u: 0,
    v: 0,
  });
  const lines = [];
  for (let row = 0; row + 1 < rows; row++)
    for (let k = row * many; k + 1 < (row + 1) * many; k++) {
      const corners = [k, k + 1, k + 1 + many, k + many];
      const ends = corners.flatMap((a, n) => {
        const b = corners[(n + 1) % 4];
        return strain[a] > 0 === strain[b] > 0 ? [] : [between(a, b)];
      });
      for (let n = 0; n < ends.length; n += 2) lines.push(ends.slice(n, n + 2));
    }
  return lines;
}

/** A report as that of the section: its contact lies along the section, and its bodies are whole. @param {Report} report @param {Axis} axis of the contact @returns {Report} */
export const reportOf = (report, axis) => {
  const axes = axesOf(report.steps[0]);
  const { name } = axes[axis];
  return {
    ...report,
    analysis: /** @type {any} */ (`section_${name}`),
    mesh: { ...report.mesh, symmetric: false },
    steps: report.steps.map((step) => {
      const { section, ...contact } = step.contact;
      // The section has a zone of its own.
      const still = { ...step, plasticity: { upper: null, lower: null } };
      const layers = /** @type {any} */ (step.layers);
      const fields = layers && planesOf(layers, axes, through(step))[axis];
      if (!section) return { ...still, fields };
      const { y, pressure } = section;
      const own = axis === 'x' ? contact.nodes : { x: y, pressure };
      const { x: places, y: values } = alongJob(own.x, own.pressure, axes[axis]);
      const touching = places.filter((_, k) => values[k] > 0);
      const patches = touching.length
        ? [{ left: touching[0], right: touching[touching.length - 1] }]
        : [];
      return {
        ...still,
        fields,
        contact: {
          ...contact,
          patches: axis === 'x' && axes.x.sign > 0 ? contact.patches : patches,
          nodes: { ...contact.nodes, x: places },
        },
      };
    }),
  };
};
