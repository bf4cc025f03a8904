/** A framed part of the result: title, controls, content, and a picture to save where there is one. */

import { h } from '../lib/dom.js';
import { save } from './downloads.js';

export class Panel {
  /**
   * @param {string} id
   * @param {string} title
   * @param {Node[]} content
   * @param {{controls?: Node[], picture?: () => Promise<Blob | null>}} [options]
   */
  constructor(id, title, content, { controls = [], picture } = {}) {
    const button =
      picture &&
      h(
        'button',
        {
          type: 'button',
          class: 'plain',
          title: 'Save as a picture',
          'aria-label': `Save ${title.toLowerCase()} as PNG`,
          onclick: async () => {
            const blob = await picture();
            if (blob) save(blob, `${id}.png`);
          },
        },
        'PNG',
      );
    this.element = h(
      'section',
      { class: 'panel', id: `panel-${id}`, 'aria-labelledby': `panel-${id}-title`, hidden: true },
      h('div', { class: 'bar' }, h('h3', { id: `panel-${id}-title` }, title), controls, button ?? null),
      content,
    );
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
    const input = h('input', { type: 'radio', name, value, checked: k === 0, onchange: () => change(value) });
    return h('label', {}, input, h('span', {}, text));
  });
  return h('fieldset', { class: 'segments', 'aria-label': label }, inputs);
}
