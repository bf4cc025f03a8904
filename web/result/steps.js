/** Which step of a sweep is shown: by a slider, or played through. */

import { h } from '../lib/dom.js';

/** Time [ms] that a step stays while they are played. */
const PACE = 400;

export class Steps {
  #many = 1;
  #at = 0;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #timer;

  /**
   * @param {(step: number) => void} choose
   * @param {() => boolean} ready whether the step that was chosen is shown: the next one waits for
   *   it
   */
  constructor(choose, ready) {
    this.choose = choose;
    this.ready = ready;
    this.label = h('output');
    this.slider = h('input', {
      type: 'range',
      min: 0,
      oninput: () => {
        this.stop();
        choose(Number(this.slider.value));
      },
    });
    this.button = h('button', {
      type: 'button',
      class: 'plain play',
      onclick: () => (this.#timer ? this.stop() : this.#play()),
    });
    this.element = h(
      'div',
      { class: 'steps', hidden: true },
      this.button,
      h('label', {}, 'Step ', this.slider),
      this.label,
    );
    this.stop();
  }

  /** @param {number} many @param {number} at @param {string} load */
  show(many, at, load) {
    this.#many = many;
    this.#at = at;
    this.element.hidden = many < 2;
    this.slider.max = String(many - 1);
    this.slider.value = String(at);
    this.label.textContent = `${at + 1} of ${many}: ${load}`;
    this.slider.setAttribute('aria-valuetext', this.label.textContent);
  }

  stop() {
    clearInterval(this.#timer);
    this.#timer = undefined;
    this.button.textContent = '▶';
    this.button.setAttribute('aria-label', 'Play through the steps');
  }

  #play() {
    this.button.textContent = '❚❚';
    this.button.setAttribute('aria-label', 'Stop playing');
    if (this.#at === this.#many - 1) this.choose(0);
    this.#timer = setInterval(() => {
      if (document.hidden || !this.ready()) return;
      if (this.#at < this.#many - 1) this.choose(this.#at + 1);
      if (this.#at === this.#many - 1) this.stop();
    }, PACE);
  }
}
