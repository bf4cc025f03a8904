/**
 * What the page works with: the types of the wire, and what it makes of them.
 *
 * @typedef {Record<string, any>} Job a job as it is typed: possibly wrong, the service says where
 *
 * @typedef {import('./wire.js').JobState} JobState
 * @typedef {import('./wire.js').Job} JobDocument
 * @typedef {import('./wire.js').Iteration} Iteration
 * @typedef {Exclude<keyof Iteration, 'increment'>} IterationFigure those that are numbers
 * @typedef {import('./wire.js').Subsurface} Profile
 * @typedef {import('./wire.js').PlasticZone} Zone
 *
 * @typedef {'von_mises' | 'equivalent_plastic_strain' | 'sigma_x' | 'sigma_y' | 'sigma_z' |
 *   'tau_xy'} Scalar
 *
 * @typedef {object} Shape of one body
 * @property {Float32Array} nodes
 * @property {Float32Array} displacement
 * @property {Uint32Array} elements four corners of each, counter-clockwise
 *
 * @typedef {Shape & Partial<Record<Scalar, Float32Array>>} Mesh fields of one body, packed by the
 *   worker; the scalars that have been fetched
 *
 * @typedef {object} Made members of a step that the page makes of those of the wire
 * @property {{force?: number, approach?: number}} load
 * @property {{upper: Mesh | null, lower: Mesh | null}} [fields]
 *
 * @typedef {Omit<import('./wire.js').Step, 'load' | 'fields'> & Made} Step
 *
 * @typedef {object} Shaped members of a report that the page makes of those of the wire
 * @property {import('./lib/units.js').Units | import('./lib/units.js').UnitSet} units of the job,
 *   or those it is shown in
 * @property {Step[]} steps
 *
 * @typedef {Omit<import('./wire.js').Report, 'units' | 'steps'> & Shaped} Report
 */

export {};
