/**
 * The choice of a material for a body, and what one does with it: from a hardness, kept as one's
 * own, forgotten.
 */

import { h, plainButton, toast } from '../lib/dom.js';
import { toolbar } from '../lib/toolbar.js';
import { exact, unit, unitsOf } from '../lib/units.js';
import { symbol } from './entry.js';
import { lowered } from './field.js';
import { ELASTIC, LAWS, lawOf } from './fields.js';
import { allMaterials, askToForget, askToKeep, ownMaterials } from './library.js';
import { inMegapascals, materialOf } from './materials.js';
import { PRESETS } from './presets.js';

/** @typedef {import('./materials.js').Preset} Preset */

export class MaterialChoice {
  /**
   * @param {'upper' | 'lower'} body
   * @param {import('./draft.js').Draft} draft
   * @param {(material: Record<string, any>) => void} use called with the one that the body is to have
   * @param {() => HTMLElement | null} fault first field of the material that is wrong
   */
  constructor(body, draft, use, fault) {
    this.body = body;
    this.draft = draft;
    this.use = use;
    this.fault = fault;
    this.select = h('select', {
      'data-preset': body,
      onchange: () => this.#take(this.select.value),
    });
    this.drop = plainButton('Forget', () => this.#forget());
    this.drop.dataset.forget = body;
    this.tools = [
      plainButton('Hardness test…', () => this.#test()),
      plainButton('Keep as own…', () => this.#keep()),
      this.drop,
    ];
    for (const tool of this.tools) tool.dataset.rest = '';
    this.summary = h('p', { class: 'source summary' });
    this.origin = h('p', { class: 'source', 'data-source': body });
    this.elements = [
      h(
        'div',
        { class: 'entry choice' },
        h('label', {}, 'Material', h('span', { class: 'value' }, this.select)),
      ),
      toolbar(
        h(
          'div',
          { class: 'bar beside' },
          plainButton('From hardness…', async () =>
            (await import('./from-hardness.js')).askHardness((material) => this.#use(material)),
          ),
          ...this.tools,
        ),
        'Material',
      ),
      this.summary,
      this.origin,
    ];
    this.list();
  }

  /** Shows what there is to choose from. */
  list() {
    this.select.replaceChildren(...options());
    this.show();
  }

  /** Shows which one the draft has. */
  show() {
    const { job } = this.draft;
    const name = job[this.body]?.material?.name;
    const preset = allMaterials().find((one) => one.name === name);
    this.select.value = preset?.name ?? '';
    this.drop.hidden = !ownMaterials().some(({ name }) => name === preset?.name);
    this.origin.replaceChildren(...(preset ? symbol(preset.source) : []));
    const figures = figuresOf(job[this.body]?.material, unitsOf(job));
    this.summary.replaceChildren(...symbol(figures));
  }

  /** @param {string} name */
  #take(name) {
    const preset = allMaterials().find((one) => one.name === name);
    if (preset) this.#use(preset.material, name);
    else this.draft.set(`/${this.body}/material/name`, undefined, 'form');
    this.show();
  }

  /** @param {Record<string, any>} material in mm, N, MPa @param {string} [name] */
  #use(material, name) {
    const { name: _, ...figures } = materialOf({ material }, unitsOf(this.draft.job));
    this.use(name ? { name, ...figures } : figures);
  }

  async #test() {
    const { job } = this.draft;
    const { askTests } = await import('./hardness-test.js');
    askTests(job[this.body]?.material ?? {}, unitsOf(job));
  }

  #keep() {
    const fault = this.fault();
    if (fault) {
      toast('A material with a figure that is wrong is not kept');
      return fault.focus();
    }
    const { job } = this.draft;
    const { name: called, ...material } = inMegapascals(
      job[this.body]?.material ?? {},
      unitsOf(job),
    );
    askToKeep(material, called, (name) => {
      this.draft.set(`/${this.body}/material/name`, name, 'form');
    });
  }

  #forget() {
    // The button is gone with the material: the dialogue gives the focus back to the choice.
    this.select.focus();
    askToForget(this.select.value);
  }
}

/** What a material is, in one line. @param {Record<string, any> | undefined} material @param {import('../lib/units.js').Units} units */
function figuresOf(material, units) {
  const law = LAWS[lawOf(material)];
  const figures = (/** @type {import('./field.js').Field[]} */ fields, /** @type {any} */ of) =>
    fields.flatMap(({ key, symbol: name, quantity }) =>
      typeof of?.[key] === 'number' && name
        ? [
            `${name} ${exact(of[key])} ${quantity ? unit(/** @type {import('../lib/units.js').Quantity} */ (quantity), units) : ''}`.trim(),
          ]
        : [],
    );
  return [
    material?.name,
    ...figures(material?.rigid ? [] : ELASTIC, material),
    law && lowered(law.label),
    ...figures(law?.fields ?? [], material?.plasticity),
  ]
    .filter(Boolean)
    .join(', ');
}

/** Materials to choose from, one's own first. */
function options() {
  const own = ownMaterials();
  const named = (/** @type {Preset[]} */ list) =>
    list.map(({ name }) => h('option', { value: name }, name));
  return [
    h('option', { value: '' }, 'own figures'),
    ...(own.length
      ? [
          h('optgroup', { label: 'Own' }, named(own)),
          h('optgroup', { label: 'Library' }, named(PRESETS)),
        ]
      : named(PRESETS)),
  ];
}
