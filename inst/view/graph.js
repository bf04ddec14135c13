// Returns about `wanted` round numbers between low and high.
window.codendView = window.codendView || {};
window.codendView.ticks = function (low, high, wanted) {
  'use strict';
  var rough = (high - low) / Math.max(wanted, 1);
  var power = Math.pow(10, Math.floor(Math.log10(rough)));
  var step = [1, 2, 5, 10].map(function (m) { return m * power; })
    .filter(function (s) { return s >= rough * 0.999; })[0];
  var out = [];
  for (var t = Math.ceil(low / step - 1e-9); t * step <= high * (1 + 1e-9); t++) {
    out.push(Number((t * step).toPrecision(12)));
  }
  return out;
};

// codendView.graph(host, about) draws a measure against time or another variable as an SVG.
// `about` contains:
//   `times` of the values.
//   `range`: first and last time.
//   `ends` or `axis`: labels of the two ends, or one label below numbers.
//   `unit` of the times.
//   `seek(time)` is optional and is called on click and drag.
// Methods:
//   `draw(one)` draws {words, values, errors}.
//   `mark(time)` moves the time cursor.
//   `png()` returns a promise of a data URL.
window.codendView.graph = function (host, about) {
  'use strict';
  var space = 'http://www.w3.org/2000/svg', left = 48, right = 10, top = 8, foot = about.axis ? 34 : 16;
  var wide = 300, tall = 92, cursor = null, now = about.range[0], shown = null, tip = null, low, high;
  var svg = document.createElementNS(space, 'svg');
  svg.setAttribute('role', 'img');
  host.appendChild(svg);

  function across(time) {
    return left + (wide - left - right) * (time - about.range[0]) / (about.range[1] - about.range[0]);
  }
  function up(value) { return top + (tall - top - foot) * (high - value) / (high - low); }
  function add(name, attributes, words) {
    var made = document.createElementNS(space, name);
    Object.keys(attributes).forEach(function (key) { made.setAttribute(key, attributes[key]); });
    if (words !== undefined) made.textContent = words;
    svg.appendChild(made);
    return made;
  }
  function write(x, y, anchor, words) {
    return add('text', { x: x, y: y, 'text-anchor': anchor, 'font-size': 11, fill: '#3c454c',
      'font-family': 'system-ui, sans-serif' }, words);
  }
  function words(x) {
    var plain = String(Number(x.toPrecision(4)));
    return plain.length > 7 ? x.toExponential(1) : plain;
  }
  // JSON has no NaN, so unknown values are null.
  function number(value) { return value === null || value === undefined ? NaN : Number(value); }

  function axes(marks) {
    add('path', {
      d: 'M' + left + ',' + top + 'V' + (tall - foot) + 'H' + (wide - right), fill: 'none', stroke: '#78838c'
    });
    marks.forEach(function (mark) {
      add('path', { d: 'M' + left + ',' + up(mark) + 'H' + (wide - right), stroke: '#dfe5ea' });
      write(left - 4, up(mark) + 4, 'end', words(mark));
    });
    if (!about.axis) {
      write(left, tall - 4, 'start', about.ends[0]);
      write(wide - right, tall - 4, 'end', about.ends[1]);
      return;
    }
    window.codendView.ticks(about.range[0], about.range[1], wide / 70).forEach(function (at) {
      add('path', { d: 'M' + across(at) + ',' + (tall - foot) + 'v4', stroke: '#78838c' });
      write(across(at), tall - foot + 15, 'middle', words(at));
    });
    write((left + wide - right) / 2, tall - 4, 'middle', about.axis);
  }

  function draw(one) {
    shown = one;
    wide = svg.clientWidth || 300;
    tall = svg.clientHeight || 92;
    svg.setAttribute('viewBox', '0 0 ' + wide + ' ' + tall);
    var values = one.values.map(number), errors = (one.errors || []).map(number);
    var known = values.filter(isFinite);
    svg.textContent = '';
    if (!known.length) { svg.setAttribute('aria-label', one.words + ' is not known'); return; }
    low = Math.min.apply(null, known);
    high = Math.max.apply(null, known);
    values.forEach(function (value, k) {
      if (!isFinite(value) || !isFinite(errors[k])) return;
      low = Math.min(low, value - errors[k]);
      high = Math.max(high, value + errors[k]);
    });
    if (high - low < 1e-9 * Math.max(Math.abs(high), 1e-9)) { low -= 0.5; high += 0.5; }
    svg.setAttribute('aria-label', one.words + ' from ' + words(low) + ' to ' + words(high));
    var marks = window.codendView.ticks(low, high, (tall - top - foot) / 35);
    if (about.axis && marks.length > 1) {
      low = Math.min(low, marks[0]);
      high = Math.max(high, marks[marks.length - 1]);
    }
    axes(marks);
    var path = '', on = false;
    values.forEach(function (value, k) {
      if (isFinite(value)) {
        path += (on ? 'L' : 'M') + across(about.times[k]).toFixed(1) + ',' + up(value).toFixed(1);
      }
      on = isFinite(value);
    });
    add('path', { d: path, fill: 'none', stroke: '#0b6e99', 'stroke-width': 1.8 });
    if (about.axis) {
      values.forEach(function (value, k) {
        if (!isFinite(value)) return;
        var x = across(about.times[k]);
        if (isFinite(errors[k])) {
          add('path', { d: 'M' + x + ',' + up(value - errors[k]) + 'V' + up(value + errors[k]), stroke: '#0b6e99' });
        }
        add('circle', { cx: x, cy: up(value), r: 2.6, fill: '#0b6e99' });
      });
    }
    cursor = add('line', { y1: top, y2: tall - foot, stroke: '#b3005c', 'stroke-width': 1.5 });
    tip = write(wide - right, top + 9, 'end', '');
    mark(now);
  }

  function mark(time) {
    now = time;
    if (!cursor) return;
    cursor.setAttribute('visibility', now >= about.range[0] && now <= about.range[1] ? 'visible' : 'hidden');
    cursor.setAttribute('x1', across(now));
    cursor.setAttribute('x2', across(now));
  }

  function time_at(event) {
    var at = svg.getBoundingClientRect(), x = (event.clientX - at.left) / at.width * wide;
    var time = about.range[0] + (about.range[1] - about.range[0]) * (x - left) / (wide - left - right);
    return Math.min(Math.max(time, about.range[0]), about.range[1]);
  }
  // Displays the value nearest to the pointer.
  function hover(event) {
    if (!tip || !shown) return;
    var time = time_at(event), best = -1;
    shown.values.forEach(function (value, k) {
      if (!isFinite(number(value))) return;
      if (best < 0 || Math.abs(about.times[k] - time) < Math.abs(about.times[best] - time)) best = k;
    });
    if (best < 0) return;
    var error = number((shown.errors || [])[best]);
    tip.textContent = words(about.times[best]) + (about.unit ? ' ' + about.unit : '') + ': ' +
      words(number(shown.values[best])) +
      (isFinite(error) ? ', ' + window.codendView.say('computed to {n}', { n: Number(error.toPrecision(2)) }) : '');
  }
  svg.addEventListener('pointerdown', function (event) {
    if (!about.seek) { hover(event); return; }
    svg.setPointerCapture(event.pointerId);
    about.seek(time_at(event));
  });
  svg.addEventListener('pointermove', function (event) {
    if (about.seek && event.buttons) about.seek(time_at(event));
    hover(event);
  });
  svg.addEventListener('pointerleave', function () { if (tip) tip.textContent = ''; });
  // Labels keep their size, so another width requires a new drawing.
  new window.ResizeObserver(function () {
    if (shown && svg.clientWidth && svg.clientWidth !== wide) draw(shown);
  }).observe(svg);

  // Renders at three times the size, on white, with the measure's name as the title.
  function png() {
    var copy = svg.cloneNode(true), scale = 3, head = 20, image = new Image();
    copy.setAttribute('width', wide);
    copy.setAttribute('height', tall);
    image.src = 'data:image/svg+xml;charset=utf-8,' +
      encodeURIComponent(new XMLSerializer().serializeToString(copy));
    return image.decode().then(function () {
      var canvas = document.createElement('canvas'), paper = canvas.getContext('2d');
      canvas.width = scale * wide;
      canvas.height = scale * (tall + head);
      paper.scale(scale, scale);
      paper.fillStyle = '#ffffff';
      paper.fillRect(0, 0, wide, tall + head);
      paper.fillStyle = '#202428';
      paper.font = '600 13px system-ui, sans-serif';
      paper.fillText(shown.words, 8, 15);
      paper.drawImage(image, 0, head, wide, tall);
      return canvas.toDataURL('image/png');
    });
  }
  return { draw: draw, mark: mark, png: png };
};
