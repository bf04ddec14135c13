import { say } from './element';
import type { Measured } from './scene';

// Returns about `wanted` round numbers between low and high.
export function ticks(low: number, high: number, wanted: number) {
  const rough = (high - low) / Math.max(wanted, 1);
  const power = Math.pow(10, Math.floor(Math.log10(rough)));
  const step = [1, 2, 5, 10].map((m) => m * power)
    .filter((s) => s >= rough * 0.999)[0];
  const out: number[] = [];
  for (let t = Math.ceil(low / step - 1e-9); t * step <= high * (1 + 1e-9); t++) {
    out.push(Number((t * step).toPrecision(12)));
  }
  return out;
}

export interface About {
  times: number[];
  // first and last time
  range: number[];
  // labels of the two ends, or one label below numbers
  ends?: string[];
  axis?: string;
  // unit of the times
  unit?: string;
  // called on click and drag
  seek?(time: number): void;
}
export interface Graph {
  draw(one: Measured): void;
  // Moves the time cursor.
  mark(time: number): void;
  // Returns a data URL.
  png(): Promise<string>;
}

// Draws a measure against time or another variable as an SVG.
export function new_graph(host: HTMLElement, about: About): Graph {
  const space = 'http://www.w3.org/2000/svg', left = 48, right = 10;
  const top = about.axis ? 22 : 8, foot = about.axis ? 34 : 16;
  let wide = 300, tall = 92, now = about.range[0], low = 0, high = 1, shown: Measured | null = null;
  let cursor: SVGElement | null = null, tip: SVGElement | null = null;
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('role', 'img');
  host.appendChild(svg);

  function across(time: number) {
    return left + (wide - left - right) * (time - about.range[0]) / (about.range[1] - about.range[0]);
  }
  function up(value: number) { return top + (tall - top - foot) * (high - value) / (high - low); }
  function add(name: string, attributes: Record<string, string | number>, words?: string) {
    const made = document.createElementNS(space, name);
    Object.entries(attributes).forEach(([key, value]) => { made.setAttribute(key, String(value)); });
    if (words !== undefined) made.textContent = words;
    svg.appendChild(made);
    return made;
  }
  function write(x: number, y: number, anchor: string, words: string) {
    return add('text', { x, y, 'text-anchor': anchor, 'font-size': 11, fill: '#3c454c', stroke: '#fff',
      'stroke-width': 3, 'paint-order': 'stroke', 'font-family': 'system-ui, sans-serif' }, words);
  }
  function words(x: number) {
    const plain = String(Number(x.toPrecision(4)));
    return plain.length > 7 ? x.toExponential(1) : plain;
  }
  // JSON has no NaN, so unknown values are null.
  function number(value: number | null | string | undefined): number {
    return value === null || value === undefined ? NaN : Number(value);
  }

  function axes(marks: number[]) {
    add('path', {
      d: 'M' + left + ',' + top + 'V' + (tall - foot) + 'H' + (wide - right), fill: 'none', stroke: '#78838c'
    });
    marks.forEach((mark) => {
      add('path', { d: 'M' + left + ',' + up(mark) + 'H' + (wide - right), stroke: '#dfe5ea' });
      write(left - 4, up(mark) + 4, 'end', words(mark));
    });
    if (!about.axis) {
      write(left, tall - 4, 'start', about.ends?.[0] ?? '');
      write(wide - right, tall - 4, 'end', about.ends?.[1] ?? '');
      return;
    }
    ticks(about.range[0], about.range[1], wide / 70).forEach((at) => {
      add('path', { d: 'M' + across(at) + ',' + (tall - foot) + 'v4', stroke: '#78838c' });
      write(across(at), tall - foot + 15, 'middle', words(at));
    });
    write((left + wide - right) / 2, tall - 4, 'middle', about.axis);
  }

  function draw(one: Measured) {
    shown = one;
    wide = svg.clientWidth || 300;
    tall = svg.clientHeight || 92;
    svg.setAttribute('viewBox', '0 0 ' + wide + ' ' + tall);
    const values = one.values.map(number), errors = (one.errors || []).map(number);
    const known = values.filter(isFinite);
    svg.textContent = '';
    if (!known.length) { svg.setAttribute('aria-label', one.words + ' is not known'); return; }
    low = Math.min.apply(null, known);
    high = Math.max.apply(null, known);
    values.forEach((value, k) => {
      if (!isFinite(value) || !isFinite(errors[k])) return;
      low = Math.min(low, value - errors[k]);
      high = Math.max(high, value + errors[k]);
    });
    if (high - low < 1e-9 * Math.max(Math.abs(high), 1e-9)) { low -= 0.5; high += 0.5; }
    svg.setAttribute('aria-label', one.words + ' from ' + words(low) + ' to ' + words(high));
    const marks = ticks(low, high, (tall - top - foot) / 35);
    if (about.axis && marks.length > 1) {
      low = Math.min(low, marks[0]);
      high = Math.max(high, marks[marks.length - 1]);
    }
    axes(marks);
    let path = '', on = false;
    values.forEach((value, k) => {
      if (isFinite(value)) {
        path += (on ? 'L' : 'M') + across(about.times[k]).toFixed(1) + ',' + up(value).toFixed(1);
      }
      on = isFinite(value);
    });
    add('path', { d: path, fill: 'none', stroke: '#0b6e99', 'stroke-width': 1.8 });
    if (about.axis) {
      values.forEach((value, k) => {
        if (!isFinite(value)) return;
        const x = across(about.times[k]);
        if (isFinite(errors[k])) {
          add('path', { d: 'M' + x + ',' + up(value - errors[k]) + 'V' + up(value + errors[k]), stroke: '#0b6e99' });
        }
        add('circle', { cx: x, cy: up(value), r: 2.6, fill: '#0b6e99' });
      });
    }
    cursor = add('line', { y1: top, y2: tall - foot, stroke: '#b3005c', 'stroke-width': 1.5 });
    tip = write(wide - right, about.axis ? 11 : top + 9, 'end', '');
    mark(now);
  }

  function mark(time: number) {
    now = time;
    if (!cursor) return;
    cursor.setAttribute('visibility', now >= about.range[0] && now <= about.range[1] ? 'visible' : 'hidden');
    cursor.setAttribute('x1', String(across(now)));
    cursor.setAttribute('x2', String(across(now)));
    tell(now);
  }

  function time_at(event: PointerEvent) {
    const at = svg.getBoundingClientRect(), x = (event.clientX - at.left) / at.width * wide;
    const time = about.range[0] + (about.range[1] - about.range[0]) * (x - left) / (wide - left - right);
    return Math.min(Math.max(time, about.range[0]), about.range[1]);
  }
  // Displays the value nearest to a time.
  function tell(time: number) {
    if (!tip || !shown) return;
    let best = -1;
    shown.values.forEach((value, k) => {
      if (!isFinite(number(value))) return;
      if (best < 0 || Math.abs(about.times[k] - time) < Math.abs(about.times[best] - time)) best = k;
    });
    if (best < 0) return;
    const error = number((shown.errors || [])[best]);
    tip.textContent = words(about.times[best]) + (about.unit ? ' ' + about.unit : '') + ': ' +
      words(number(shown.values[best])) +
      (isFinite(error) ? ', ' + say('computed to {n}', { n: Number(error.toPrecision(2)) }) : '');
  }
  svg.addEventListener('pointerdown', (event) => {
    if (!about.seek) { tell(time_at(event)); return; }
    svg.setPointerCapture(event.pointerId);
    about.seek(time_at(event));
  });
  svg.addEventListener('pointermove', (event) => {
    if (about.seek && event.buttons) about.seek(time_at(event));
    tell(time_at(event));
  });
  svg.addEventListener('pointerleave', () => tell(now));
  // Labels keep their size, so another width requires a new drawing.
  new window.ResizeObserver(() => {
    if (shown && svg.clientWidth && svg.clientWidth !== wide) draw(shown);
  }).observe(svg);

  // Renders at three times the size, on white, with the measure's name as the title.
  function png() {
    const copy = svg.cloneNode(true) as SVGElement, scale = 3, head = 20, image = new Image();
    copy.setAttribute('width', String(wide));
    copy.setAttribute('height', String(tall));
    image.src = 'data:image/svg+xml;charset=utf-8,' +
      encodeURIComponent(new XMLSerializer().serializeToString(copy));
    return image.decode().then(() => {
      const canvas = document.createElement('canvas'), paper = canvas.getContext('2d') as CanvasRenderingContext2D;
      canvas.width = scale * wide;
      canvas.height = scale * (tall + head);
      paper.scale(scale, scale);
      paper.fillStyle = '#ffffff';
      paper.fillRect(0, 0, wide, tall + head);
      paper.fillStyle = '#202428';
      paper.font = '600 13px system-ui, sans-serif';
      paper.fillText(shown?.words ?? '', 8, 15);
      paper.drawImage(image, 0, head, wide, tall);
      return canvas.toDataURL('image/png');
    });
  }
  return { draw, mark, png };
}
