/**
 * What goes over the wire: the schemas of the OpenAPI document that the page names, and those that
 * they refer to. Generated from it: `BRINELL_WRITE=1 cargo test --test openapi`.
 *
 * @typedef {'plane_strain' | 'plane_stress' | 'axisymmetric' | 'three_dimensional'} Analysis
 *
 * @typedef {object} Answer
 * @property {number} [at_least]
 * @property {number} [at_most]
 * @property {AnswerBody | null} body
 * @property {number | null} elastic
 * @property {number | null} error
 * @property {string} label
 * @property {string} name
 * @property {AnswerPlace | null} place
 * @property {AnswerQuantity} quantity
 * @property {string} text
 * @property {string} unit
 * @property {number | null} value
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
 * @typedef {object} BodyErrors
 * @property {number | null} area
 * @property {number | null} depth
 * @property {number | null} least_stress
 * @property {number | null} max_equivalent_plastic_strain
 * @property {number | null} mean_equivalent_plastic_strain
 * @property {number | null} pile_up
 * @property {number | null} utilization
 *
 * @typedef {object} BodyErrorsOfBodies
 * @property {BodyErrors | null} lower
 * @property {BodyErrors | null} upper
 *
 * @typedef {object} BodyPass
 * @property {number} accumulated_strain
 * @property {number} forward
 * @property {number} groove_depth
 * @property {number} largest_sigma_x
 * @property {number} largest_sigma_z
 * @property {number} largest_strain
 * @property {number} largest_strain_across
 * @property {number} largest_strain_depth
 * @property {number} least_sigma_x
 * @property {number} least_sigma_z
 * @property {number} net_strain
 * @property {number} net_strain_across
 * @property {number} net_strain_depth
 * @property {number} pile_up
 *
 * @typedef {object} BodyPassErrors
 * @property {number | null} forward
 * @property {number | null} groove_depth
 * @property {number | null} largest_strain
 * @property {number | null} net_strain
 * @property {number | null} pile_up
 * @property {number | null} residual
 *
 * @typedef {object} BodyPassErrorsOfBodies
 * @property {BodyPassErrors | null} lower
 * @property {BodyPassErrors | null} upper
 *
 * @typedef {object} BodyPassOfBodies
 * @property {BodyPass | null} lower
 * @property {BodyPass | null} upper
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
 * @property {number} force
 * @property {number} [half_angle]
 * @property {number} half_width
 * @property {number} mean_pressure
 * @property {number | null} middle_pressure
 * @property {ContactNodes} nodes
 * @property {(Patch)[]} patches
 * @property {number} peak_position
 * @property {number} peak_pressure
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
 * @typedef {object} EllipseErrors
 * @property {number} area
 * @property {number | null} b
 * @property {BodyErrorsOfBodies} bodies
 *
 * @typedef {object} EllipticHertz
 * @property {number} a
 * @property {number} approach
 * @property {number} b
 *
 * @typedef {object} Energy
 * @property {number} dissipated
 * @property {number} elastic
 * @property {number} plastic
 * @property {number} stored
 * @property {number} work
 *
 * @typedef {object} ErrorEstimate
 * @property {number | null} approach
 * @property {BodyErrorsOfBodies} [bodies]
 * @property {number | null} contact_stiffness
 * @property {number | null} force
 * @property {number | null} half_width
 * @property {number | null} middle_pressure
 * @property {number | null} peak_pressure
 *
 * @typedef {object} Estimate
 * @property {number} bytes
 * @property {number} equations
 * @property {number} result_bytes
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
 * @typedef {object} Flow
 * @property {Energy} energy
 * @property {Increments} increments
 * @property {SurfaceOfBodies} surfaces
 * @property {number} unloading_stiffness
 *
 * @typedef {object} FrictionLimits
 * @property {number} elastic_pressure
 * @property {number} friction
 * @property {number} kinematic_pressure
 * @property {number | null} perfect_pressure
 *
 * @typedef {object} HardnessResult
 * @property {number | null} bias
 * @property {string | null} bias_source
 * @property {number | null} constraint
 * @property {number | null} curvature_bias
 * @property {number} depth
 * @property {number | null} depth_error
 * @property {number} diameter
 * @property {number | null} flow_stress
 * @property {number} force
 * @property {number | null} least_thickness
 * @property {number} mean_pressure
 * @property {number | null} meyer_exponent
 * @property {number | null} number
 * @property {number | null} number_error
 * @property {OliverPharr | null} oliver_pharr
 * @property {number | null} permanent_depth
 * @property {number} pile_up
 * @property {number | null} relative_error
 * @property {(ValidityNote)[]} remarks
 * @property {number | null} representative_strain
 * @property {number | null} rim_diameter
 * @property {string} test
 *
 * @typedef {object} Hertz
 * @property {number} half_width
 * @property {number} peak_pressure
 * @property {number | null} shakedown_depth
 * @property {(ShakedownLimit)[]} [shakedown_over_friction]
 * @property {number | null} shakedown_pressure
 * @property {number | null} yield_onset_depth
 * @property {number | null} yield_onset_force
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
 * @typedef {object} Mesh
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
 * @typedef {object} OliverPharr
 * @property {number} area
 * @property {number} contact_depth
 * @property {number | null} hardness_error
 * @property {number} indentation_hardness
 * @property {number | null} modulus_error
 * @property {number} reduced_modulus
 * @property {number} stiffness
 * @property {number} true_area
 * @property {number} true_reduced_modulus
 *
 * @typedef {object} Pass
 * @property {number | null} approach
 * @property {BodyPassOfBodies} bodies
 * @property {number} energy_gap
 * @property {PassErrors | null} estimated_error
 * @property {number} half_width
 * @property {number | null} half_width_across
 * @property {number} iterations
 * @property {number} loss
 * @property {number} number
 * @property {number} peak_pressure
 * @property {number} plastic_work
 * @property {number} rolling_force
 * @property {number} stored_energy
 * @property {number} traction_work
 *
 * @typedef {object} PassErrors
 * @property {number | null} approach
 * @property {BodyPassErrorsOfBodies} bodies
 * @property {number | null} half_width
 * @property {number | null} peak_pressure
 * @property {number | null} plastic_work
 *
 * @typedef {object} Patch
 * @property {number} left
 * @property {number} right
 *
 * @typedef {object} PlasticZone
 * @property {number} area
 * @property {number} depth
 * @property {number | null} max_equivalent_plastic_strain
 * @property {number} [mean_equivalent_plastic_strain]
 * @property {(([number, number])[])[]} outline
 * @property {number} position
 * @property {number} [position_y]
 * @property {boolean} reached_surface
 * @property {number} [volume]
 * @property {boolean} yielded
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
 * @property {HardnessResult} [hardness]
 * @property {LoadApproach} [load_approach]
 * @property {Mesh} mesh
 * @property {SolveStatus} status
 * @property {(Step)[]} steps
 * @property {Tags} [tags]
 * @property {TargetResult} [target]
 * @property {string | null} theory
 * @property {Timings} timings_ms
 * @property {Units} units
 * @property {string} version
 *
 * @typedef {object} RollerContact
 * @property {(number)[]} end_pressure
 * @property {(number)[]} half_width
 * @property {(number)[]} line_load
 * @property {number} middle_pressure
 * @property {number} moment
 * @property {(number)[]} pressure
 * @property {number} tilt
 * @property {(number)[]} y
 *
 * @typedef {object} RollingResult
 * @property {Side | null} body
 * @property {number} columns
 * @property {number} [friction]
 * @property {number} layers
 * @property {TrackLimits} limits
 * @property {(Pass)[]} passes
 * @property {number | null} rate
 * @property {number | null} rate_depth
 * @property {number | null} rate_error
 * @property {string | null} reason
 * @property {number} rows
 * @property {(RuleVerdict)[]} [rules]
 * @property {TrackVerdict} verdict
 *
 * @typedef {object} RoughContact
 * @property {number} contact_ratio
 * @property {number} nominal_pressure
 * @property {(number)[]} parts
 * @property {number} [plastic_part]
 * @property {(number)[]} pressure_quantiles
 *
 * @typedef {object} RuleVerdict
 * @property {SolvedHardening} hardening
 * @property {number} passes
 * @property {number | null} rate
 * @property {number | null} rate_error
 * @property {string | null} reason
 * @property {TrackVerdict} verdict
 *
 * @typedef {object} ShakedownLimit
 * @property {number} depth
 * @property {number} friction
 * @property {number} pressure
 *
 * @typedef {'upper' | 'lower'} Side
 *
 * @typedef {string} SolveStatus
 *
 * @typedef {'given' | 'isotropic' | 'kinematic'} SolvedHardening
 *
 * @typedef {object} Step
 * @property {(Answer)[]} answers
 * @property {number | null} approach
 * @property {string} approach_datum
 * @property {Contact} contact
 * @property {number | null} contact_stiffness
 * @property {ErrorEstimate | null} estimated_error
 * @property {FieldsOfBodies} [fields]
 * @property {Flow} [flow]
 * @property {Hertz | null} hertz
 * @property {(Iteration)[]} history
 * @property {LayersOfBodies} [layers]
 * @property {LoadReport} load
 * @property {PlasticZoneOfBodies} plasticity
 * @property {RollingResult} [rolling]
 * @property {SolveStatus} status
 * @property {SubsurfaceOfBodies} [subsurface]
 * @property {SubsurfaceOfBodies} [subsurface_below_peak]
 * @property {ThreeDimensional} [three_dimensional]
 * @property {(ValidityNote)[]} validity
 * @property {Verdict} [verdict]
 * @property {YieldOnset | null} yield_onset
 *
 * @typedef {object} Subsurface
 * @property {(number)[]} depth
 * @property {(number)[]} equivalent_plastic_strain
 * @property {(number)[]} [initial_sigma_x]
 * @property {(number)[]} [initial_sigma_y]
 * @property {(number)[]} [initial_sigma_z]
 * @property {number} [position]
 * @property {number} [position_y]
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
 * @property {number} depth
 * @property {(number)[]} height
 * @property {number} max_reverse_strain
 * @property {number} pile_up
 * @property {number} pile_up_position
 * @property {number} reverse_area
 * @property {(number)[]} x
 * @property {boolean} yielded_in_reverse
 *
 * @typedef {object} SurfaceOfBodies
 * @property {Surface | null} lower
 * @property {Surface | null} upper
 *
 * @typedef {Record<string, string>} Tags
 *
 * @typedef {object} TargetResult
 * @property {string} figure
 * @property {number} force
 * @property {number} reached
 * @property {number | null} relative_error
 * @property {number} sensitivity
 * @property {number} wanted
 *
 * @typedef {object} ThreeDimensional
 * @property {number} a
 * @property {number} area
 * @property {number} b
 * @property {EllipseErrors} [estimated_error]
 * @property {EllipticHertz} [hertz]
 * @property {number} largest_cell_pressure
 * @property {ContactMaps} [maps]
 * @property {number} orientation
 * @property {number} peak_position_y
 * @property {RollerContact} [roller]
 * @property {ContactSection} section
 * @property {RoughContact} [surface]
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
 * @typedef {object} TrackLimit
 * @property {Side} body
 * @property {number} depth
 * @property {number} peak_pressure
 *
 * @typedef {object} TrackLimits
 * @property {TrackLimit | null} kinematic
 * @property {(FrictionLimits)[]} [over_friction]
 * @property {TrackLimit | null} perfect
 * @property {number | null} shear_yield_stress
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
 * @property {VerdictLevel} level
 * @property {string} text
 *
 * @typedef {string} VerdictLevel
 *
 * @typedef {object} YieldOnset
 * @property {number} approach
 * @property {Side} body
 * @property {number} depth
 * @property {number} force
 * @property {number} peak_pressure
 * @property {number} position
 *
 */

export {};
