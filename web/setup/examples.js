/**
 * Set-ups to begin with: those of the service under names that say what they are, and some more of
 * the page's own.
 */

import { typicalSurface } from './fields.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {{name?: string, title: string, job: Job}} Example */

/** Of the service's examples. */
const TITLES = /** @type {Record<string, string>} */ ({
  two_cylinders: 'Two steel rollers beyond yield',
  cylinder_on_block: 'Steel roller on an aluminium block (NAFEMS)',
  ramberg_osgood: 'Two rollers of Ramberg–Osgood steel',
  case_hardened_roller: 'Case-hardened roller on a hardened block',
  peened_roller: 'Shot-peened roller on a ground block',
  pin_in_hole: 'Pin in a hole',
  static_rating_roller: 'Static rating of a roller (ISO 76)',
  static_rating_ball: 'Static rating of a ball (ISO 76)',
  ball_in_raceway: 'Ball in a raceway, in three dimensions',
  ellipse_dent: 'Dent of an ellipsoid, in three dimensions',
  tilted_roller: 'Tilted roller with a logarithmic profile, in three dimensions',
  rail_under_driven_wheel: 'Rail under a driven wheel',
  rolled_hardened_roller: 'Case-hardened roller that rolls',
  ball_runs_in: 'Ball that runs in, in three dimensions',
  brinell_test: 'Brinell test of a structural steel',
  deep_rolling: 'Deep rolling of a shaft, in three dimensions',
  paper_cylinders: 'Two rollers by the method of Jiang and Shang',
});

const HARD = { name: 'Bearing steel, elastic', young_modulus: 207000, poisson_ratio: 0.3 };
/** Steels of the library by their yield stress. @type {Record<number, string>} */
const NAMED = { 355: 'Steel S355', 430: 'Steel C45E +QT', 750: 'Steel 42CrMo4 +QT' };
/** @param {number} strength */
const steel = (strength) => ({
  name: NAMED[strength],
  young_modulus: 210000,
  poisson_ratio: 0.3,
  plasticity: { law: 'bilinear', yield_stress: strength, tangent_modulus: 2100 },
});

/** @type {Example[]} */
const OWN = [
  {
    name: 'rough_patch',
    title: 'Rough patch pressed flat, in three dimensions',
    job: {
      analysis: 'three_dimensional',
      upper: { shape: { type: 'flat' }, material: HARD, surface: typicalSurface('mm_N_MPa') },
      lower: { shape: { type: 'flat' }, material: steel(750) },
      load: { force: 2 },
    },
  },
  {
    title: 'Bearing ball pressed into a steel plate, ten loads',
    job: {
      analysis: 'axisymmetric',
      upper: { shape: { type: 'sphere', radius: 5 }, material: HARD },
      lower: { shape: { type: 'block', width: 40, depth: 20 }, material: steel(750) },
      load: { forces: [10, 50, 100, 200, 300, 400, 500, 650, 800, 1000] },
    },
  },
  {
    title: 'When does a roller begin to mark its raceway?',
    job: {
      analysis: 'plane_strain',
      upper: { shape: { type: 'cylinder', radius: 6 }, material: HARD },
      lower: { shape: { type: 'block', width: 60, depth: 40 }, material: steel(750) },
      load: { onset: true },
    },
  },
  {
    title: 'Roller in a groove',
    job: {
      analysis: 'plane_strain',
      upper: { shape: { type: 'cylinder', radius: 20 }, material: steel(430) },
      lower: { shape: { type: 'groove', radius: 40, width: 50, depth: 40 }, material: steel(430) },
      load: { force: 1200 },
    },
  },
  {
    title: 'Pin in a lug',
    job: {
      analysis: 'plane_stress',
      upper: { shape: { type: 'cylinder', radius: 10 }, material: steel(430) },
      lower: { shape: { type: 'hole', radius: 10.02, outer_radius: 40 }, material: steel(355) },
      load: { force: 2000 },
    },
  },
  {
    title: 'Crowned face from measured points',
    job: {
      analysis: 'plane_strain',
      upper: {
        shape: {
          type: 'profile',
          depth: 20,
          points: [-8, -6, -4, -2, -1, 0, 1, 2, 4, 6, 8].map((x) => [
            x,
            -Number(((x * x) / 120).toPrecision(4)),
          ]),
        },
        material: steel(355),
      },
      lower: { shape: { type: 'block', width: 80, depth: 40 }, material: steel(355) },
      load: { force: 900 },
    },
  },
  {
    title: 'Rigid roller on bronze, pressed in by steps',
    job: {
      analysis: 'plane_strain',
      upper: { shape: { type: 'cylinder', radius: 15 }, material: { rigid: true } },
      lower: {
        shape: { type: 'block', width: 90, depth: 45 },
        material: {
          young_modulus: 93000,
          poisson_ratio: 0.34,
          plasticity: { law: 'bilinear', yield_stress: 130, tangent_modulus: 930 },
        },
      },
      load: { approaches: [0.002, 0.004, 0.006, 0.008, 0.01] },
    },
  },
];

/** @param {{name: string, job: Job}[]} served @returns {Example[]} with the stress field */
export const examplesOf = (served) =>
  /** @type {Example[]} */ ([
    ...served.map(({ name, job }) => ({
      name,
      title: TITLES[name] ?? name.replaceAll('_', ' '),
      job: { ...job, load: named(job.load) },
    })),
    ...OWN,
  ])
    // A test of hardness has no upper body: it is another thing than the others.
    .sort((a, b) => Number(!a.job.upper) - Number(!b.job.upper))
    .map((one) => ({ ...one, job: { ...one.job, output: { ...one.job.output, fields: true } } }));

/** A hardness test by its name, which the form shows. @param {any} load */
const named = ({ hardness: test, ...load }) =>
  test ? { hardness: `${test.scale} ${test.ball}/${test.force_kgf}` } : load;
