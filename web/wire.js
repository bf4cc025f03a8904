/**
 * What goes over the wire: the schemas of the OpenAPI document that the page names, and those that
 * they refer to. Generated from it: `BRINELL_WRITE=1 cargo test --test openapi`.
 *
 * @typedef {'plane_strain' | 'plane_stress' | 'axisymmetric' | 'three_dimensional'} Analysis
 *
 * @typedef {object} Answer
 * @property {AnswerAt} [at]
 * @property {number} [at_least]
 * @property {number} [at_most]
 * @property {AnswerBody | null} body
 * @property {boolean} detail
 * @property {number | null} elastic
 * @property {ErrorBar} error
 * @property {string} label
 * @property {string} name
 * @property {AnswerPlace | null} place
 * @property {AnswerQuantity} quantity
 * @property {string} [reason]
 * @property {string} text
 * @property {string} unit
 * @property {number | null} value
 *
 * @typedef {object} AnswerAt
 * @property {FatigueCriterion} [criterion]
 * @property {SolvedHardening} [hardening]
 * @property {number} [load]
 * @property {number} [pass]
 *
 * @typedef {'upper' | 'lower' | 'both'} AnswerBody
 *
 * @typedef {object} AnswerPlace
 * @property {AnswerBody} body
 * @property {number} depth
 * @property {number} x
 * @property {number} [y]
 *
 * @typedef {string} AnswerQuantity
 *
 * @typedef {object} Callback
 * @property {number} attempts
 * @property {string} [delivered_at]
 * @property {string} id
 * @property {string} [last_error]
 * @property {number} [last_status]
 * @property {string} [next_attempt_at]
 * @property {CallbackState} state
 *
 * @typedef {'waiting' | 'pending' | 'delivered' | 'failed'} CallbackState
 *
 * @typedef {object} Contact
 * @property {RollerContact} [along]
 * @property {ContactMaps} [maps]
 * @property {ContactNodes} nodes
 * @property {(Patch)[]} patches
 * @property {PressureQuantiles} [quantiles]
 * @property {ContactSection} [section]
 *
 * @typedef {object} ContactMaps
 * @property {(number)[]} [dent]
 * @property {(number)[]} gap
 * @property {(number)[]} pressure
 * @property {(number)[]} x
 * @property {(number)[]} y
 *
 * @typedef {object} ContactNodes
 * @property {(number)[]} force
 * @property {(number)[]} gap
 * @property {(number)[]} pressure
 * @property {(number)[]} x
 *
 * @typedef {object} ContactSection
 * @property {(number)[]} gap
 * @property {(number)[]} pressure
 * @property {(number)[]} y
 *
 * @typedef {object} Course
 * @property {(number | null)[]} error
 * @property {(number)[]} value
 *
 * @typedef {number | ErrorWord} ErrorBar
 *
 * @typedef {'given' | 'exact' | 'not_bounded'} ErrorWord
 *
 * @typedef {object} Estimate
 * @property {number} bytes
 * @property {number} equations
 * @property {number} result_bytes
 *
 * @typedef {object} Fatigue
 * @property {(number)[] | null} crossland
 * @property {(number)[] | null} dang_van
 * @property {(number)[]} depth
 * @property {(number)[] | null} orthogonal_shear
 *
 * @typedef {'dang_van' | 'crossland' | 'orthogonal_shear'} FatigueCriterion
 *
 * @typedef {object} FatigueOfBodies
 * @property {Fatigue | null} lower
 * @property {Fatigue | null} upper
 *
 * @typedef {object} Fault
 * @property {string} code
 * @property {string} detail
 * @property {string} [parameter]
 * @property {string} [pointer]
 *
 * @typedef {object} Fields
 * @property {([number, number])[]} displacement
 * @property {([number, number, number, number])[]} elements
 * @property {(number)[]} equivalent_plastic_strain
 * @property {([number, number])[]} nodes
 * @property {(number)[]} sigma_x
 * @property {(number)[]} sigma_y
 * @property {(number)[]} sigma_z
 * @property {(number)[]} tau_xy
 * @property {(number)[]} von_mises
 *
 * @typedef {object} FieldsOfBodies
 * @property {Fields | null} lower
 * @property {Fields | null} upper
 *
 * @typedef {object} Found
 * @property {string} figure
 * @property {Looks} looks
 * @property {string} text
 * @property {(number)[]} values
 * @property {(string)[]} vary
 *
 * @typedef {object} IncrementNumber
 * @property {number} count
 * @property {number} load
 * @property {number} loads
 * @property {number} number
 *
 * @typedef {object} Increments
 * @property {(number)[]} approach
 * @property {(number)[]} force
 * @property {(number)[]} half_width
 * @property {(number)[]} iterations
 * @property {(number)[]} peak_pressure
 *
 * @typedef {object} Iteration
 * @property {number} approach
 * @property {number} contact_pairs
 * @property {number} contact_pivots
 * @property {number} displacement_change
 * @property {number} elapsed_ms
 * @property {number} equilibrium_residual
 * @property {number} factorizations
 * @property {number} force_change
 * @property {IncrementNumber} [increment]
 * @property {number} initial_stress_updates
 * @property {number} iteration
 * @property {number} peak_pressure
 * @property {number} plastic_points
 *
 * @typedef {object} Job
 * @property {number} attempts
 * @property {Callback} [callback]
 * @property {boolean} cancel_requested
 * @property {string} created_at
 * @property {string} [description]
 * @property {boolean} done
 * @property {Problem} [error]
 * @property {string | null} expires_at
 * @property {string | null} finished_at
 * @property {boolean} has_result
 * @property {JobId} id
 * @property {Links} links
 * @property {number} priority
 * @property {Progress} progress
 * @property {number} [queue_position]
 * @property {Report} [result]
 * @property {string | null} started_at
 * @property {JobState} status
 * @property {Tags} [tags]
 * @property {string} [title]
 * @property {Units} [units]
 *
 * @typedef {string} JobId
 *
 * @typedef {string} JobState
 *
 * @typedef {object} Layers
 * @property {(number)[]} equivalent_plastic_strain
 * @property {(number)[]} plastic_strain_xx
 * @property {(number)[]} plastic_strain_xy
 * @property {(number)[]} plastic_strain_xz
 * @property {(number)[]} plastic_strain_yy
 * @property {(number)[]} plastic_strain_yz
 * @property {(number)[]} plastic_strain_zz
 * @property {(number)[]} sigma_xx
 * @property {(number)[]} sigma_xy
 * @property {(number)[]} sigma_xz
 * @property {(number)[]} sigma_yy
 * @property {(number)[]} sigma_yz
 * @property {(number)[]} sigma_zz
 * @property {(number)[]} von_mises
 * @property {(number)[]} x
 * @property {(number)[]} y
 * @property {(number)[]} z
 * @property {(number)[]} z_faces
 *
 * @typedef {object} LayersOfBodies
 * @property {Layers | null} lower
 * @property {Layers | null} upper
 *
 * @typedef {object} Links
 * @property {string} [cancel]
 * @property {string} [depth_svg]
 * @property {string} events
 * @property {string} [fatigue_csv]
 * @property {string} [field_vtr]
 * @property {string} [field_vtu]
 * @property {string} [hardness_csv]
 * @property {string} [increments_csv]
 * @property {string} [load_approach_svg]
 * @property {string} [passes_csv]
 * @property {string} [pressure_csv]
 * @property {string} [pressure_svg]
 * @property {string} request
 * @property {string} [result]
 * @property {string} self
 * @property {string} [subsurface_csv]
 * @property {string} [summary_csv]
 * @property {string} [surface_csv]
 * @property {string} [surface_svg]
 *
 * @typedef {object} LoadApproach
 * @property {(number)[]} approach
 * @property {(number)[]} force
 * @property {(number)[]} stiffness
 * @property {(number)[]} [stiffness_from]
 * @property {(number)[]} [stiffness_to]
 *
 * @typedef {PrescribedForce | PrescribedApproach} LoadReport
 *
 * @typedef {object} Looks
 * @property {(number | null)[]} error
 * @property {(number)[]} figure
 * @property {(number)[]} value
 *
 * @typedef {'good' | 'attention' | 'bad' | 'unknown'} Mark
 *
 * @typedef {object} Mesh
 * @property {(number)[]} [cells]
 * @property {number} contact_pairs
 * @property {number} elements
 * @property {number} enlargements
 * @property {number} equations
 * @property {number} max_aspect_ratio
 * @property {number} min_jacobian_ratio
 * @property {number} nodes
 * @property {number} passes
 * @property {number} spacing
 * @property {boolean} symmetric
 *
 * @typedef {object} Passes
 * @property {Record<string, Course>} contact
 * @property {(number)[]} iterations
 * @property {Record<string, Course>} lower
 * @property {(number)[]} number
 * @property {Record<string, Course>} upper
 *
 * @typedef {object} Patch
 * @property {number} left
 * @property {number} right
 *
 * @typedef {object} PlasticZone
 * @property {(([number, number])[])[]} outline
 *
 * @typedef {object} PlasticZoneOfBodies
 * @property {PlasticZone | null} lower
 * @property {PlasticZone | null} upper
 *
 * @typedef {object} PrescribedApproach
 * @property {number} approach
 *
 * @typedef {object} PrescribedForce
 * @property {number} force
 *
 * @typedef {object} PressureQuantiles
 * @property {(number)[]} part
 * @property {(number)[]} pressure
 *
 * @typedef {object} Problem
 * @property {number} [column]
 * @property {string} detail
 * @property {(Fault)[]} [errors]
 * @property {Estimate} [estimate]
 * @property {string} [instance]
 * @property {number} [limit_bytes]
 * @property {number} [line]
 * @property {string} [quota]
 * @property {number} status
 * @property {string} title
 * @property {string} type
 *
 * @typedef {object} Progress
 * @property {number} iterations
 * @property {Iteration | null} latest
 *
 * @typedef {object} Report
 * @property {Analysis} analysis
 * @property {(Answer)[]} [answers]
 * @property {Found} [found]
 * @property {LoadApproach} [load_approach]
 * @property {Mesh} mesh
 * @property {SolveStatus} status
 * @property {(Step)[]} steps
 * @property {Tags} [tags]
 * @property {string | null} theory
 * @property {Timings} timings_ms
 * @property {Tolerances} [tolerances]
 * @property {Units} units
 * @property {(ValidityNote)[]} [validity]
 * @property {string} version
 *
 * @typedef {object} RollerContact
 * @property {(number)[]} half_width
 * @property {(number)[]} line_load
 * @property {(number)[]} pressure
 * @property {(number)[]} y
 *
 * @typedef {object} RuleVerdict
 * @property {SolvedHardening} hardening
 * @property {string | null} reason
 * @property {TrackVerdict} verdict
 *
 * @typedef {object} ShakedownMap
 * @property {(number)[]} elastic
 * @property {(number)[]} friction
 * @property {(number)[]} kinematic
 * @property {(number | null)[]} perfect
 * @property {(number)[]} perfect_depth
 *
 * @typedef {string} SolveStatus
 *
 * @typedef {'given' | 'isotropic' | 'kinematic'} SolvedHardening
 *
 * @typedef {object} Step
 * @property {(Answer)[]} answers
 * @property {Contact} contact
 * @property {FatigueOfBodies} [fatigue]
 * @property {FieldsOfBodies} [fields]
 * @property {(Iteration)[]} history
 * @property {Increments} [increments]
 * @property {LayersOfBodies} [layers]
 * @property {LoadReport} load
 * @property {Passes} [passes]
 * @property {PlasticZoneOfBodies} plasticity
 * @property {(RuleVerdict)[]} [rules]
 * @property {ShakedownMap} [shakedown]
 * @property {SolveStatus} status
 * @property {SubsurfaceOfBodies} [subsurface]
 * @property {SubsurfaceOfBodies} [subsurface_below_peak]
 * @property {SurfaceOfBodies} [surfaces]
 * @property {(ValidityNote)[]} validity
 * @property {Verdict} verdict
 *
 * @typedef {object} Subsurface
 * @property {(number)[]} depth
 * @property {(number)[]} equivalent_plastic_strain
 * @property {(number)[]} [initial_sigma_x]
 * @property {(number)[]} [initial_sigma_y]
 * @property {(number)[]} [initial_sigma_z]
 * @property {(number)[]} position
 * @property {(number)[]} sigma_x
 * @property {(number)[]} [sigma_xx]
 * @property {(number)[]} [sigma_xy]
 * @property {(number)[]} [sigma_xz]
 * @property {(number)[]} sigma_y
 * @property {(number)[]} [sigma_yy]
 * @property {(number)[]} [sigma_yz]
 * @property {(number)[]} sigma_z
 * @property {(number)[]} [sigma_zz]
 * @property {(number)[]} tau_max
 * @property {(number)[]} [utilization]
 * @property {(number)[]} von_mises
 * @property {(number)[]} [yield_stress]
 *
 * @typedef {object} SubsurfaceOfBodies
 * @property {Subsurface | null} lower
 * @property {Subsurface | null} upper
 *
 * @typedef {object} Surface
 * @property {(number)[]} height
 * @property {(number)[]} x
 *
 * @typedef {object} SurfaceOfBodies
 * @property {Surface | null} lower
 * @property {Surface | null} upper
 *
 * @typedef {Record<string, string>} Tags
 *
 * @typedef {object} Timings
 * @property {number} assembly
 * @property {number} contact
 * @property {number} flexibility
 * @property {number} mesh
 * @property {number} numeric
 * @property {number} ordering
 * @property {number} output
 * @property {number} plasticity
 * @property {number} solves
 * @property {number} symbolic
 * @property {number} total
 *
 * @typedef {object} Tolerances
 * @property {(number | null)[]} at_worst
 * @property {(AnswerBody | null)[]} body
 * @property {((number | null)[])[]} elasticities
 * @property {(number | null)[]} error
 * @property {(string)[]} inputs
 * @property {(string)[]} label
 * @property {(string)[]} name
 * @property {(number)[]} relative
 * @property {(number | null)[]} root_of_squares
 * @property {string} text
 *
 * @typedef {'elastic' | 'shakes_down' | 'closed_cycle' | 'undecided' | 'ratchets'} TrackVerdict
 *
 * @typedef {'mm_N_MPa' | 'SI'} Units
 *
 * @typedef {object} ValidityNote
 * @property {string} code
 * @property {string} message
 *
 * @typedef {object} Verdict
 * @property {AnswerBody | null} body
 * @property {string | null} figure
 * @property {VerdictLevel} level
 * @property {Mark} mark
 * @property {string} text
 *
 * @typedef {string} VerdictLevel
 *
 */

export {};
