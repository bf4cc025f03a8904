/**
 * Other values of a number of the shown job: a sweep over it, what ± 10 % of it do, the value for
 * which an answer is as wanted, and tolerances. Every value of a sweep is a job of its own; a search
 * and tolerances are one.
 */

import { Problem } from '../api/client.js';
import { numbersOf, withValue } from '../jobs/numbers.js';
import { button, byId, h, plainButton, toast } from '../lib/dom.js';
import { readNumber } from '../lib/number.js';
import { endingAtErrors } from '../lib/tabular.js';
import { exact, plain } from '../lib/units.js';
import { lowered } from '../setup/field.js';
import { inWords } from '../setup/words.js';
import { answersOf, errorOf, shareOf, unitOf, wholeOf } from './answers.js';
import { Chart } from './chart.js';
import { cellsOf, scrolled, tableElements, takeAlong } from './figures.js';
import { looksOf, named, searchOf, tolerancesOf, tolerancesTable } from './find.js';
import { Panel } from './panel.js';
import { boundOf } from './rows.js';

/** @typedef {import('../types.js').Job} Job */
/** @typedef {import('../jobs/batch.js').Trial} Trial */
/** @typedef {import('../jobs/numbers.js').Numeric} Numeric */
/** @typedef {{at: number, id: string, answers: import('./answers.js').Answer[]}} Point */

/** Loaded when it is asked for. */
const batch = () => import('../jobs/batch.js');

/** Values of a sweep, as far as it goes to both sides. */
const [MANY, WIDE] = [9, 2];
/** What “± 10 %” stands for. */
const SPREAD = 0.1;
/** Answers beyond which a body is not safe: the share of its strength, and the factor on its load. */
const LIMITS = /** @type {Record<string, number>} */ ({
  utilization: 1,
  core_utilization: 1,
  margin: 1,
});

export class VaryPanel {
  /** @type {Job} */
  #job = {};
  /** @type {Numeric[]} */
  #numbers = [];
  /** Of the last sweep or search. @type {Point[]} */
  #points = [];
  /** @type {Numeric | undefined} */
  #varied;
  /** @type {AbortController | undefined} */
  #running;
  /** @type {import('./answers.js').Answer[]} */
  #answers = [];

  /** @param {{spread: (ids: string[]) => void, open: (id: string) => void, use: (job: Job) => void, listed: () => void}} on `spread`: lays jobs over the shown one; `use`: puts a job into the form */
  constructor(on) {
    this.on = on;
    this.number = h('select', {
      'aria-label': 'Number that is varied',
      onchange: () => this.#offer(),
    });
    this.from = box('From');
    this.to = box('To');
    this.many = box('How many');
    this.many.value = String(MANY);
    this.figure = h('select', { 'aria-label': 'Answer', onchange: () => this.#draw() });
    this.wanted = box('Wanted value');
    this.unit = h('span', { class: 'unit' });
    this.words = h('p', { class: 'readout', role: 'status' });
    this.chart = new Chart(240);
    this.table = h('table');
    this.whole = scrolled(this.table, 'values');
    this.stop = button('Stop', () => this.#running?.abort(), { hidden: true });
    const working = (
      /** @type {string} */ text,
      /** @type {string} */ title,
      /** @type {() => Promise<void>} */ work,
    ) => button(text, () => this.#run(work), { title });
    const tools = h(
      'div',
      { class: 'bar tools vary' },
      h('label', {}, 'Number ', this.number),
      working('± 10 %', 'Solve with 10 % less and 10 % more, and lay both over this job', () =>
        this.#spread(),
      ),
      h('span', { class: 'group' }, this.from, ' – ', this.to, ' in ', this.many),
      working('Sweep', 'Solve over these values', () => this.#sweep()),
      working('± tolerances', 'What 5 % of every input do to every answer', () =>
        this.#tolerances(),
      ),
      this.stop,
    );
    const find = h(
      'div',
      { class: 'bar tools vary' },
      h('label', {}, 'Answer ', this.figure),
      h('span', { class: 'group' }, this.wanted, this.unit),
      working(
        'Find the number',
        'Look for the value of the number with which the answer is this',
        () => this.#find(),
      ),
    );
    const content = [tools, find, this.words, this.chart.element, this.whole];
    this.panel = new Panel('vary', 'What if', content, { chart: this.chart });
    takeAlong(this.panel, 'values', () => this.#tableOf());
    this.#clear();
  }

  /** @param {import('../shown.js').Shown[]} shown @param {number} at step of the first */
  show(shown, at) {
    const [{ job, report, id }] = shown;
    this.panel.show(id !== '');
    // What a slider shows is no job that others are beside.
    if (id === '') return;
    const other = JSON.stringify(job) !== JSON.stringify(this.#job);
    this.#answers = answersOf(report, at);
    if (!other) return;
    this.#running?.abort();
    this.#job = job;
    this.#numbers = numbersOf(job);
    const before = this.number.value;
    this.number.replaceChildren(
      ...this.#numbers.map(({ key, label }) => h('option', { value: key }, label)),
    );
    if (this.#numbers.some(({ key }) => key === before)) this.number.value = before;
    this.#clear();
    this.#offer();
  }

  #clear() {
    this.#points = [];
    this.#varied = undefined;
    this.words.textContent = '';
    this.chart.element.hidden = this.whole.hidden = true;
  }

  get #number() {
    return this.#numbers.find(({ key }) => key === this.number.value) ?? this.#numbers[0];
  }

  /** Proposes values of the number, and answers to choose from. */
  #offer() {
    const number = this.#number;
    if (!number) return;
    const [low, high] = number.value === 0 ? [-1, 1] : [number.value / WIDE, number.value * WIDE];
    [this.from.value, this.to.value] = [low, high].map((one) => typed(one));
    const before = this.figure.value;
    this.figure.replaceChildren(
      ...this.#answers
        .filter(({ value }) => value !== null)
        .map(({ name, body, label }) =>
          h('option', { value: keyOf({ name, body }) }, label.replace('_', '')),
        ),
    );
    // A largest pressure has an optimum where the first answer may have none.
    for (const usual of [keyOf({ name: 'peak_pressure', body: null }), before])
      if ([...this.figure.options].some(({ value }) => value === usual)) this.figure.value = usual;
    this.#draw();
  }

  /** @param {() => Promise<void>} work */
  async #run(work) {
    this.#running?.abort();
    this.#running = new AbortController();
    const { signal } = this.#running;
    this.stop.hidden = false;
    try {
      await work();
    } catch (error) {
      if (!(error instanceof Problem) && !signal.aborted) throw error;
      if (!signal.aborted) this.words.textContent = /** @type {Error} */ (error).message;
    } finally {
      if (!signal.aborted || this.#running?.signal === signal) this.stop.hidden = true;
      this.on.listed();
    }
  }

  /** A job of a value, named by it. @param {Numeric} number @param {number} value @returns {Job} */
  #jobOf(number, value) {
    const { output, ...job } = withValue(this.#job, number, value);
    const words = `${number.label} ${exact(value)} ${number.unit}`.trim();
    return {
      ...job,
      ...(output && { output: { ...output, fields: false } }),
      tags: { ...job.tags, varied: words.slice(0, 256) },
    };
  }

  async #spread() {
    const { signal } = /** @type {AbortController} */ (this.#running);
    const number = this.#number;
    this.words.textContent = 'Solving with 10 % less and 10 % more…';
    const jobs = [1 - SPREAD, 1 + SPREAD].map((part) =>
      this.#jobOf(number, Number((part * number.value).toPrecision(12))),
    );
    const { solveAll } = await batch();
    const trials = await solveAll(jobs, signal, () => {});
    const failed = trials.find(({ problem }) => problem);
    this.words.textContent = failed
      ? `With another ${lowered(number.label)}: ${inWords(failed.problem ?? '')}.`
      : `${number.label} ± 10 %: each card has both answers, the charts both curves.`;
    const solved = trials.filter(({ report }) => report).map(({ id }) => id);
    if (solved.length === 0 || signal.aborted) return;
    this.on.spread(solved);
    byId('headline').scrollIntoView({ block: 'center' });
  }

  async #sweep() {
    const { signal } = /** @type {AbortController} */ (this.#running);
    const ends = this.#ends();
    const many = readNumber(this.many.value);
    if (!ends) return;
    if ('problem' in many) return void toast(many.problem);
    const [[low, high], count] = [ends, many.value];
    if (!(count >= 2 && count <= 100 && Number.isInteger(count)))
      return void toast('A sweep has 2 to 100 values.');
    // In equal ratios where both ends have a sign.
    const ratio = low > 0 && high > 0;
    const values = Array.from({ length: count }, (_, k) => {
      const t = k / (count - 1);
      return Number((ratio ? low * (high / low) ** t : low + t * (high - low)).toPrecision(4));
    });
    const number = this.#number;
    this.#clear();
    this.#varied = number;
    const { solveAll } = await batch();
    await solveAll(
      values.map((value) => this.#jobOf(number, value)),
      signal,
      (trials) => {
        this.#take(number, trials, values);
        const done = trials.filter((one) => one.done).length;
        const refused = trials.filter(({ problem }) => problem);
        this.words.textContent = [
          done < count ? `${done} of ${count} are solved.` : '',
          refused.length
            ? `${refused.length} have no answer: ${inWords(refused[0].problem ?? '')}.`
            : '',
        ]
          .filter(Boolean)
          .join(' ');
      },
    );
    this.#say();
  }

  /** @param {Numeric} number @param {Trial[]} trials @param {number[]} values */
  #take(number, trials, values) {
    this.#varied = number;
    this.#points = trials.flatMap(({ id, report }, k) => pointOf(values[k], id, report));
    this.#draw();
  }

  /** The ends in the boxes. @returns {[number, number] | undefined} none where they are no numbers */
  #ends() {
    const ends = [this.from, this.to].map(({ value }) => readNumber(value));
    const wrong = ends.find((one) => 'problem' in one);
    if (wrong && 'problem' in wrong) return void toast(wrong.problem);
    const [low, high] = /** @type {{value: number}[]} */ (ends).map(({ value }) => value);
    return [low, high];
  }

  /** Solves one job, and says what it has come to. @param {Job} job */
  async #ask(job) {
    const { signal } = /** @type {AbortController} */ (this.#running);
    const { newRun, solveOne } = await batch();
    const { id, report, problem } = await solveOne(job, signal, newRun());
    if (report && !signal.aborted) return { id, report };
    const why = `${inWords(named(problem ?? 'it was not solved', this.#numbers))}.`;
    this.words.textContent = signal.aborted ? '' : why;
    return undefined;
  }

  async #find() {
    const number = this.#number;
    const reading = readNumber(this.wanted.value);
    if ('problem' in reading) return void toast(reading.problem);
    const asked = this.#answers.find((one) => keyOf(one) === this.figure.value);
    const ends = this.#ends();
    if (!asked || !ends) return;
    this.#clear();
    this.#varied = number;
    this.words.textContent = 'Looking for it.';
    const wanted = reading.value / shareOf(asked);
    const { id, report } =
      (await this.#ask(searchOf(this.#job, number, asked, ends, wanted))) ?? {};
    if (!id || !report?.found) return;
    this.#points = looksOf(report.found, asked, id);
    this.#draw();
    const [value] = report.found.values;
    this.words.replaceChildren(
      `${named(report.found.text, this.#numbers)} `,
      plainButton('Put it into the form', () => this.on.use(withValue(this.#job, number, value))),
      plainButton('Show this job', () => this.on.open(id)),
    );
  }

  async #tolerances() {
    this.#clear();
    this.words.textContent = 'Solving with 5 % less and more of each input.';
    const { id, report } = (await this.#ask(tolerancesOf(this.#job, this.#numbers))) ?? {};
    if (!id || !report?.tolerances) return;
    const told = tolerancesTable(report.tolerances, this.#numbers);
    this.words.replaceChildren(
      `${named(report.tolerances.text, this.#numbers)} `,
      plainButton('Show this job', () => this.on.open(id)),
    );
    this.table.replaceChildren(...tableElements(told, () => ({})));
    this.whole.hidden = false;
  }

  /** Names the value at which the answer is least or largest, where that is between the ends. */
  #say() {
    const best = this.#optimum();
    if (!best || this.words.textContent) return;
    const { point, answer, end } = best;
    const number = this.#varied;
    this.words.replaceChildren(
      `${answer.label} is ${end} at ${lowered(number?.label ?? '')} ${plain(point.at, 5)} ${number?.unit}: ${wholeOf(answer)}. `,
      plainButton('Show this job', () => this.on.open(point.id)),
    );
  }

  /** @returns {{point: Point, answer: import('./answers.js').Answer, end: 'least' | 'largest'} | undefined} */
  #optimum() {
    const key = this.figure.value;
    const all = this.#points.flatMap((point) => {
      const answer = point.answers.find((one) => keyOf(one) === key);
      return answer && answer.value !== null ? [{ point, answer, value: answer.value }] : [];
    });
    const inner = (/** @type {typeof all[0]} */ one) =>
      one !== all[0] && one !== all[all.length - 1];
    const least = all.reduce((a, b) => (b.value < a.value ? b : a), all[0]);
    const most = all.reduce((a, b) => (b.value > a.value ? b : a), all[0]);
    if (all.length > 2 && inner(least)) return { ...least, end: 'least' };
    return all.length > 2 && inner(most) ? { ...most, end: 'largest' } : undefined;
  }

  #draw() {
    const key = this.figure.value;
    const asked = this.#answers.find((one) => keyOf(one) === key);
    this.unit.textContent = asked ? unitOf(asked) : '';
    const number = this.#varied;
    const curve = this.#points.flatMap(({ at, answers }) => {
      const answer = answers.find((one) => keyOf(one) === key);
      return answer && answer.value !== null
        ? [{ x: at, y: answer.value * shareOf(answer), answer }]
        : [];
    });
    this.chart.element.hidden = this.whole.hidden = curve.length < 2;
    if (!number || curve.length < 2) return;
    const [{ answer }] = curve;
    const limit = LIMITS[answer.name];
    const best = this.#optimum();
    this.chart.show({
      x: `${lowered(number.label)}  [${number.unit || '1'}]`,
      y: `${lowered(answer.label)}  [${unitOf(answer) || '1'}]`,
      curves: [
        ...(curve.every(({ answer }) => boundOf(answer) !== null)
          ? [
              {
                label: '±',
                colour: '--curve-1',
                x: curve.map(({ x }) => x),
                y: curve.map(({ y, answer }) => y * (1 - (boundOf(answer) ?? 0))),
                to: curve.map(({ y, answer }) => y * (1 + (boundOf(answer) ?? 0))),
              },
            ]
          : []),
        {
          label: lowered(answer.label),
          colour: '--curve-1',
          points: true,
          x: curve.map(({ x }) => x),
          y: curve.map(({ y }) => y),
        },
      ],
      marks: [
        { across: 'x', at: number.value, text: 'shown' },
        ...(best
          ? [
              {
                across: /** @type {const} */ ('x'),
                at: best.point.at,
                text: best.end,
                colour: '--good',
              },
            ]
          : []),
        ...(limit === undefined
          ? []
          : [
              {
                across: /** @type {const} */ ('y'),
                at: limit * shareOf(answer),
                text: 'limit',
                colour: '--yield',
              },
            ]),
      ],
      words: `${answer.label} over ${lowered(number.label)}, ${curve.length} values.`,
    });
    this.table.replaceChildren(
      ...tableElements(this.#tableOf(), (row) => ({
        class: 'choice',
        onclick: () => this.on.open(this.#points[row].id),
      })),
    );
  }

  /** The answer that is asked for before the others, each with its error. @returns {import('../lib/tabular.js').Table} */
  #tableOf() {
    const [first] = this.#points;
    const key = this.figure.value;
    const asked = (first?.answers ?? []).filter((one) => keyOf(one) === key);
    const all = [...asked, ...(first?.answers ?? []).filter((one) => keyOf(one) !== key)];
    const found = this.#points.map(({ answers }) =>
      all.map((one) => answers.find((other) => keyOf(other) === keyOf(one))),
    );
    const errors = all.map((_, k) => found.map((row) => row[k] && errorOf(row[k])));
    const barred = errors.map((ofOne) => ofOne.some(Boolean));
    const columns = [
      { title: lowered(this.#varied?.label ?? ''), unit: this.#varied?.unit },
      ...all.flatMap((answer, k) => {
        const title = lowered(answer.label);
        const error = { title: '±', of: title, unit: '%' };
        const exact = errors[k].every((one) => one === 0);
        return [{ title, unit: unitOf(answer), exact }, ...(barred[k] ? [error] : [])];
      }),
    ];
    const ending = endingAtErrors(columns);
    return {
      columns,
      rows: this.#points.map(({ at }, row) => [
        at,
        ...found[row].flatMap((answer, k) => cellsOf(answer, barred[k])),
      ]),
      write: (cell, k, row) => (k === 0 ? plain(Number(cell), 5) : ending(cell, k, row)),
    };
  }
}

/** @param {{name: string, body: string | null}} answer */
const keyOf = ({ name, body }) => `${name} ${body ?? ''}`;

/** @param {number} at @param {string} id @param {import('../types.js').Report} [report] @returns {Point[]} of its last step, where that is an answer */
function pointOf(at, id, report) {
  return report?.steps.at(-1)?.status === 'converged'
    ? [{ at, id, answers: answersOf(report, report.steps.length - 1) }]
    : [];
}

/** @param {number} value as it is typed */
const typed = (value) => String(Number(value.toPrecision(5)));

/** @param {string} label */
const box = (label) =>
  h('input', { type: 'text', inputmode: 'decimal', size: 7, 'aria-label': label });
