// A measure by time: codendView.graph(host, about) draws it in an SVG of its own. about: times (of the values), ends
// (words of the first and the last), range (first and last time), seek(time), which is called where it
// is clicked or dragged. .draw(one) takes list(words, values); .mark(time) moves its line of the moment.
window.codendView = window.codendView || {};
window.codendView.graph = function (host, about) {
  'use strict';
  var space = 'http://www.w3.org/2000/svg', left = 44, right = 8, top = 8, foot = 16;
  var wide = 300, tall = 92, cursor = null, now = about.range[0], shown = null;
  var svg = document.createElementNS(space, 'svg');
  svg.setAttribute('role', 'img');
  host.appendChild(svg);

  function across(time) {
    return left + (wide - left - right) * (time - about.range[0]) / (about.range[1] - about.range[0]);
  }
  function add(name, attributes, words) {
    var made = document.createElementNS(space, name);
    Object.keys(attributes).forEach(function (key) { made.setAttribute(key, attributes[key]); });
    if (words !== undefined) made.textContent = words;
    svg.appendChild(made);
    return made;
  }
  function words(x) {
    var plain = String(Number(x.toPrecision(4)));
    return plain.length > 6 ? x.toExponential(0) : plain;
  }

  function draw(one) {
    shown = one;
    wide = svg.clientWidth || 300;
    tall = svg.clientHeight || 92;
    svg.setAttribute('viewBox', '0 0 ' + wide + ' ' + tall);
    // what is not known comes as null
    var values = one.values.map(function (value) { return value === null ? NaN : Number(value); });
    var known = values.filter(isFinite);
    svg.textContent = '';
    if (!known.length) { svg.setAttribute('aria-label', one.words + ' is not known'); return; }
    var low = Math.min.apply(null, known), high = Math.max.apply(null, known);
    if (high - low < 1e-9 * Math.max(Math.abs(high), 1e-9)) { low -= 0.5; high += 0.5; }
    function up(value) { return top + (tall - top - foot) * (high - value) / (high - low); }
    svg.setAttribute('aria-label', one.words + ' from ' + words(low) + ' to ' + words(high));
    add('path', {
      d: 'M' + left + ',' + top + 'V' + (tall - foot) + 'H' + (wide - right), fill: 'none', stroke: '#78838c'
    });
    add('text', { x: left - 4, y: top + 6, 'text-anchor': 'end' }, words(high));
    add('text', { x: left - 4, y: tall - foot, 'text-anchor': 'end' }, words(low));
    add('text', { x: left, y: tall - 4 }, about.ends[0]);
    add('text', { x: wide - right, y: tall - 4, 'text-anchor': 'end' }, about.ends[1]);
    var path = '', on = false;
    values.forEach(function (value, k) {
      if (isFinite(value)) {
        path += (on ? 'L' : 'M') + across(about.times[k]).toFixed(1) + ',' + up(value).toFixed(1);
      }
      on = isFinite(value);
    });
    add('path', { d: path, fill: 'none', stroke: '#0b6e99', 'stroke-width': 1.8 });
    cursor = add('line', { y1: top, y2: tall - foot, stroke: '#b3005c', 'stroke-width': 1.5 });
    mark(now);
  }

  function mark(time) {
    now = time;
    if (!cursor) return;
    cursor.setAttribute('x1', across(now));
    cursor.setAttribute('x2', across(now));
  }

  function to(event) {
    var at = svg.getBoundingClientRect(), x = (event.clientX - at.left) / at.width * wide;
    var time = about.range[0] + (about.range[1] - about.range[0]) * (x - left) / (wide - left - right);
    about.seek(Math.min(Math.max(time, about.range[0]), about.range[1]));
  }
  svg.addEventListener('pointerdown', function (event) { svg.setPointerCapture(event.pointerId); to(event); });
  svg.addEventListener('pointermove', function (event) { if (event.buttons) to(event); });
  // of another width it is drawn anew, with words of the same size
  new window.ResizeObserver(function () {
    if (shown && svg.clientWidth && svg.clientWidth !== wide) draw(shown);
  }).observe(svg);
  return { draw: draw, mark: mark };
};
