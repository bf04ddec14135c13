// Time controls of the viewer: slider, play button, keys and a graph of a measure. Space plays and
// pauses; comma and full stop step between stored times; Home and End go to the ends.
window.codendView = window.codendView || {};
// options: graph (false hides the graph), moved(time) (called for every displayed time).
// Returns {show(time), seek(time), end()}: `seek` also pauses, `end` removes the controls.
window.codendView.motion = function (host, viewer, told, options) {
  'use strict';
  var element = window.codendView.element, say = window.codendView.say, times = told.times, last = times.length - 1;
  var longest = 20;  // s, maximum playback time

  host.classList.add('moves');
  var bar = element('div', 'view-time');
  var button = element('button', 'view-button', undefined, { type: 'button' });
  var slider = element('input', '', undefined, {
    type: 'range', min: times[0], max: times[last], step: 'any', 'aria-label': say('Time')
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
    if (options.moved) options.moved(now);
  }

  function stop() {
    if (playing) window.cancelAnimationFrame(playing.request);
    playing = null;
    button.textContent = say('Play');
  }

  function play() {
    if (now >= times[last]) now = times[0];
    var rate = Math.max(1, (times[last] - times[0]) / longest);
    playing = { clock: null };
    button.textContent = say('Pause');
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

  function step(by) {
    stop();
    var k = frame_of(now);
    if (now >= times[last]) k = last;
    if (by < 0 && now > times[k]) k++;
    show(times[Math.min(Math.max(k + by, 0), last)]);
  }

  button.addEventListener('click', toggle);
  slider.addEventListener('input', function () { stop(); show(Number(slider.value)); });
  function press(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || /^(SELECT|TEXTAREA)$/.test(event.target.tagName)) {
      return;
    }
    var act = {
      ' ': toggle, ',': function () { step(-1); }, '.': function () { step(1); },
      Home: function () { stop(); show(times[0]); }, End: function () { stop(); show(times[last]); }
    }[event.key];
    // The space bar activates a focused button.
    if (!act || event.key === ' ' && event.target.tagName === 'BUTTON') return;
    event.preventDefault();
    act();
  }
  host.addEventListener('keydown', press);
  var keys = host.querySelector('.view-keys'), added = [];
  [[say('space'), say('play, pause')], [', .', say('previous, next saved time')],
    ['Home, End', say('start, end')]].forEach(function (one) {
    ['kbd', 'span'].forEach(function (name, k) {
      added.push(element(name, '', one[k]));
      keys.appendChild(added[added.length - 1]);
    });
  });

  // ---- graph ------------------------------------------------------------------------------------

  var curve = null, graph = options.graph === false ? [] : told.graph || [], box = null;
  function mark() { if (curve) curve.mark(now); }
  if (graph.length) {
    box = element('div', 'view-graph');
    var select = element('select', '', undefined, { 'aria-label': say('Measure to plot') });
    graph.forEach(function (one, k) {
      select.appendChild(element('option', '', one.words, { value: k }));
    });
    box.appendChild(select);
    host.appendChild(box);
    curve = window.codendView.graph(box, {
      times: told.graph_times, ends: told.ends, range: [times[0], times[last]],
      seek: function (time) { stop(); show(time); }
    });
    var draw = function () { curve.draw(graph[Number(select.value)]); };
    select.addEventListener('change', draw);
    draw();
  }

  function end() {
    stop();
    host.removeEventListener('keydown', press);
    added.concat(bar, box || []).forEach(function (one) { one.remove(); });
    host.classList.remove('moves');
  }

  stop();
  show(now);
  return { show: show, seek: function (time) { stop(); show(time); }, end: end };
};
