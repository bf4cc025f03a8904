/** Downloads. Files are fetched, so that the request carries the API key. */

import { Problem, request } from '../api/client.js';
import { h, plainButton, toast } from '../lib/dom.js';
import { stemOf } from '../jobs/names.js';

/** Time [ms] in which a download must start: the service writes a large file first. */
const LIMIT = 120_000;

/** @param {Blob} blob @param {string} name */
export function save(blob, name) {
  const url = URL.createObjectURL(blob);
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/**
 * @type {[name: string, path: string, file: string, needs: 'nothing' | 'subsurface' | 'fields' |
 *   'layers' | 'flow' | 'curve' | 'rolling'][]}
 */
const FILES = [
  ['Result, JSON', 'result', 'result.json', 'nothing'],
  ['Job, JSON', 'request', 'job.json', 'nothing'],
  ['Pressure, CSV', 'pressure.csv', 'pressure.csv', 'nothing'],
  ['Depth profiles, CSV', 'subsurface.csv', 'subsurface.csv', 'subsurface'],
  ['Increments, CSV', 'increments.csv', 'increments.csv', 'flow'],
  ['Passes, CSV', 'passes.csv', 'passes.csv', 'rolling'],
  ['Surfaces, CSV', 'surface.csv', 'surface.csv', 'flow'],
  ['Field, VTU', 'field.vtu', 'field.vtu', 'fields'],
  ['Layers, VTR', 'field.vtr', 'field.vtr', 'layers'],
  ['Pressure, SVG', 'pressure.svg', 'pressure.svg', 'nothing'],
  ['Depth profiles, SVG', 'depth.svg', 'depth.svg', 'subsurface'],
  ['Force over approach, SVG', 'load_approach.svg', 'load_approach.svg', 'curve'],
  ['Surfaces, SVG', 'surface.svg', 'surface.svg', 'flow'],
];

/** Files of one step: those of a sweep are of the step that is shown. */
const OF_STEP = /^(?!load_approach).*\.(svg|vt[ru])$/;

/** All that is taken along of a result: files of the service, pictures and tables of the panels. */
export class Downloads {
  #list = h('ul');
  element = h('details', { class: 'menu' }, h('summary', {}, 'Download'), this.#list);

  /**
   * @param {import('../shown.js').Shown} shown without an id what no job is
   * @param {number} at step, counted from 0
   * @param {{title: string, element: HTMLElement, exports: HTMLElement[]}[]} panels
   */
  show({ id, job, report }, at, panels) {
    const own = panels.filter(({ element, exports }) => exports.length && !element.hidden);
    this.#list.replaceChildren(
      ...own.map(({ title, exports }) =>
        h(
          'li',
          { class: 'of-panel' },
          h('span', {}, title),
          h('span', { class: 'group' }, exports),
        ),
      ),
      ...(id
        ? [
            h('li', { class: 'quiet' }, 'Files, in the units of the job'),
            ...files(id, job, report, at),
          ]
        : []),
    );
  }
}

/** @param {string} id @param {import('../types.js').Job} job @param {import('../types.js').Report} report @param {number} at step */
function files(id, job, report, at) {
  const fields = Boolean(job.output?.fields);
  const step = report.steps[0];
  const there = {
    nothing: true,
    fields: fields && step?.passes === undefined,
    layers: fields && report.analysis === 'three_dimensional',
    subsurface: step?.subsurface !== undefined,
    flow: step?.increments !== undefined,
    rolling: step?.passes !== undefined,
    curve: Boolean(report.load_approach),
  };
  return FILES.filter(([, , , needs]) => there[needs]).map(([name, path, file]) => {
    const of = report.steps.length > 1 && OF_STEP.test(path) ? at + 1 : 0;
    const onclick = () => take(id, path, file, of, stemOf(job, id));
    return h('li', {}, plainButton(name, onclick));
  });
}

/**
 * @param {string} id
 * @param {string} path
 * @param {string} file
 * @param {number} step counted from 1; 0 for all
 * @param {string} stem with which its name begins
 */
async function take(id, path, file, step, stem) {
  try {
    const response = await request(
      `v1/jobs/${id}/${path}${step ? `?step=${step}` : ''}`,
      { limit: LIMIT },
      (one) => one,
    );
    save(await response.blob(), `${stem}-${step ? `step-${step}-` : ''}${file}`);
  } catch (error) {
    toast(`${file}: ${error instanceof Problem ? error.message : error}`);
  }
}
