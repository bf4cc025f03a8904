/** Which jobs the page shows. */

/** @typedef {import('./shown.js').Shown} Shown */
/** @typedef {import('./types.js').Job} Job */
/**
 * @typedef {object} State
 * @property {{id: string, job: Job} | undefined} current without an id what a slider shows
 * @property {Shown | undefined} first its result
 * @property {ReadonlyMap<string, Shown>} compared jobs that are laid over it
 * @property {ReadonlySet<string>} chosen in the list, maybe on their way
 */
/**
 * @typedef {{type: 'opened', id: string, job: Job} | {type: 'solved', shown: Shown}
 *   | {type: 'removed', id: string} | {type: 'left'} | {type: 'chosen', id: string}
 *   | {type: 'laid', shown: Shown} | {type: 'dropped', ids: string[]}
 *   | {type: 'only', ids: string[]}} Event
 */

/** @type {State} */
export const NOTHING = {
  current: undefined,
  first: undefined,
  compared: new Map(),
  chosen: new Set(),
};

/** @param {State} state @param {Event} event @returns {State} */
export function after(state, event) {
  switch (event.type) {
    case 'opened':
      return { ...state, current: { id: event.id, job: event.job }, first: undefined };
    case 'solved':
      return { ...state, first: event.shown };
    case 'removed': {
      const { first } = state;
      return first?.id === event.id ? { ...state, first: { ...first, removed: true } } : state;
    }
    case 'left':
      return { ...state, current: undefined, first: undefined };
    case 'chosen':
      return { ...state, chosen: new Set([...state.chosen, event.id]) };
    case 'laid':
      return {
        ...state,
        compared: new Map([...state.compared, [event.shown.id, event.shown]]),
      };
    case 'dropped':
      return without(state, (id) => event.ids.includes(id));
    case 'only':
      return { ...without(state, (id) => !event.ids.includes(id)), chosen: new Set() };
  }
}

/** @param {State} state @param {(id: string) => boolean} is @returns {State} */
const without = (state, is) => ({
  ...state,
  compared: new Map([...state.compared].filter(([id]) => !is(id))),
  chosen: new Set([...state.chosen].filter((id) => !is(id))),
});

export class Store {
  /** @type {State} */
  state = NOTHING;

  /** @param {Event} event */
  take(event) {
    this.state = after(this.state, event);
  }
}
