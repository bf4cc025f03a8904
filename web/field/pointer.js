/** Moving about in the field by mouse, finger and keyboard. */

/** @typedef {import('./camera.js').Camera} Camera */

const STEP = 40;
const FACTOR = 1.25;

/**
 * @param {HTMLElement} element
 * @param {Camera} camera
 * @param {{moved: () => void, home: () => void, probe: (at: [number, number] | null) => void, line: (from: [number, number], to: [number, number]) => void}} on
 */
export function steer(element, camera, on) {
  const down = /** @type {Map<number, [number, number]>} */ (new Map());
  const at = (/** @type {MouseEvent} */ event) => {
    const box = element.getBoundingClientRect();
    return /** @type {[number, number]} */ ([event.clientX - box.left, event.clientY - box.top]);
  };
  /** Where a line begins that is being drawn. @type {[number, number] | undefined} */
  let begin;
  element.addEventListener('pointerdown', (event) => {
    begin = element.classList.contains('cutting') ? at(event) : undefined;
    down.set(event.pointerId, at(event));
    element.setPointerCapture(event.pointerId);
    // A finger that taps reads; it moves the field only from a second one on, for the page scrolls
    // under it.
    if (event.pointerType === 'touch') on.probe(at(event));
  });
  element.addEventListener('pointermove', (event) => {
    const now = at(event);
    const before = down.get(event.pointerId);
    if (begin && before) on.line(begin, now);
    else if (before) {
      drag(camera, down, before, now, event.pointerId);
      on.moved();
    }
    on.probe(now);
  });
  const up = (/** @type {PointerEvent} */ event) => down.delete(event.pointerId);
  element.addEventListener('pointerup', up);
  element.addEventListener('pointercancel', up);
  element.addEventListener('pointerleave', (event) => {
    if (event.pointerType === 'mouse') on.probe(null);
  });
  element.addEventListener('dblclick', on.home);
  // The page scrolls on over a field that has not been clicked.
  element.addEventListener(
    'wheel',
    (event) => {
      if (document.activeElement !== element && !event.ctrlKey) return;
      event.preventDefault();
      camera.zoom(Math.exp(-event.deltaY / 400), ...at(event));
      on.moved();
    },
    { passive: false },
  );
  element.addEventListener('keydown', (event) => key(event, camera, on));
}

/** One finger moves, two also stretch. @param {Camera} camera @param {Map<number, [number, number]>} down @param {[number, number]} before @param {[number, number]} now @param {number} id */
function drag(camera, down, before, now, id) {
  const other = [...down].find(([one]) => one !== id)?.[1];
  if (other) {
    const distance = (/** @type {[number, number]} */ [x, y]) =>
      Math.hypot(x - other[0], y - other[1]);
    camera.zoom(distance(now) / (distance(before) || 1), ...other);
  } else {
    camera.pan(now[0] - before[0], now[1] - before[1]);
  }
  down.set(id, now);
}

/** @param {KeyboardEvent} event @param {Camera} camera @param {{moved: () => void, home: () => void, probe: (at: [number, number]) => void}} on */
function key(event, camera, on) {
  const actions = /** @type {Record<string, () => void>} */ ({
    ArrowLeft: () => camera.pan(STEP, 0),
    ArrowRight: () => camera.pan(-STEP, 0),
    ArrowUp: () => camera.pan(0, STEP),
    ArrowDown: () => camera.pan(0, -STEP),
    '+': () => camera.zoom(FACTOR),
    '=': () => camera.zoom(FACTOR),
    '-': () => camera.zoom(1 / FACTOR),
    0: on.home,
  });
  const action = event.ctrlKey || event.metaKey ? undefined : actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
  on.moved();
  on.probe([camera.width / 2, camera.height / 2]);
}
