/**
 * Solves while a slider moves. One job is under way at a time, and the newest draft is next: every
 * answer is shown, the last one wins. A job that is slow is given up as soon as there is a newer
 * draft, which costs the service nothing more.
 */

import { Problem } from '../api/client.js';
import { solveNow } from '../api/result.js';
import { numberOf } from '../lib/number.js';
import { oneMesh } from './accuracy.js';
import { usualElements } from './fields.js';

/** Elements per half-width while the slider moves; cells of half-spaces are more for the same number. @param {Job} job */
export const coarse = ({ analysis }) => (analysis === 'three_dimensional' ? 4 : 10);
/** Time [ms] after which a job that has been overtaken is given up. */
const SLOW = 400;

/** @typedef {import('../types.js').Job} Job */
/** @typedef {{job: Job, solved: Job, moving: boolean}} Asked the draft, what of it is solved, and whether more is to come */

export class Live {
  /** @type {Asked | undefined} */
  #next;
  /** @type {{since: number, controller: AbortController} | undefined} */
  #running;

  /** @param {{begun: (job: Job) => void, solved: (asked: Asked, report: import('../types.js').Report) => void, failed: (problem: Problem) => void}} on `begun`: where the slider was left is being solved */
  constructor(on) {
    this.on = on;
  }

  /** @param {Job} job @param {boolean} moving whether more is to come */
  ask(job, moving) {
    const copy = structuredClone(job);
    const elements = numberOf(job.mesh?.elements_per_half_width ?? usualElements(job));
    const few = coarse(job);
    const mesh = elements > few ? { ...copy.mesh, elements_per_half_width: few } : copy.mesh;
    const solved = moving ? { ...copy, mesh: oneMesh({ mesh }) } : copy;
    this.#next = { job: copy, solved, moving };
    if (!this.#running) this.#run();
    else if (performance.now() - this.#running.since > SLOW) this.#running.controller.abort();
  }

  /** Forgets what is under way. */
  stop() {
    this.#next = undefined;
    this.#running?.controller.abort();
  }

  async #run() {
    while (this.#next) {
      const asked = this.#next;
      this.#next = undefined;
      const controller = new AbortController();
      this.#running = { since: performance.now(), controller };
      if (!asked.moving) this.on.begun(asked.job);
      try {
        const report = await solveNow(asked.solved, controller.signal);
        if (!controller.signal.aborted) this.on.solved(asked, report);
      } catch (error) {
        if (controller.signal.aborted) continue;
        if (!(error instanceof Problem)) throw error;
        this.on.failed(error);
      } finally {
        this.#running = undefined;
      }
    }
  }
}
