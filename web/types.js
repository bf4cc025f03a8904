/**
 * Shapes of what goes over the wire, as far as the page looks at it.
 *
 * @typedef {Record<string, any>} Job a job as it is typed: possibly wrong, the service says where
 *
 * @typedef {'queued' | 'running' | 'succeeded' | 'not_converged' | 'failed' | 'cancelled' | 'timed_out'} JobState
 *
 * @typedef {object} JobDocument
 * @property {string} id
 * @property {JobState} status
 * @property {number} [queue_position]
 * @property {boolean} cancel_requested
 * @property {string} created_at
 * @property {string | null} started_at
 * @property {string | null} finished_at
 * @property {Record<string, string>} [tags]
 * @property {{iterations: number, latest: Iteration | null}} progress
 * @property {{title: string, detail: string, errors?: {pointer: string, detail: string}[]}} [error]
 *
 * @typedef {object} Iteration
 * @property {number} iteration
 * @property {number} contact_pivots
 * @property {number} initial_stress_updates
 * @property {number} factorizations
 * @property {number} displacement_change
 * @property {number} force_change
 * @property {number} equilibrium_residual
 * @property {number} plastic_points
 * @property {number} contact_pairs
 * @property {number} approach
 * @property {number} peak_pressure
 * @property {number} elapsed_ms
 *
 * @typedef {object} Profile stresses over depth
 * @property {number[]} depth
 * @property {number[]} sigma_x
 * @property {number[]} sigma_y
 * @property {number[]} sigma_z
 * @property {number[]} tau_max
 * @property {number[]} von_mises
 * @property {number[]} equivalent_plastic_strain
 *
 * @typedef {object} Zone
 * @property {boolean} yielded
 * @property {number} max_equivalent_plastic_strain
 * @property {number} position
 * @property {number} depth
 * @property {number} area
 * @property {boolean} reached_surface
 * @property {[number, number][][]} outline
 *
 * @typedef {object} Mesh fields of one body, packed by the worker
 * @property {Float32Array} nodes
 * @property {Float32Array} displacement
 * @property {Uint32Array} triangles
 * @property {Float32Array} von_mises
 * @property {Float32Array} equivalent_plastic_strain
 * @property {Float32Array} sigma_x
 * @property {Float32Array} sigma_y
 * @property {Float32Array} sigma_z
 * @property {Float32Array} tau_xy
 *
 * @typedef {object} Step
 * @property {{force?: number, approach?: number}} load
 * @property {string} status
 * @property {number} approach
 * @property {string} approach_datum
 * @property {{force: number, half_width: number, peak_pressure: number, peak_position: number, mean_pressure: number,
 *   patches: {left: number, right: number}[],
 *   nodes: {x: number[], pressure: number[], force: number[], gap: number[]}}} contact
 * @property {number} contact_stiffness
 * @property {{upper: Profile | null, lower: Profile | null}} [subsurface]
 * @property {{upper: Zone | null, lower: Zone | null}} plasticity
 * @property {{half_width: number, peak_pressure: number, yield_onset_force: number | null, yield_onset_depth: number | null} | null} hertz
 * @property {{force: number, approach: number, peak_pressure: number, body: string, position: number, depth: number}} [yield_onset]
 * @property {{code: string, message: string}[]} validity
 * @property {{peak_pressure: number, half_width: number, approach: number} | null} estimated_error
 * @property {{upper: Mesh | null, lower: Mesh | null}} [fields]
 * @property {Iteration[]} history
 * @property {Flow} [flow] what only flow theory knows
 *
 * @typedef {object} Surface of one body near the contact, heights outward from the undeformed one
 * @property {number[]} x
 * @property {number[]} height
 * @property {number} depth
 * @property {number} pile_up
 * @property {boolean} yielded_in_reverse
 *
 * @typedef {object} Flow
 * @property {number} unloading_stiffness
 * @property {{work: number, dissipated: number}} energy
 * @property {{upper: Surface | null, lower: Surface | null}} surfaces
 *
 * @typedef {object} Report
 * @property {import('./lib/units.js').Units | import('./lib/units.js').UnitSet} units of the job, or those it is shown in
 * @property {string} analysis
 * @property {string} status
 * @property {Step[]} steps
 * @property {{force: number[], approach: number[], stiffness: number[]}} [load_approach]
 * @property {{symmetric: boolean, spacing: number, elements: number, equations: number, passes: number}} mesh
 * @property {Record<string, number>} timings_ms
 * @property {string} version of the program
 * @property {Record<string, string>} [tags]
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
