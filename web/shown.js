/**
 * A solved job among those that are looked at.
 *
 * @typedef {object} Shown
 * @property {string} id
 * @property {string} label
 * @property {string} colour custom property
 * @property {number[]} [dash] of its curves
 * @property {boolean} [removed] whether the service no longer has it
 * @property {import('./types.js').Report} [raw] the report in the units of its job
 * @property {import('./field/source.js').FieldSource | import('./field/layers.js').LayerSource}
 *   [fields] of the job, if it asked for them and they are not in the report
 * @property {import('./types.js').Job} job
 * @property {import('./types.js').Report} report
 */

export {};
