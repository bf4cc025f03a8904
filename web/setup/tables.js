/**
 * The fields of every shape and hardening law, as the service reads them. Generated from the
 * tables of the solver: `BRINELL_WRITE=1 cargo test --test openapi`.
 */

/* prettier-ignore */
/** @type {Record<string, import('./field.js').Kind>} */
export const SHAPES = {
  cylinder: {
    label: "Cylinder",
    description: "Half a cylinder, held at its diametral plane. In axisymmetry it is read as a `sphere`.",
    fields: [
      {"description":"Radius.","example":20.0,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
    ],
  },
  block: {
    label: "Block",
    description: "A rectangle, held at its base.",
    fields: [
      {"description":"Full width, centred on the contact.","example":200.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"Height of the rectangle below the contact.","example":200.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  groove: {
    label: "Groove",
    description: "A block with a concave circular trough across its whole upper face.",
    fields: [
      {"description":"Radius of the trough.","example":30.0,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
      {"description":"Full width, at most twice the radius.","example":40.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"From the bottom of the trough to the base.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  hole: {
    label: "Hole",
    description: "A round hole in the middle of a disc or of a square plate, which holds a `cylinder` with clearance; in axisymmetry the spherical socket of a ball. Its outer edge is the support. Give `outer_radius` or `width`.",
    fields: [
      {"description":"Radius of the hole, larger than that of the cylinder in it.","example":20.1,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
      {"description":"Radius of the disc, larger than that of the hole.","example":200.0,"key":"outer_radius","label":"Outer radius","optional":true,"quantity":"length","symbol":"R_o"},
      {"description":"Width of the square plate, in place of `outer_radius`; only in plane analyses.","key":"width","label":"Width of a square plate","optional":true,"quantity":"length","symbol":"w"},
    ],
  },
  profile: {
    label: "Profile",
    description: "A block whose upper face passes through points, smooth or straight between them.",
    fields: [
      {"columns":["length","length"],"description":"Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is completed by its mirror image.","example":[[-10.0,-2.5],[-4.0,-0.4],[0.0,0.0],[4.0,-0.4],[10.0,-2.5]],"key":"points","kind":"points","label":"Points","symbol":"x, height"},
      {"description":"From height 0 to the base; every height is above it.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
      {"choices":{"linear":"linear","smooth":"smooth"},"description":"What the face is like between its points: `smooth` to the first derivative, without overshoot, or `linear`, so that points are corners. If it is left out, the face is smooth, and refused where that would round off a corner in the contact.","key":"interpolation","kind":"choice","label":"Between points","optional":true,"symbol":""},
    ],
  },
  wedge: {
    label: "Wedge",
    description: "Two plane flanks that meet in a tip; only in plane analyses.",
    fields: [
      {"description":"Angle β of the flanks to the tangential plane, in degrees.","example":5.0,"key":"angle","label":"Angle of the flanks","quantity":"number","symbol":"β"},
      {"description":"Radius of the tip; sharp if it is left out.","key":"tip_radius","label":"Tip radius","optional":true,"quantity":"length","symbol":"ρ"},
      {"description":"Full width.","example":40.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"From the tip to the base, more than the height of the flanks.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  cone: {
    label: "Cone",
    description: "A flank of revolution that ends in a tip; only in axisymmetry.",
    fields: [
      {"description":"Angle β of the flank to the tangential plane, in degrees.","example":5.0,"key":"angle","label":"Angle of the flank","quantity":"number","symbol":"β"},
      {"description":"Radius of the tip; sharp if it is left out.","key":"tip_radius","label":"Tip radius","optional":true,"quantity":"length","symbol":"ρ"},
      {"description":"Diameter of the base.","example":40.0,"key":"width","label":"Diameter","quantity":"length","symbol":"w"},
      {"description":"From the tip to the base, more than the height of the flank.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  punch: {
    label: "Flat punch",
    description: "A rigid flat punch with sharp or rounded edges.",
    fields: [
      {"description":"Full width with the edges, the diameter in axisymmetry.","example":10.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"Radius of the edges, less than half the width; sharp if it is 0 or left out.","key":"edge_radius","label":"Edge radius","optional":true,"quantity":"length","symbol":"ρ"},
      {"description":"Height of the side walls, more than the edge radius.","example":20.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  parabola: {
    label: "Parabola",
    description: "A block with the surface y = −x²/2R.",
    fields: [
      {"description":"Radius of curvature at the vertex.","example":20.0,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
      {"description":"Full width.","example":30.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"From the vertex to the base, more than the fall of the surface at its ends.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  ellipse: {
    label: "Ellipse",
    description: "Half an ellipse, held at its axis along x.",
    fields: [
      {"description":"Half its extent along x.","example":30.0,"key":"semi_axis_x","label":"Semi-axis along x","quantity":"length","symbol":"a_x"},
      {"description":"Half its extent along y.","example":20.0,"key":"semi_axis_y","label":"Semi-axis along y","quantity":"length","symbol":"a_y"},
    ],
  },
  power: {
    label: "Power law",
    description: "A block with the surface y = −L (|x|/L)^n.",
    fields: [
      {"description":"Exponent n; 2 is a parabola, a large one nearly a flat punch.","example":4.0,"key":"exponent","label":"Exponent","quantity":"number","symbol":"n"},
      {"description":"Length L, the distance at which the surface has fallen by as much.","example":30.0,"key":"scale","label":"Scale","quantity":"length","symbol":"L"},
      {"description":"Full width.","example":30.0,"key":"width","label":"Width","quantity":"length","symbol":"w"},
      {"description":"From the vertex to the base, more than the fall of the surface at its ends.","example":50.0,"key":"depth","label":"Depth","quantity":"length","symbol":"d"},
    ],
  },
  sphere: {
    label: "Sphere",
    description: "A ball: in axisymmetry half a sphere, held at its diametral plane; in three dimensions a half-space with its curvature.",
    fields: [
      {"description":"Radius.","example":20.0,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
      {"description":"Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out. Only in three dimensions.","key":"rotation","label":"Rotation","optional":true,"quantity":"number","symbol":"φ"},
    ],
  },
  curved: {
    label: "Curved surface",
    description: "A half-space whose surface has a curvature along its x and one along its y: roller, raceway, crowned part; only in three dimensions.",
    fields: [
      {"description":"Radius of curvature along its x; negative is concave, left out is straight.","example":10.0,"key":"radius_x","label":"Radius along x","optional":true,"quantity":"length","symbol":"R_x"},
      {"description":"Radius of curvature along its y; negative is concave, left out is straight.","example":50.0,"key":"radius_y","label":"Radius along y","optional":true,"quantity":"length","symbol":"R_y"},
      {"description":"Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left out.","key":"rotation","label":"Rotation","optional":true,"quantity":"number","symbol":"φ"},
    ],
  },
  roller: {
    label: "Roller",
    description: "A cylinder of finite length, whose axis is its y: a roller, a rib; only in three dimensions.",
    fields: [
      {"description":"Radius.","example":5.0,"key":"radius","label":"Radius","quantity":"length","symbol":"R"},
      {"description":"Length that can touch, without the rounded ends.","example":10.0,"key":"length","label":"Length","quantity":"length","symbol":"L"},
      {"choices":{"crowned":"crowned","iso_16281":"iso 16281","logarithmic":"logarithmic","points":"points"},"description":"How the surface falls towards the ends: `crowned` in an arc of `crown_radius`, `logarithmic` by Lundberg for `design_force`, `iso_16281` with the factor of that standard, `points` as given. If it is left out, the roller is straight.","key":"profile","kind":"choice","label":"Profile","optional":true,"symbol":""},
      {"description":"Radius of the arc along the axis, for `crowned`.","key":"crown_radius","label":"Crown radius","optional":true,"quantity":"length","symbol":"R_c"},
      {"description":"Force under which a `logarithmic` profile makes the pressure along the roller even.","key":"design_force","label":"Design force","optional":true,"quantity":"force","symbol":"Q"},
      {"columns":["length","length"],"description":"Points `[y, height]` for `points`, y rising and passing 0, straight between them. Points that start or end at y = 0 are completed by their mirror image. Beyond the outermost ones the height stays.","key":"points","kind":"points","label":"Points","optional":true,"symbol":"y, height"},
      {"description":"Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left out.","key":"rotation","label":"Rotation","optional":true,"quantity":"number","symbol":"φ"},
      {"description":"Misalignment in the plane of axis and normal, in mrad: positive brings the end at positive y closer to the other body; 0 if it is left out. The approach is that of the middle.","key":"tilt","label":"Tilt","optional":true,"quantity":"number","symbol":"ϑ"},
      {"description":"Moment about its x axis through the middle, in place of `tilt`, which is found then: positive presses the end at positive y. It is whole from the smallest force of the job on and in proportion to the force below. Only with forces.","key":"moment","label":"Moment","optional":true,"quantity":"energy","symbol":"M"},
    ],
  },
  flat: {
    label: "Plane surface",
    description: "A plane half-space; only in three dimensions.",
    fields: [
      {"description":"Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out.","key":"rotation","label":"Rotation","optional":true,"quantity":"number","symbol":"φ"},
    ],
  },
};

/* prettier-ignore */
/** @type {Record<string, import('./field.js').Kind>} */
export const LAWS = {
  bilinear: {
    label: "Bilinear",
    description: "A straight line beyond the yield stress.",
    fields: [
      {"description":"Yield stress σ_y.","example":500.0,"key":"yield_stress","label":"Yield stress","quantity":"stress","symbol":"σ_y"},
      {"description":"Slope E_t of stress over total strain beyond yield, below E; 0 is perfectly plastic.","example":10500.0,"key":"tangent_modulus","label":"Tangent modulus","quantity":"stress","symbol":"E_t"},
    ],
  },
  ramberg_osgood: {
    label: "Ramberg–Osgood",
    description: "ε_p = a (σ_0/E) (q/σ_0)^m.",
    fields: [
      {"description":"Reference stress σ_0.","example":500.0,"key":"reference_stress","label":"Reference stress","quantity":"stress","symbol":"σ_0"},
      {"description":"Offset a.","example":0.3,"key":"offset","label":"Offset","quantity":"number","symbol":"a"},
      {"description":"Exponent m, from linear to, for every purpose, perfectly plastic.","example":5.0,"key":"exponent","label":"Exponent","quantity":"number","symbol":"m"},
    ],
  },
  table: {
    label: "Table",
    description: "A measured curve.",
    fields: [
      {"columns":["number","stress"],"description":"Points `[plastic_strain, stress]`, joined by straight lines, constant beyond the last.","example":[[0.0,500.0],[0.01,600.0],[0.05,750.0]],"key":"points","kind":"points","label":"Points","symbol":"ε_p, q"},
    ],
  },
  swift: {
    label: "Swift",
    description: "q = σ_y (1 + ε_p/ε_0)^n.",
    fields: [
      {"description":"Yield stress σ_y.","example":500.0,"key":"yield_stress","label":"Yield stress","quantity":"stress","symbol":"σ_y"},
      {"description":"Strain offset ε_0.","example":0.002,"key":"strain_offset","label":"Strain offset","quantity":"number","symbol":"ε_0"},
      {"description":"Exponent n.","example":0.2,"key":"exponent","label":"Exponent","quantity":"number","symbol":"n"},
    ],
  },
  ludwik: {
    label: "Ludwik",
    description: "q = σ_y + k ε_p^n.",
    fields: [
      {"description":"Yield stress σ_y.","example":500.0,"key":"yield_stress","label":"Yield stress","quantity":"stress","symbol":"σ_y"},
      {"description":"Coefficient k.","example":500.0,"key":"coefficient","label":"Coefficient","quantity":"stress","symbol":"k"},
      {"description":"Exponent n.","example":0.5,"key":"exponent","label":"Exponent","quantity":"number","symbol":"n"},
    ],
  },
  voce: {
    label: "Voce",
    description: "q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).",
    fields: [
      {"description":"Yield stress σ_y.","example":500.0,"key":"yield_stress","label":"Yield stress","quantity":"stress","symbol":"σ_y"},
      {"description":"Saturation stress σ_s, at least σ_y.","example":750.0,"key":"saturation_stress","label":"Saturation","quantity":"stress","symbol":"σ_s"},
      {"description":"Rate b.","example":50.0,"key":"rate","label":"Rate","quantity":"number","symbol":"b"},
    ],
  },
};

/* prettier-ignore */
/** @type {Record<string, import('./field.js').Kind>} */
export const OVER_DEPTH = {
  factors: {
    label: "Factors",
    fields: [
      {"columns":["length","number"],"description":"Points `[depth, factor]`, depths rising, joined by straight lines, constant beyond the ends.","example":[[0.0,1.8],[0.5,1.6],[1.5,1.0]],"key":"over_depth","kind":"points","label":"Strength over depth","optional":true,"symbol":"z, factor"},
    ],
  },
  hardness: {
    label: "Hardness over depth",
    fields: [
      {"columns":["length","number"],"description":"Points `[depth, hardness]`, depths rising, joined by straight lines, constant beyond the ends.","example":[[0.0,720.0],[0.5,640.0],[1.0,500.0],[1.5,400.0],[2.0,380.0]],"key":"over_depth/hardness/profile","kind":"points","label":"Hardness over depth","symbol":"z, HV"},
      {"choices":{"HRC":"HRC","HV":"HV"},"description":"Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.","key":"over_depth/hardness/hardness_scale","kind":"choice","label":"Scale","optional":true,"symbol":""},
    ],
  },
  case: {
    label: "Hardened case",
    fields: [
      {"description":"Hardness of the surface, HV unless `hardness_scale` says HRC.","example":720.0,"key":"over_depth/hardness/surface","label":"Surface hardness","quantity":"number","symbol":"HV_s"},
      {"description":"Hardness of the core.","example":380.0,"key":"over_depth/hardness/core","label":"Core hardness","quantity":"number","symbol":"HV_c"},
      {"description":"Case depth: where the hardness has fallen to `limit`.","example":1.0,"key":"over_depth/hardness/case_depth","label":"Case depth","quantity":"length","symbol":"d"},
      {"description":"Hardness at the case depth: 550 HV unless given, as ISO 18203 has it for carburized cases. Nitrided cases have that of the core + 50 HV, induction-hardened ones 80 % of that of the surface.","key":"over_depth/hardness/limit","label":"Hardness at the case depth","optional":true,"quantity":"number","symbol":"HV_d"},
      {"choices":{"error_function":"error function","lang":"lang"},"description":"Profile between surface and core: `error_function` unless given.","key":"over_depth/hardness/curve","kind":"choice","label":"Profile","optional":true,"symbol":""},
      {"choices":{"HRC":"HRC","HV":"HV"},"description":"Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.","key":"over_depth/hardness/hardness_scale","kind":"choice","label":"Scale","optional":true,"symbol":""},
    ],
  },
};

/* prettier-ignore */
/** @type {import('./field.js').Field} */
export const INITIAL_STRESS = {"columns":["length","stress","stress"],"description":"Stress along the surface at one depth, before any load; straight between depths, constant beyond the ends.","key":"initial_stress","kind":"terms","label":"Initial stress","members":["depth","sigma_x","sigma_z"],"optional":true,"symbol":"z, σ_x, σ_z"};

/* prettier-ignore */
/** Rockwell C and Vickers hardness, ISO 18265, table A.1. @type {[number, number][]} */
export const ROCKWELL = [[20.3,240.0],[21.3,245.0],[22.2,250.0],[23.1,255.0],[24.0,260.0],[24.8,265.0],[25.6,270.0],[26.4,275.0],[27.1,280.0],[27.8,285.0],[28.5,290.0],[29.2,295.0],[29.8,300.0],[31.0,310.0],[32.2,320.0],[33.3,330.0],[34.4,340.0],[35.5,350.0],[36.6,360.0],[37.7,370.0],[38.8,380.0],[39.8,390.0],[40.8,400.0],[41.8,410.0],[42.7,420.0],[43.6,430.0],[44.5,440.0],[45.3,450.0],[46.1,460.0],[46.9,470.0],[47.7,480.0],[48.4,490.0],[49.1,500.0],[49.8,510.0],[50.5,520.0],[51.1,530.0],[51.7,540.0],[52.3,550.0],[53.0,560.0],[53.6,570.0],[54.1,580.0],[54.7,590.0],[55.2,600.0],[55.7,610.0],[56.3,620.0],[56.8,630.0],[57.3,640.0],[57.8,650.0],[58.3,660.0],[58.8,670.0],[59.2,680.0],[59.7,690.0],[60.1,700.0],[61.0,720.0],[61.8,740.0],[62.5,760.0],[63.3,780.0],[64.0,800.0],[64.7,820.0],[65.3,840.0],[65.9,860.0],[67.0,900.0],[68.0,940.0]];

/** The figures of a result by what they are; those without unit are left out. @type {Record<string, string[]>} */
/* prettier-ignore */
export const FIGURES = {
  length: ["approach","dent","depth","displacement","gap","half_width","height","left","nodes","outline","perfect_depth","position","right","spacing","x","y","z","z_faces"],
  stress: ["elastic","initial_sigma_x","initial_sigma_y","initial_sigma_z","kinematic","peak_pressure","perfect","pressure","sigma_x","sigma_xx","sigma_xy","sigma_xz","sigma_y","sigma_yy","sigma_yz","sigma_z","sigma_zz","tau_max","tau_xy","von_mises","yield_stress"],
  load: ["force","stiffness_from","stiffness_to"],
  slope: ["line_load","stiffness"],
};
