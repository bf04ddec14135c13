// Pointers and wheel on a picture: one pointer moves it, two pointers and the wheel zoom it.

interface Acts {
  // false ignores the pointer
  down?(event: PointerEvent): boolean | void;
  // dx, dy: pixels; count: number of pressed pointers
  move(dx: number, dy: number, event: PointerEvent, count: number): void;
  hover?(event: PointerEvent): void;
  // x, y: pixels from the upper left corner
  zoom(by: number, x: number, y: number): void;
  up?(event: PointerEvent): void;
  wheels(): boolean;
}

// Returns a function that returns the length of the last movement (pixels).
export function listen_pointers(place: HTMLElement, { down, move, hover, zoom, up, wheels }: Acts): () => number {
  const pressed = new Map<number, number[]>();
  let moved = 0;
  function zoom_at(by: number, x: number, y: number) {
    const { left, top } = place.getBoundingClientRect();
    zoom(by, x - left, y - top);
  }
  const gap = ([a, b]: number[][]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  place.addEventListener('pointerdown', (event) => {
    if (down?.(event) === false) return;
    pressed.set(event.pointerId, [event.clientX, event.clientY]);
    moved = 0;
  });
  place.addEventListener('pointermove', (event) => {
    const { pointerId, clientX: x, clientY: y } = event, from = pressed.get(pointerId), n = pressed.size;
    if (!from) { hover?.(event); return; }
    const before = [...pressed.values()], [dx, dy] = [x - from[0], y - from[1]];
    pressed.set(pointerId, [x, y]);
    moved += Math.abs(dx) + Math.abs(dy);
    move(dx / n, dy / n, event, n);
    if (n !== 2 || !gap(before)) return;
    const [a, b] = pressed.values();
    zoom_at(gap([a, b]) / gap(before), (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
  });
  (['pointerup', 'pointercancel', 'pointerleave'] as const).forEach((name) => place.addEventListener(name, (event) => {
    if (pressed.delete(event.pointerId)) up?.(event);
  }));
  place.addEventListener('wheel', (event) => {
    if (!wheels()) return;
    event.preventDefault();
    zoom_at(Math.exp(-event.deltaY * 0.0015), event.clientX, event.clientY);
  }, { passive: false });
  return () => moved;
}
