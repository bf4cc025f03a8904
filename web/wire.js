/**
 * What goes over the wire, one type for each schema of the OpenAPI document. Generated from it:
 * `BRINELL_WRITE=1 cargo test --test openapi`.
 *
 * @typedef {'plane_strain' | 'plane_stress' | 'axisymmetric'} Analysis
 *
 * @typedef {object} ApproachLoad
 * @property {number} approach
 * @property {null} [approaches]
 * @property {null} [force]
 * @property {null} [forces]
 * @property {null} [history]
 * @property {null} [onset]
 * @property {null} [target]
 *
 * @typedef {object} ApproachesLoad
 * @property {null} [approach]
 * @property {(number)[]} approaches
 * @property {null} [force]
 * @property {null} [forces]
 * @property {null} [history]
 * @property {null} [onset]
 * @property {null} [target]
 *
 * @typedef {object} BackstressTerm
 * @property {number} modulus
 * @property {number} rate
 *
 * @typedef {object} BatchAnswer
 * @property {number} accepted
 * @property {(BatchItem)[]} jobs
 * @property {number} refused
 *
 * @typedef {object} BatchItem
 * @property {JobId} [id]
 * @property {Job} [job]
 * @property {Problem} [problem]
 * @property {boolean} [replayed]
 * @property {number} status
 *
 * @typedef {object} BatchOfIds
 * @property {(JobId)[]} ids
 *
 * @typedef {object} BatchOfJobs
 * @property {(BatchedJob)[]} jobs
 *
 * @typedef {object} BatchedJob
 * @property {string | null} [callback_url]
 * @property {string | null} [idempotency_key]
 * @property {ContactJob} job
 * @property {number | null} [priority]
 *
 * @typedef {object} Bilinear
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {'bilinear'} law
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {number} tangent_modulus
 * @property {number} yield_stress
 *
 * @typedef {object} Block
 * @property {number} depth
 * @property {'block'} type
 * @property {number} width
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
 * @typedef {object} Capacity
 * @property {Limits} limits
 * @property {number} memory_bytes
 * @property {Queue} queue
 * @property {number} solvers
 *
 * @typedef {'error_function' | 'lang'} CaseCurve
 *
 * @typedef {object} ClosedForm
 * @property {number} effective_radius
 * @property {(ClosedFormStep)[]} steps
 * @property {string} units
 * @property {number | null} yield_onset_force
 *
 * @typedef {object} ClosedFormStep
 * @property {number} force
 * @property {number} half_width
 * @property {number} peak_pressure
 * @property {boolean} yields
 *
 * @typedef {object} Cone
 * @property {number} angle
 * @property {number} depth
 * @property {number | null} [tip_radius]
 * @property {'cone'} type
 * @property {number} width
 *
 * @typedef {object} Contact
 * @property {number} force
 * @property {number} [half_angle]
 * @property {number} half_width
 * @property {number} mean_pressure
 * @property {ContactNodes} nodes
 * @property {(Patch)[]} patches
 * @property {number} peak_position
 * @property {number} peak_pressure
 *
 * @typedef {object} ContactBody
 * @property {Material} material
 * @property {Shape} shape
 * @property {Support | null} [support]
 *
 * @typedef {object} ContactJob
 * @property {Analysis} analysis
 * @property {Load} load
 * @property {ContactBody} lower
 * @property {MeshSettings | null} [mesh]
 * @property {OutputSettings | null} [output]
 * @property {SolverSettings | null} [solver]
 * @property {Tags | null} [tags]
 * @property {Units | null} [units]
 * @property {ContactBody} upper
 *
 * @typedef {'active_set' | 'simplex'} ContactMethod
 *
 * @typedef {object} ContactNodes
 * @property {(number)[]} force
 * @property {(number)[]} gap
 * @property {(number)[]} pressure
 * @property {(number)[]} x
 *
 * @typedef {'accelerated' | 'strong' | 'weak' | 'secant_stiffness'} Coupling
 *
 * @typedef {object} Cylinder
 * @property {number} radius
 * @property {'cylinder'} type
 *
 * @typedef {object} Deformable
 * @property {(InitialStress)[] | null} [initial_stress]
 * @property {Plasticity | null} [plasticity]
 * @property {number} poisson_ratio
 * @property {null} [rigid]
 * @property {number} young_modulus
 *
 * @typedef {object} DentDepthTarget
 * @property {number} dent_depth
 * @property {null} [half_width]
 * @property {null} [max_plastic_strain]
 * @property {null} [mean_pressure]
 * @property {null} [peak_pressure]
 * @property {null} [permanent_approach]
 *
 * @typedef {object} Ellipse
 * @property {number} semi_axis_x
 * @property {number} semi_axis_y
 * @property {'ellipse'} type
 *
 * @typedef {object} Energy
 * @property {number} dissipated
 * @property {number} elastic
 * @property {number} plastic
 * @property {number} stored
 * @property {number} work
 *
 * @typedef {object} ErrorEstimate
 * @property {number} approach
 * @property {number} [contact_stiffness]
 * @property {number} [force]
 * @property {number} half_width
 * @property {number} peak_pressure
 *
 * @typedef {object} Estimate
 * @property {number} bytes
 * @property {number} equations
 * @property {number} result_bytes
 *
 * @typedef {object} Example
 * @property {ContactJob} job
 * @property {string} name
 *
 * @typedef {object} ExampleList
 * @property {(Example)[]} examples
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
 * @typedef {object} ForceLoad
 * @property {null} [approach]
 * @property {null} [approaches]
 * @property {number} force
 * @property {null} [forces]
 * @property {null} [history]
 * @property {null} [onset]
 * @property {null} [target]
 *
 * @typedef {object} ForcesLoad
 * @property {null} [approach]
 * @property {null} [approaches]
 * @property {null} [force]
 * @property {(number)[]} forces
 * @property {null} [history]
 * @property {null} [onset]
 * @property {null} [target]
 *
 * @typedef {object} Groove
 * @property {number} depth
 * @property {number} radius
 * @property {'groove'} type
 * @property {number} width
 *
 * @typedef {object} HalfWidthTarget
 * @property {null} [dent_depth]
 * @property {number} half_width
 * @property {null} [max_plastic_strain]
 * @property {null} [mean_pressure]
 * @property {null} [peak_pressure]
 * @property {null} [permanent_approach]
 *
 * @typedef {object} HardenedCase
 * @property {number} case_depth
 * @property {number} core
 * @property {CaseCurve | null} [curve]
 * @property {number} surface
 *
 * @typedef {object} HardnessOverDepth
 * @property {HardnessProfile | HardenedCase} hardness
 *
 * @typedef {object} HardnessProfile
 * @property {([number, number])[]} profile
 *
 * @typedef {object} Health
 * @property {string} status
 *
 * @typedef {object} Hertz
 * @property {number} half_width
 * @property {number} peak_pressure
 * @property {number | null} shakedown_depth
 * @property {number | null} shakedown_pressure
 * @property {number | null} yield_onset_depth
 * @property {number | null} yield_onset_force
 *
 * @typedef {object} HistoryLoad
 * @property {null} [approach]
 * @property {null} [approaches]
 * @property {null} [force]
 * @property {null} [forces]
 * @property {({force: number} | {approach: number})[]} history
 * @property {null} [onset]
 * @property {null} [target]
 *
 * @typedef {object} Hole
 * @property {number | null} [outer_radius]
 * @property {number} radius
 * @property {'hole'} type
 * @property {number | null} [width]
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
 * @typedef {object} InitialStress
 * @property {number} depth
 * @property {number} sigma_x
 * @property {number} sigma_z
 *
 * @typedef {'smooth' | 'linear'} Interpolation
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
 *
 * @typedef {string} JobId
 *
 * @typedef {object} JobList
 * @property {(Job)[]} jobs
 * @property {JobId | null} next_cursor
 *
 * @typedef {string} JobState
 *
 * @typedef {object} Limits
 * @property {number} batch_jobs
 * @property {number} body_bytes
 * @property {number} job_memory_bytes
 * @property {number} job_seconds
 * @property {number} result_bytes
 * @property {number} solve_seconds
 * @property {number} wait_seconds
 *
 * @typedef {object} Links
 * @property {string} [cancel]
 * @property {string} [depth_svg]
 * @property {string} events
 * @property {string} [field_vtu]
 * @property {string} [increments_csv]
 * @property {string} [load_approach_svg]
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
 * @typedef {ForceLoad | ForcesLoad | ApproachLoad | ApproachesLoad | HistoryLoad | OnsetLoad | TargetLoad} Load
 *
 * @typedef {object} LoadApproach
 * @property {(number)[]} approach
 * @property {(number)[]} force
 * @property {(number)[]} stiffness
 *
 * @typedef {PrescribedForce | PrescribedApproach} LoadReport
 *
 * @typedef {object} Ludwik
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {number} coefficient
 * @property {number} exponent
 * @property {'ludwik'} law
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {number} yield_stress
 *
 * @typedef {Deformable | Rigid} Material
 *
 * @typedef {object} MaxPlasticStrainTarget
 * @property {null} [dent_depth]
 * @property {null} [half_width]
 * @property {number} max_plastic_strain
 * @property {null} [mean_pressure]
 * @property {null} [peak_pressure]
 * @property {null} [permanent_approach]
 *
 * @typedef {object} MeanPressureTarget
 * @property {null} [dent_depth]
 * @property {null} [half_width]
 * @property {null} [max_plastic_strain]
 * @property {number} mean_pressure
 * @property {null} [peak_pressure]
 * @property {null} [permanent_approach]
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
 * @typedef {object} MeshSettings
 * @property {number | null} [elements_per_half_width]
 *
 * @typedef {object} OnsetLoad
 * @property {null} [approach]
 * @property {null} [approaches]
 * @property {null} [force]
 * @property {null} [forces]
 * @property {null} [history]
 * @property {true} onset
 * @property {null} [target]
 *
 * @typedef {object} OutputSettings
 * @property {boolean | null} [fields]
 * @property {boolean | null} [subsurface]
 *
 * @typedef {object} Parabola
 * @property {number} depth
 * @property {number} radius
 * @property {'parabola'} type
 * @property {number} width
 *
 * @typedef {object} Patch
 * @property {number} left
 * @property {number} right
 *
 * @typedef {object} PeakPressureTarget
 * @property {null} [dent_depth]
 * @property {null} [half_width]
 * @property {null} [max_plastic_strain]
 * @property {null} [mean_pressure]
 * @property {number} peak_pressure
 * @property {null} [permanent_approach]
 *
 * @typedef {object} PermanentApproachTarget
 * @property {null} [dent_depth]
 * @property {null} [half_width]
 * @property {null} [max_plastic_strain]
 * @property {null} [mean_pressure]
 * @property {null} [peak_pressure]
 * @property {number} permanent_approach
 *
 * @typedef {object} PlasticZone
 * @property {number} area
 * @property {number} depth
 * @property {number} max_equivalent_plastic_strain
 * @property {(([number, number])[])[]} outline
 * @property {number} position
 * @property {boolean} reached_surface
 * @property {boolean} yielded
 *
 * @typedef {object} PlasticZoneOfBodies
 * @property {PlasticZone | null} lower
 * @property {PlasticZone | null} upper
 *
 * @typedef {Bilinear | RambergOsgood | Table | Swift | Ludwik | Voce} Plasticity
 *
 * @typedef {object} Power
 * @property {number} depth
 * @property {number} exponent
 * @property {number} scale
 * @property {'power'} type
 * @property {number} width
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
 * @typedef {object} Profile
 * @property {number} depth
 * @property {Interpolation | null} [interpolation]
 * @property {([number, number])[]} points
 * @property {'profile'} type
 *
 * @typedef {object} Progress
 * @property {number} iterations
 * @property {Iteration | null} latest
 *
 * @typedef {object} Punch
 * @property {number} depth
 * @property {number | null} [edge_radius]
 * @property {'punch'} type
 * @property {number} width
 *
 * @typedef {object} Queue
 * @property {number} capacity
 * @property {number} queued
 * @property {number} running
 *
 * @typedef {object} RambergOsgood
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {number} exponent
 * @property {'ramberg_osgood'} law
 * @property {number} offset
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {number} reference_stress
 *
 * @typedef {object} Report
 * @property {Analysis} analysis
 * @property {LoadApproach} [load_approach]
 * @property {Mesh} mesh
 * @property {SolveStatus} status
 * @property {(Step)[]} steps
 * @property {Tags} [tags]
 * @property {TargetResult} [target]
 * @property {Timings} timings_ms
 * @property {Units} units
 * @property {string} version
 *
 * @typedef {object} Rigid
 * @property {null} [initial_stress]
 * @property {null} [plasticity]
 * @property {null} [poisson_ratio]
 * @property {true} rigid
 * @property {null} [young_modulus]
 *
 * @typedef {Cylinder | Block | Groove | Hole | Profile | Wedge | Cone | Punch | Parabola | Ellipse | Power} Shape
 *
 * @typedef {'upper' | 'lower'} Side
 *
 * @typedef {string} SolveStatus
 *
 * @typedef {object} SolverSettings
 * @property {ContactMethod | null} [contact]
 * @property {Coupling | null} [coupling]
 * @property {number | null} [increments]
 * @property {number | null} [max_iterations]
 * @property {Theory | null} [theory]
 * @property {number | null} [tolerance]
 *
 * @typedef {object} Step
 * @property {number} approach
 * @property {string} approach_datum
 * @property {Contact} contact
 * @property {number} contact_stiffness
 * @property {ErrorEstimate | null} estimated_error
 * @property {FieldsOfBodies} [fields]
 * @property {Flow} [flow]
 * @property {Hertz | null} hertz
 * @property {(Iteration)[]} history
 * @property {LoadReport} load
 * @property {PlasticZoneOfBodies} plasticity
 * @property {SolveStatus} status
 * @property {SubsurfaceOfBodies} [subsurface]
 * @property {(ValidityNote)[]} validity
 * @property {YieldOnset} [yield_onset]
 *
 * @typedef {([number, number])[]} StrengthFactors
 *
 * @typedef {StrengthFactors | HardnessOverDepth} StrengthOverDepth
 *
 * @typedef {object} Subsurface
 * @property {(number)[]} depth
 * @property {(number)[]} equivalent_plastic_strain
 * @property {(number)[]} [initial_sigma_x]
 * @property {(number)[]} [initial_sigma_y]
 * @property {(number)[]} [initial_sigma_z]
 * @property {(number)[]} sigma_x
 * @property {(number)[]} sigma_y
 * @property {(number)[]} sigma_z
 * @property {(number)[]} tau_max
 * @property {(number)[]} [utilization]
 * @property {(number)[]} von_mises
 * @property {(number)[]} [yield_stress]
 *
 * @typedef {object} SubsurfaceOfBodies
 * @property {Subsurface | null} lower
 * @property {Subsurface | null} upper
 *
 * @typedef {'clamped' | 'roller'} Support
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
 * @typedef {object} Swift
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {number} exponent
 * @property {'swift'} law
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {number} strain_offset
 * @property {number} yield_stress
 *
 * @typedef {object} Table
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {'table'} law
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {([number, number])[]} points
 *
 * @typedef {Record<string, string>} Tags
 *
 * @typedef {PermanentApproachTarget | DentDepthTarget | PeakPressureTarget | MeanPressureTarget | HalfWidthTarget | MaxPlasticStrainTarget} Target
 *
 * @typedef {object} TargetLoad
 * @property {null} [approach]
 * @property {null} [approaches]
 * @property {null} [force]
 * @property {null} [forces]
 * @property {null} [history]
 * @property {null} [onset]
 * @property {Target} target
 *
 * @typedef {object} TargetResult
 * @property {string} figure
 * @property {number} force
 * @property {number} reached
 * @property {number | null} relative_error
 * @property {number} sensitivity
 * @property {number} wanted
 *
 * @typedef {'deformation' | 'flow'} Theory
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
 * @typedef {'mm_N_MPa' | 'SI'} Units
 *
 * @typedef {object} Validation
 * @property {Estimate} estimate
 * @property {boolean} valid
 *
 * @typedef {object} ValidityNote
 * @property {string} code
 * @property {string} message
 *
 * @typedef {object} Voce
 * @property {(BackstressTerm)[] | null} [backstress]
 * @property {'voce'} law
 * @property {StrengthOverDepth | null} [over_depth]
 * @property {number} rate
 * @property {number} saturation_stress
 * @property {number} yield_stress
 *
 * @typedef {object} Wedge
 * @property {number} angle
 * @property {number} depth
 * @property {number | null} [tip_radius]
 * @property {'wedge'} type
 * @property {number} width
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
