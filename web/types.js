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
 * @typedef {object} Mesh fields of one body, packed by the worker
 * @property {Float32Array} nodes
 * @property {Float32Array} displacement
 * @property {Uint32Array} elements four corners of each, counter-clockwise
 * @property {Float32Array} von_mises
 * @property {Float32Array} equivalent_plastic_strain
 * @property {Float32Array} sigma_x
 * @property {Float32Array} sigma_y
 * @property {Float32Array} sigma_z
 * @property {Float32Array} tau_xy
 *
 * @typedef {object} Made members of a step that the page makes of those of the wire
 * @property {{force?: number, approach?: number}} load
 * @property {{upper: Mesh | null, lower: Mesh | null}} [fields]
 *
 * @typedef {Omit<import('./wire.js').Step, 'load' | 'fields'> & Made} Step
 *
 * @typedef {object} Shaped members of a report that the page makes of those of the wire
 * @property {import('./lib/units.js').Units | import('./lib/units.js').UnitSet} units of the job, or those it is shown in
 * @property {Step[]} steps
 *
 * @typedef {Omit<import('./wire.js').Report, 'units' | 'steps'> & Shaped} Report
 *
 * @typedef {object} Shown a solved job among those that are looked at
 * @property {string} id
 * @property {string} label
 * @property {string} colour custom property
 * @property {number[]} [dash] of its curves
 * @property {Report} [raw] the report in the units of its job
 * @property {import('./field/source.js').FieldSource} [fields] of the job, if it asked for them and they are not in the report
 * @property {Job} job
 * @property {Report} report
 */

export {};
