// Time in the viewer: a slider with a button that plays, keys (space plays and stops, comma and full
// stop step between kept times, Home and End go to the ends) and a graph of a measure.
window.codendView = window.codendView || {};
window.codendView.motion = function (host, viewer, told) {
  'use strict';
  var times = told.times, last = times.length - 1;
  var longest = 20;  // seconds in which a whole tow plays, unless it is shorter

  function element(name, className, attributes) {
    var made = document.createElement(name);
    made.className = className;
    Object.keys(attributes || {}).forEach(function (key) { made.setAttribute(key, attributes[key]); });
    return made;
  }
  host.classList.add('moves');
  var bar = element('div', 'view-time');
  var button = element('button', 'view-button', { type: 'button' });
  var slider = element('input', '', {
    type: 'range', min: times[0], max: times[last], step: 'any', 'aria-label': 'Time'
  });
  var label = element('div', 'label');
  [button, slider, label].forEach(function (part) { bar.appendChild(part); });
  host.appendChild(bar);

  var now = times[0], playing = null;

  function frame_of(time) {
    var k = 0;
    while (k < last - 1 && times[k + 1] <= time) k++;
    return k;
  }

  function show(time) {
    now = Math.min(Math.max(time, times[0]), times[last]);
    var k = frame_of(now), share = (now - times[k]) / (times[k + 1] - times[k]);
    viewer.time(k, share);
    var words = told.labels[share < 0.5 ? k : k + 1];
    label.textContent = words;
    slider.value = now;
    slider.setAttribute('aria-valuetext', words);
    mark();
  }

  function stop() {
    if (playing) window.cancelAnimationFrame(playing.request);
    playing = null;
    button.textContent = 'Play';
  }

  function play() {
    if (now >= times[last]) now = times[0];
    var rate = Math.max(1, (times[last] - times[0]) / longest);
    playing = { clock: null };
    button.textContent = 'Pause';
    function tick(clock) {
      if (!playing) return;
      var passed = playing.clock === null ? 0 : (clock - playing.clock) / 1000;
      playing.clock = clock;
      show(now + rate * passed);
      if (now >= times[last]) { stop(); return; }
      playing.request = window.requestAnimationFrame(tick);
    }
    playing.request = window.requestAnimationFrame(tick);
  }

  function toggle() { if (playing) stop(); else play(); }

  // To the kept time before or after.
  function step(by) {
    stop();
    var k = frame_of(now);
    if (now >= times[last]) k = last;
    if (by < 0 && now > times[k]) k++;
    show(times[Math.min(Math.max(k + by, 0), last)]);
  }

  button.addEventListener('click', toggle);
  slider.addEventListener('input', function () { stop(); show(Number(slider.value)); });
  host.addEventListener('keydown', function (event) {
    if (event.ctrlKey || event.altKey || event.metaKey || /^(SELECT|TEXTAREA)$/.test(event.target.tagName)) {
      return;
    }
    var act = {
      ' ': toggle, ',': function () { step(-1); }, '.': function () { step(1); },
      Home: function () { stop(); show(times[0]); }, End: function () { stop(); show(times[last]); }
    }[event.key];
    // A focused button takes its own space bar.
    if (!act || event.key === ' ' && event.target.tagName === 'BUTTON') return;
    event.preventDefault();
    act();
  });
  var keys = host.querySelector('.view-keys');
  [['space', 'play, pause'], [', .', 'a kept time back, on'], ['Home, End', 'start, end']].forEach(function (one) {
    ['kbd', 'span'].forEach(function (name, k) {
      var made = element(name, '');
      made.textContent = one[k];
      keys.appendChild(made);
    });
  });

  // ---- graph ------------------------------------------------------------------------------------

  var cursor = null, wide = 300, tall = 92, left = 40, right = 8, top = 8, foot = 16;
  function across(time) {
    return left + (wide - left - right) * (time - times[0]) / (times[last] - times[0]);
  }
  function mark() {
    if (!cursor) return;
    cursor.setAttribute('x1', across(now));
    cursor.setAttribute('x2', across(now));
  }
  var graph = told.graph || [];
  if (graph.length) {
    var box = element('div', 'view-graph');
    var select = element('select', '', { 'aria-label': 'Measure to plot' });
    graph.forEach(function (one, k) {
      var option = element('option', '', { value: k });
      option.textContent = one.words;
      select.appendChild(option);
    });
    var space = 'http://www.w3.org/2000/svg', svg = document.createElementNS(space, 'svg');
    svg.setAttribute('viewBox', '0 0 ' + wide + ' ' + tall);
    svg.setAttribute('preserveAspectRatio', 'none');
    svg.setAttribute('role', 'img');
    box.appendChild(select);
    box.appendChild(svg);
    host.appendChild(box);
    var draw = function () {
      var one = graph[Number(select.value)], at = told.graph_times, known = one.values.filter(isFinite);
      var low = Math.min.apply(null, known), high = Math.max.apply(null, known);
      if (high - low < 1e-9 * Math.max(Math.abs(high), 1e-9)) { low -= 0.5; high += 0.5; }
      function up(value) { return top + (tall - top - foot) * (high - value) / (high - low); }
      function add(name, attributes, words) {
        var made = document.createElementNS(space, name);
        Object.keys(attributes).forEach(function (key) { made.setAttribute(key, attributes[key]); });
        if (words !== undefined) made.textContent = words;
        svg.appendChild(made);
        return made;
      }
      function words(x) { return String(Number(x.toPrecision(3))); }
      svg.textContent = '';
      svg.setAttribute('aria-label', one.words + ' from ' + words(low) + ' to ' + words(high));
      add('path', { d: 'M' + left + ',' + top + 'V' + (tall - foot) + 'H' + (wide - right), fill: 'none', stroke: '#78838c' });
      add('text', { x: left - 4, y: top + 6, 'text-anchor': 'end' }, words(high));
      add('text', { x: left - 4, y: tall - foot, 'text-anchor': 'end' }, words(low));
      add('text', { x: left, y: tall - 4 }, told.ends[0]);
      add('text', { x: wide - right, y: tall - 4, 'text-anchor': 'end' }, told.ends[1]);
      var path = one.values.map(function (value, k) {
        return (k && isFinite(one.values[k - 1]) ? 'L' : 'M') + across(at[k]).toFixed(1) + ',' +
          (isFinite(value) ? up(value).toFixed(1) : top);
      }).join('');
      add('path', { d: path, fill: 'none', stroke: '#0b6e99', 'stroke-width': 1.8, 'vector-effect': 'non-scaling-stroke' });
      cursor = add('line', { y1: top, y2: tall - foot, stroke: '#b3005c', 'stroke-width': 1.5, 'vector-effect': 'non-scaling-stroke' });
      mark();
    };
    select.addEventListener('change', draw);
    var to = function (event) {
      var at = svg.getBoundingClientRect(), x = (event.clientX - at.left) / at.width * wide;
      stop();
      show(times[0] + (times[last] - times[0]) * (x - left) / (wide - left - right));
    };
    svg.addEventListener('pointerdown', function (event) { svg.setPointerCapture(event.pointerId); to(event); });
    svg.addEventListener('pointermove', function (event) { if (event.buttons) to(event); });
    draw();
  }

  stop();
  show(now);
  return { show: show };
};
