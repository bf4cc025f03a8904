/**
 * One sheet for a report: inputs, sketch, figures with error bars, charts, remarks, and where it
 * all comes from.
 */

import { button, byId, h } from '../lib/dom.js';
import * as pointer from '../lib/pointer.js';
import { forceOf, unit, unitsOf } from '../lib/units.js';
import {
  ANALYSES,
  BACKSTRESS,
  DEFAULTS,
  ELASTIC,
  LAWS,
  LOADS,
  OVER_DEPTH,
  SETTINGS,
  SUPPORTS,
  TARGETS,
  THEORIES,
  hasInitialStress,
  hasSurface,
  initialStressOf,
  lawOf,
  loadOf,
  overDepthOf,
  shapeFields,
  shapeLabel,
  targetOf,
  usualElements,
} from '../setup/fields.js';
import { picture } from '../setup/sketch.js';
import { symbol } from '../setup/entry.js';
import { here } from '../jobs/link.js';
import {
  materialName,
  pairOf,
  stemOf,
  tagWords,
  titleOf,
  writeValue,
  writeWhole,
} from '../jobs/names.js';
import { browser, isObject, kept } from '../lib/kept.js';
import { answersTable, verdict } from './answers-table.js';
import { differencesTable } from './differences.js';
import { save } from './downloads.js';
import { figuresTable, tableElements } from './figures.js';
import { remarksOf, sentencesOf } from './headline.js';
import { asked, beside, endedEarly } from './loads.js';
import { hertzIn } from './rows.js';

/** @typedef {import('../shown.js').Shown} Shown */
/** @typedef {import('../types.js').Job} Job */

/**
 * @param {object} of
 * @param {Shown[]} of.shown
 * @param {number} of.at step of the first
 * @param {SVGSVGElement[]} of.drawings
 * @param {HTMLCanvasElement[]} of.fields pictures of maps and of the field
 * @param {SVGSVGElement | null} of.cutDrawing curve of the cut that is seen in the field
 */
export function showSheet({ shown, at, drawings, fields, cutDrawing }) {
  const [{ id, job, report, raw = report, label, removed }] = shown;
  // By which browsers name a file that is printed.
  if (document.title !== fileName) titled = document.title;
  document.title = fileName = stemOf(job, id);
  const step = report.steps[at];
  const hertz = hertzIn(raw.steps[at]);
  const bodies = pairOf(job);
  const many = report.steps.length;
  const sketch = h(
    'figure',
    { class: 'sketch' },
    picture(
      job,
      hertz && {
        effective_radius: 0,
        yield_onset_force: null,
        steps: [{ ...hertz, force: 0, yields: false }],
      },
    ),
  );
  const ended = endedEarly(job, report);
  const sides = beside(shown, at);
  const others = shown.length > 1 ? sides.map(({ label }) => label) : [];
  const pictures = [...drawings, ...fields, cutDrawing].filter((one) => one !== null);
  const remarks = h(
    'section',
    {},
    h('h2', {}, 'Remarks'),
    h(
      'ul',
      {},
      ended && h('li', {}, h('b', {}, ended)),
      others.length > 0 && h('li', {}, `Beside each other in the charts: ${others.join('; ')}.`),
      sides.flatMap(({ one, at, label: name }) =>
        remarksOf(one.report, at).map(({ message }) =>
          h(
            'li',
            {},
            sides.length > 1 ? h('b', {}, `${name}: `) : null,
            symbol(sentencesOf(message).join(' ')),
          ),
        ),
      ),
      h(
        'li',
        {},
        'The error bars are estimated bounds of the error of the mesh; they say nothing of the model or the figures put in.',
      ),
    ),
  );
  byId('sheet').replaceChildren(
    h(
      'div',
      { class: 'bar sheet-tools' },
      button('Print or save as PDF', () => print(), { class: 'primary' }),
      button('Save as one HTML file', () => saveSheet(shown[0]), {
        title: 'One file that opens without the service',
      }),
      button('Back', close),
    ),
    h(
      'div',
      { class: 'sheet-head' },
      h('h1', {}, job.title ? String(job.title) : bodies),
      h(
        'p',
        {},
        `${job.title ? `${bodies}, ` : ''}${ANALYSES[job.analysis] ?? ''}${many > 1 || asked(job) > 1 ? `, step ${at + 1} of ${many}` : ''}${many < asked(job) ? ` solved, of ${asked(job)} asked for` : ''}${tagWords(
          job.tags,
        )
          .filter((words) => !HEADINGS.some((one) => words.startsWith(`${one}: `)))
          .map((words) => `, ${words}`)
          .join('')}`,
      ),
    ),
    headings(shown[0]),
    h(
      'div',
      { class: 'sheet-verdicts' },
      sides.map((side) => verdict(side, sides.length > 1)),
    ),
    h(
      'div',
      { class: 'sheet-columns' },
      h(
        'section',
        {},
        h('h2', {}, shown.length > 1 ? `Set-up: ${label}` : 'Set-up'),
        inputs(shown[0]),
      ),
      sketch,
    ),
    h(
      'h2',
      {},
      `Figures${step.status === 'converged' ? '' : `: ${step.status.replaceAll('_', ' ')}, not an answer`}`,
    ),
    h(
      'div',
      { class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Figures' },
      answersTable(sides, false),
    ),
    h(
      'div',
      { class: 'sheet-drawings' },
      pictures,
      // A picture that would stand alone has the remarks beside it.
      pictures.length % 2 ? remarks : null,
    ),
    ...(many > 1 || shown.length > 1
      ? [
          h('h2', {}, shown.length > 1 ? 'Jobs compared' : 'All steps'),
          h(
            'div',
            { class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Figures of every step' },
            h('table', {}, tableElements(tableOf(shown))),
          ),
        ]
      : []),
    ...(shown.length > 1
      ? [
          h('h2', {}, 'Differences'),
          h(
            'div',
            { class: 'wide', tabindex: 0, role: 'region', 'aria-label': 'Differences' },
            h('table', {}, tableElements(differencesTable(shown))),
          ),
          h(
            'div',
            { class: 'sheet-setups' },
            shown
              .slice(1)
              .map((one) => h('section', {}, h('h2', {}, `Set-up: ${one.label}`), inputs(one))),
          ),
        ]
      : []),
    h(
      'div',
      { class: 'closing' },
      pictures.length % 2 ? null : remarks,
      h(
        'div',
        { class: 'sheet-foot' },
        `Brinell ${report.version}, ${id ? `job ${id}` : 'solved beside a slider and kept as no job'}${label && label !== (id.slice(-8) || 'live') ? ` (${label})` : ''}, ${new Date().toISOString().slice(0, 10)}. `,
        removed
          ? 'The service no longer has it.'
          : id
            ? h('span', { class: 'link' }, here())
            : null,
      ),
    ),
  );
}

/**
 * What a report is headed with: tags of the job where it has them, else what is typed and kept by
 * the browser.
 */
const HEADINGS = /** @type {const} */ (['title', 'part', 'author']);
const KEPT = 'report-headings';
/** Reports whose headings the browser keeps. */
const MANY = 50;

/** Fields to head the report with. @param {Shown} shown */
function headings({ id, job }) {
  const all =
    kept(browser, KEPT, (one) => (Array.isArray(one) ? one.filter(isObject) : undefined)) ?? [];
  const own = /** @type {Record<string, string>} */ ({ id, ...all.find((one) => one.id === id) });
  const keep = (/** @type {string} */ name, /** @type {string} */ text) => {
    own[name] = text;
    browser.set(KEPT, JSON.stringify([...all.filter((one) => one.id !== id), own].slice(-MANY)));
  };
  return h(
    'div',
    { class: 'sheet-headings' },
    HEADINGS.map((name) => {
      const input = h('input', {
        type: 'text',
        placeholder: ' ',
        value: (name === 'title' ? job.title : undefined) ?? job.tags?.[name] ?? own[name] ?? '',
        maxlength: 120,
        oninput: () => keep(name, input.value),
      });
      return h('label', {}, `${name[0].toUpperCase()}${name.slice(1)} `, input);
    }),
  );
}

/** The sheet as a file by itself, with the job and the answer. @param {Shown} shown */
function saveSheet({ id, job, report, raw = report }) {
  // A document that is not seen loads no pictures, which this page may not.
  const unseen = document.implementation.createHTMLDocument();
  const sheet = unseen.importNode(byId('sheet'), true);
  sheet.querySelector('.sheet-tools')?.remove();
  const canvases = byId('sheet').querySelectorAll('canvas');
  sheet.querySelectorAll('canvas').forEach((canvas, k) => {
    const image = unseen.createElement('img');
    image.src = canvases[k].toDataURL();
    image.alt = canvases[k].getAttribute('aria-label') ?? '';
    canvas.replaceWith(image);
  });
  const fields = byId('sheet').querySelectorAll('input');
  sheet.querySelectorAll('input').forEach((input, k) => {
    if (fields[k].value) input.replaceWith(h('b', {}, fields[k].value));
    else input.closest('label')?.remove();
  });
  const rules = [...document.styleSheets].flatMap(({ cssRules }) => [...cssRules]);
  const data = JSON.stringify({ job, result: { ...raw, steps: raw.steps.map(plainStep) } });
  const page = [
    '<!doctype html><html lang="en" data-colours="light" data-view="sheet"><meta charset="utf-8">',
    h('title', {}, titleOf(job) || pairOf(job)).outerHTML,
    `<style>${rules.map(({ cssText }) => cssText).join('\n')}</style>`,
    sheet.outerHTML,
    `<script type="application/json" id="data">${data.replaceAll('<', '\\u003c')}</script></html>`,
  ].join('\n');
  save(new Blob([page], { type: 'text/html' }), `${stemOf(job, id)}.html`);
}

/** Without what has been fetched of the field. @param {import('../types.js').Step} step */
const plainStep = ({ fields: _, layers: __, ...step }) => step;

/** What the tab was called before the sheet was seen. */
let titled = '';

/** What the tab is called while the sheet is seen. */
let fileName = '';

/** Back to the page. */
export function close() {
  delete document.documentElement.dataset.view;
  // A job that was removed meanwhile has named the tab anew.
  if (document.title === fileName) document.title = titled;
  titled = '';
  byId('report').focus();
}

/**
 * @param {Job} job
 * @param {import('../setup/field.js').Field} load
 * @returns {string} its unit, and that of approaches among forces
 */
function unitOfLoad(job, { quantity = 'number' }) {
  const units = unitsOf(job);
  const own = unit(quantity === 'load' ? forceOf(job) : quantity, units);
  const loads = /** @type {any[]} */ (Array.isArray(job.load?.history) ? job.load.history : []);
  const far = loads.filter((one) => one?.approach !== undefined).length;
  return [
    ...(far === 0 || far < loads.length ? [own] : []),
    ...(far ? [`α ${unit('length', units)}`] : []),
  ].join(', ');
}

/** What was asked, in the units of the job, by which theory. @param {Shown} shown */
function inputs({ job, report: { theory } }) {
  const units = unitsOf(job);
  const row = (
    /** @type {string} */ name,
    /** @type {string} */ mark,
    /** @type {unknown[]} */ values,
    /** @type {string} */ of,
  ) =>
    h(
      'tr',
      {},
      h('th', { scope: 'row' }, name, mark ? [' ', h('i', {}, symbol(mark))] : null),
      values.map((value) => h('td', {}, value === undefined ? '—' : writeWhole(value))),
      h('td', { class: 'unit' }, of),
    );
  const bodies = [job.upper, job.lower];
  const fieldsOf = (
    /** @type {(body: any) => import('../setup/field.js').Field[]} */ pick,
    /** @type {(body: any) => any} */ place,
  ) => {
    const fields = new Map(
      bodies.flatMap((body) => pick(body).map((field) => [field.key, field])),
    );
    return [...fields.values()].flatMap((field) => {
      const values = bodies.map((body) => pointer.get(place(body), `/${field.key}`) ?? undefined);
      const of = field.unit
        ? field.unit
        : field.columns
          ? field.columns.map((one) => unit(one, units) || '1').join(', ')
          : field.quantity && field.quantity !== 'load'
            ? unit(field.quantity, units)
            : '';
      return values.every((value) => value === undefined)
        ? []
        : [row(field.label, field.symbol ?? '', values, of)];
    });
  };
  const kind = loadOf(job.load);
  const loads = kind === 'target' ? [TARGETS[targetOf(job.load)]] : LOADS[kind].fields;
  const given = loads.filter((load) => pointer.get(job.load, `/${load.key}`) !== undefined);
  const elements = job.mesh?.elements_per_half_width ?? usualElements(job);
  const whole = (/** @type {any} */ name, /** @type {string} */ value, /** @type {string} */ of) =>
    h(
      'tr',
      {},
      h('th', { scope: 'row' }, name),
      h('td', { colspan: 2 }, value),
      h('td', { class: 'unit' }, of),
    );
  return h(
    'table',
    { class: 'inputs' },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('td'),
        h('th', { scope: 'col' }, 'upper'),
        h('th', { scope: 'col' }, 'lower'),
        h('td'),
      ),
    ),
    h(
      'tbody',
      {},
      row(
        'Shape',
        '',
        bodies.map((body) => shapeLabel(body?.shape?.type, job.analysis).toLowerCase()),
        '',
      ),
      fieldsOf(
        (body) => shapeFields(body?.shape),
        (body) => body?.shape,
      ),
      bodies.some(hasSurface) &&
        row(
          'Heights',
          '',
          bodies.map((body) => (hasSurface(body) ? heightsWords(body.surface) : undefined)),
          unit('length', units),
        ),
      // A half-space has no far boundary.
      job.analysis !== 'three_dimensional' &&
        row(
          'Support',
          '',
          bodies.map((body) => SUPPORTS[body?.support ?? 'clamped']?.toLowerCase()),
          '',
        ),
      row('Material', '', [materialName(job, 'upper'), materialName(job, 'lower')], ''),
      fieldsOf(
        (body) =>
          body?.material?.rigid
            ? []
            : [
                ...ELASTIC,
                ...(hasInitialStress(body?.material) ? [initialStressOf(job.analysis)] : []),
              ],
        (body) => body?.material,
      ),
      row(
        'Hardening',
        '',
        bodies.map((body) => LAWS[lawOf(body?.material)]?.label),
        '',
      ),
      fieldsOf(
        (body) => [
          ...(LAWS[lawOf(body?.material)]?.fields ?? []),
          ...(OVER_DEPTH[overDepthOf(body?.material)]?.fields ?? []),
          ...(body?.material?.plasticity?.backstress ? [BACKSTRESS] : []),
        ],
        (body) => body?.material?.plasticity,
      ),
      ...given.map((load) =>
        whole(
          [`${load.label} `, h('i', {}, symbol(load.symbol ?? ''))],
          writeWhole(pointer.get(job.load, `/${load.key}`)),
          unitOfLoad(job, load),
        ),
      ),
      ...(given.length ? [] : [whole('Load', 'onset of yield', '')]),
      // Elastic bodies have none.
      ...(theory ? [whole('Theory', THEORIES[theory]?.toLowerCase() ?? '', '')] : []),
      whole('Elements per half-width', writeValue(elements), ''),
      // Of the settings, those that are not as they are without a word.
      SETTINGS.filter(({ key }) => /^solver|accuracy/.test(key)).flatMap(({ key, label }) => {
        const value = pointer.get(job, `/${key}`);
        const usual = /** @type {Record<string, unknown>} */ (DEFAULTS)[`/${key}`];
        return value == null || value === usual ? [] : [whole(label, writeValue(value), '')];
      }),
    ),
  );
}

/** @param {Record<string, any>} surface */
const heightsWords = ({ heights, spacing_x, spacing_y, detrend }) =>
  `${heights?.length} × ${heights?.[0]?.length}, ${writeValue(spacing_x)} × ${writeValue(spacing_y)} apart${detrend === 'plane' ? ', mean plane taken away' : ''}`;

/**
 * Every step in figures: there is no room to say of each that it converged.
 * @param {Shown[]} shown
 */
function tableOf(shown) {
  const { columns, rows, write } = figuresTable(shown);
  const last = columns.length - 1;
  // A state that is not the usual one stands before the figures.
  return columns[last].title === 'state'
    ? { columns: columns.slice(0, last), rows: rows.map((row) => row.slice(0, last)), write }
    : { columns, rows, write };
}
