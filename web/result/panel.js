/**
 * A framed part of the result: title, controls, content, and a picture to save where there is one.
 */

import { h, plainButton, toast } from '../lib/dom.js';
import { svgFile } from './chart-svg.js';
import { save } from './downloads.js';

/** @typedef {{picture: (title: string) => Promise<Blob | null>, drawing?: (title: string) => SVGSVGElement | null}} Drawn what there are pictures of */

export class Panel {
  /**
   * @param {string} id
   * @param {string} title
   * @param {Node[]} content
   * @param {{controls?: Node[], chart?: Drawn}} [options]
   */
  constructor(id, title, content, { controls = [], chart } = {}) {
    this.title = title;
    this.id = id;
    const button = (
      /** @type {'PNG' | 'SVG'} */ kind,
      /** @type {(words: string) => Promise<Blob | null>} */ make,
    ) =>
      plainButton(
        kind,
        async () => {
          const blob = await make(this.caption);
          if (blob) save(blob, this.fileName(kind.toLowerCase()));
          else toast('There is no picture of it yet');
        },
        { 'data-of': id, 'aria-label': `Save ${title.toLowerCase()} as ${kind}` },
      );
    const vector = async (/** @type {string} */ words) => {
      const made = chart?.drawing?.(words);
      return made ? svgFile(made) : null;
    };
    this.element = h(
      'section',
      { class: 'panel', id: `panel-${id}`, 'aria-labelledby': `panel-${id}-title`, hidden: true },
      h('div', { class: 'bar' }, h('h3', { id: `panel-${id}-title` }, title), controls),
      content,
    );
    /** Buttons by which it is taken along, for the menu of them all. */
    this.exports = [
      ...(chart ? [button('PNG', (words) => chart.picture(words))] : []),
      ...(chart?.drawing ? [button('SVG', vector)] : []),
    ];
  }

  /** Title and what the figures are of, as pictures have it. */
  get caption() {
    return [this.title, this.of].filter(Boolean).join(', ');
  }

  /** What is shown: job and step. */
  of = '';

  /** The same as names of files begin. */
  stem = '';

  /** @param {string} ending @returns {string} */
  fileName(ending) {
    return `${this.stem ? `${this.stem}-` : ''}${this.id}.${ending}`;
  }

  /** @param {string} title */
  rename(title) {
    this.title = title;
    /** @type {HTMLElement} */ (this.element.querySelector('h3')).textContent = title;
  }

  /** @param {boolean} shown */
  show(shown) {
    this.element.hidden = !shown;
  }
}

/**
 * A few choices side by side, of which one holds.
 * @param {string} label
 * @param {Record<string, string>} choices value: text
 * @param {(value: string) => void} change
 */
export function segments(label, choices, change) {
  const name = `segments-${Math.random().toString(36).slice(2)}`;
  const inputs = Object.entries(choices).map(([value, text], k) => {
    const input = h('input', {
      type: 'radio',
      name,
      value,
      checked: k === 0,
      onchange: () => change(value),
    });
    return h('label', {}, input, h('span', {}, text));
  });
  return h('fieldset', { class: 'segments', 'aria-label': label }, inputs);
}
