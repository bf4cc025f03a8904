/** A row of buttons that is one stop on the way of Tab: arrows, Home and End go along it. */

/** @param {HTMLElement} bar whose first button is always there @param {string} name */
export function toolbar(bar, name) {
  const all = () => /** @type {HTMLElement[]} */ ([...bar.querySelectorAll('button, a')]);
  const stopAt = (/** @type {EventTarget | null} */ one) => {
    for (const button of all()) button.tabIndex = button === one ? 0 : -1;
  };
  bar.setAttribute('role', 'toolbar');
  bar.setAttribute('aria-label', name);
  bar.addEventListener('focusin', ({ target }) => stopAt(target));
  // The one that had the focus may be hidden when Tab comes back.
  bar.addEventListener('focusout', () => stopAt(all()[0]));
  bar.addEventListener('keydown', (event) => {
    const shown = all().filter((button) => button.checkVisibility());
    const [at, last] = [shown.findIndex((button) => button === event.target), shown.length - 1];
    const places = {
      ArrowRight: at < last ? at + 1 : 0,
      ArrowLeft: at > 0 ? at - 1 : last,
      Home: 0,
      End: last,
    };
    const next = places[/** @type {keyof typeof places} */ (event.key)];
    if (next === undefined) return;
    event.preventDefault();
    shown[next]?.focus();
  });
  stopAt(all()[0]);
  return bar;
}
