/**
 * A sketch of every shape, load, profile and law of `docs/job.md`, by the page's own code:
 * `npm run sketches` writes `docs/figures/job`, with `--check` it is compared. A document of a few
 * lines stands in for that of a browser.
 */

import { mkdir, readFile, readdir, writeFile } from 'node:fs/promises';
import { curvePreview, rollerPreview } from '../../web/setup/preview.js';
import { picture } from '../../web/setup/sketch.js';

const FOLDER = new URL('../../docs/figures/job/', import.meta.url);
const STYLE = new URL('../../web/style/', import.meta.url);

/** An element that can do no more than be written. */
class Element {
  /** @param {string} name */
  constructor(name) {
    this.name = name;
    this.attributes = /** @type {Record<string, string>} */ ({});
    this.children = /** @type {(Element | string)[]} */ ([]);
  }
  /** @param {string} name @param {string} value */
  setAttribute(name, value) {
    this.attributes[name] = value;
  }
  /** @param {(Element | string)[]} children */
  append(...children) {
    this.children.push(...children);
  }
  /** @returns {string} */
  toString() {
    const attributes = Object.entries(this.attributes).map(
      ([name, value]) => ` ${name}="${escaped(value)}"`,
    );
    const inside = this.children.map((child) =>
      typeof child === 'string' ? escaped(child) : String(child),
    );
    return `<${this.name}${attributes.join('')}>${inside.join('')}</${this.name}>`;
  }
}

const escaped = (/** @type {string} */ text) =>
  text.replace(/[&<"]/g, (one) => ({ '&': '&amp;', '<': '&lt;' })[one] ?? '&quot;');

Object.assign(globalThis, {
  document: {
    createElement: (/** @type {string} */ name) => new Element(name),
    createElementNS: (/** @type {string} */ _, /** @type {string} */ name) => new Element(name),
  },
});

const elastic = { young_modulus: 210000, poisson_ratio: 0.3 };
const body = (/** @type {object} */ shape, /** @type {object} */ material = elastic) => ({
  shape,
  material,
});
const BLOCK = body({ type: 'block', width: 50, depth: 16 });
const ROLLER = body({ type: 'cylinder', radius: 12 });
const FLAT = body({ type: 'flat' });
const line = { analysis: 'plane_strain', load: { force: 500 } };
const round = { analysis: 'axisymmetric', load: { force: 500 } };
const space = { analysis: 'three_dimensional', load: { force: 500 } };
/** A shape on a block. */
const above = (/** @type {object} */ shape) => ({ ...line, upper: body(shape), lower: BLOCK });
/** A half-space on a flat one. */
const onFlat = (/** @type {object} */ shape) => ({ ...space, upper: body(shape), lower: FLAT });
const pressed = (/** @type {object} */ load, /** @type {object} */ more = {}) => ({
  ...line,
  upper: ROLLER,
  lower: BLOCK,
  load,
  ...more,
});

const JOBS = {
  cylinder: above(ROLLER.shape),
  block: { ...line, upper: ROLLER, lower: body({ type: 'block', width: 60, depth: 24 }) },
  groove: {
    ...line,
    upper: ROLLER,
    lower: body({ type: 'groove', radius: 15, width: 26, depth: 10 }),
  },
  hole: {
    ...line,
    upper: body({ type: 'cylinder', radius: 9.8 }),
    lower: body({ type: 'hole', radius: 10, outer_radius: 18 }),
  },
  profile: above({
    type: 'profile',
    points: [
      [0, 0],
      [3, -0.1],
      [6, -0.6],
      [9, -2.5],
      [11, -6],
    ],
    depth: 12,
  }),
  wedge: above({ type: 'wedge', angle: 40, tip_radius: 2, width: 24, depth: 14 }),
  cone: {
    ...round,
    upper: body({ type: 'cone', angle: 30, width: 24, depth: 12 }),
    lower: BLOCK,
  },
  punch: {
    ...line,
    upper: body({ type: 'punch', width: 20, edge_radius: 2, depth: 12 }, { rigid: true }),
    lower: BLOCK,
  },
  parabola: above({ type: 'parabola', radius: 10, width: 24, depth: 14 }),
  ellipse: above({ type: 'ellipse', semi_axis_x: 18, semi_axis_y: 9 }),
  power: above({ type: 'power', exponent: 4, scale: 9, width: 24, depth: 26 }),
  sphere: onFlat({ type: 'sphere', radius: 10 }),
  curved: {
    ...space,
    upper: body({ type: 'sphere', radius: 10 }),
    lower: body({ type: 'curved', radius_x: 30, radius_y: -10.4 }),
  },
  roller: onFlat({ type: 'roller', radius: 5, length: 16, profile: 'crowned', crown_radius: 80 }),
  tilt: onFlat({
    type: 'roller',
    radius: 5,
    length: 16,
    profile: 'crowned',
    crown_radius: 80,
    tilt: 2,
  }),
  force: pressed({ force: 500 }),
  forces: pressed({ forces: [100, 200, 300, 400, 500] }),
  approach: pressed({ approach: 0.02 }),
  history: pressed({ history: [{ force: 500 }, { force: 0 }] }),
  onset: pressed({ onset: true }),
  target: pressed({ target: { peak_pressure: 1200 } }),
  rolling: pressed({ rolling: { force: 2000, friction: -0.2 } }),
  hardness: pressed(
    { hardness: 'HBW 10/3000' },
    { analysis: 'axisymmetric', upper: body({ type: 'cylinder', radius: 5 }, { rigid: true }) },
  ),
};

const PROFILES = {
  crowned: { profile: 'crowned', crown_radius: 1000 },
  logarithmic: { profile: 'logarithmic', design_force: 20000 },
  iso_16281: { profile: 'iso_16281' },
  points: {
    profile: 'points',
    points: [
      [-8, -0.03],
      [-6, -0.006],
      [-4, 0],
      [4, 0],
      [6, -0.006],
      [8, -0.03],
    ],
  },
};

const LAWS = {
  bilinear: { yield_stress: 500, tangent_modulus: 10000 },
  ramberg_osgood: { reference_stress: 400, offset: 1, exponent: 8 },
  table: {
    points: [
      [0, 400],
      [0.004, 480],
      [0.02, 560],
    ],
  },
  swift: { yield_stress: 400, strain_offset: 0.002, exponent: 0.15 },
  ludwik: { yield_stress: 350, coefficient: 700, exponent: 0.4 },
  voce: { yield_stress: 400, saturation_stress: 600, rate: 200 },
};

/** The first picture in what the page would put beside its fields. @param {any} made */
const within = (made) => made[0].children.find((/** @type {any} */ one) => one?.name === 'svg');

/** Rules of the page for these pictures: those under a selector whose class is in the picture. */
const sheets = await Promise.all(
  ['base.css', 'setup.css'].map((name) => readFile(new URL(name, STYLE), 'utf8')),
);
/** Variables of one colour scheme. @param {string} head */
const variables = (head) =>
  Object.fromEntries(
    [
      ...sheets[0]
        .slice(sheets[0].indexOf(head))
        .split('}')[0]
        .matchAll(/(--[\w-]+): (#\w+)/g),
    ].map(([, name, value]) => [name, value]),
  );
const [light, dark] = [variables('[data-colours] {'), variables('[data-colours="dark"] {')];

/** @param {string} drawn @param {string} scope */
function styled(drawn, scope) {
  const rules = sheets[1]
    .split('\n')
    .filter((line) => line.startsWith(`${scope} `))
    .map((line) => line.slice(scope.length + 1))
    .filter((rule) => {
      const classes = [...rule.split('{')[0].matchAll(/\.([\w-]+)/g)].map(([, name]) => name);
      const words = drawn.match(/class="[^"]*"/g)?.join(' ') ?? '';
      return (
        (classes.length && classes.every((name) => new RegExp(`\\b${name}\\b`).test(words))) ||
        rule.startsWith('text')
      );
    });
  const used = [...new Set(rules.join().match(/--[\w-]+/g)), '--sunken'];
  const set = (/** @type {Record<string, string>} */ scheme) =>
    `svg { ${used.map((name) => `${name}: ${scheme[name]}`).join('; ')} }`;
  return [
    set(light),
    `@media (prefers-color-scheme: dark) { ${set(dark)} }`,
    'svg { background: var(--sunken); font-family: system-ui, sans-serif }',
    ...rules,
  ].join('\n');
}

/** @param {any} root @param {string} scope */
function written(root, scope) {
  if (!root?.children.length) throw new Error('nothing is drawn');
  const [, , width, height] = root.attributes.viewBox.split(' ');
  Object.assign(root.attributes, { xmlns: 'http://www.w3.org/2000/svg', width, height });
  const style = new Element('style');
  style.append(styled(String(root), scope));
  root.children.unshift('\n', style, '\n');
  return `${root}\n`;
}

const drawn = /** @type {Record<string, string>} */ ({});
for (const [name, job] of Object.entries(JOBS))
  drawn[name] = written(picture(/** @type {any} */ (job), null), '.sketch');
for (const [name, profile] of Object.entries(PROFILES)) {
  const job = onFlat({ type: 'roller', radius: 10, length: 16, ...profile });
  const preview = rollerPreview(/** @type {any} */ (job), 'upper');
  drawn[`profile_${name}`] = written(within(preview), 'figure.preview');
}
for (const [law, figures] of Object.entries(LAWS)) {
  const preview = curvePreview({ ...elastic, plasticity: { law, ...figures } }, 'mm_N_MPa');
  drawn[`law_${law}`] = written(within(preview), 'figure.preview');
}

if (!process.argv.includes('--check')) await mkdir(FOLDER, { recursive: true });
for (const [name, text] of Object.entries(drawn)) {
  const file = new URL(`${name}.svg`, FOLDER);
  if (!process.argv.includes('--check')) await writeFile(file, text);
  else if ((await readFile(file, 'utf8').catch(() => '')) !== text)
    throw new Error(
      `${name}.svg is not as the page draws it: npm --prefix tests/page run sketches`,
    );
}
const strangers = (await readdir(FOLDER)).filter((file) => !drawn[file.replace(/\.svg$/, '')]);
if (strangers.length) throw new Error(`docs/figures/job has no use for ${strangers.join(', ')}`);
