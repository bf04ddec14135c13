// A shared page: viewer, sliders and measures of a gear that a worker settles.
window.codendPage = function (given, shapes, page, packed) {
  'use strict';
  var scene = given.scene, drawn = codendArrays(given.head, shapes, {});
  function unpack(part, names) {
    names.forEach(function (name) { part[name] = drawn.array(part[name]); });
  }
  if (scene.ropes) unpack(scene.ropes, ['ends', 'part']);
  scene.netting.forEach(function (panel) { unpack(panel, ['point', 'mesh']); });
  ['points', 'places', 'boards', 'rope_tension', 'u', 'v', 'drag', 'opening', 'angle'].forEach(function (name) {
    if (scene[name]) unpack(scene[name], ['floats']);
  });
  function by_id(id) { return document.getElementById(id); }
  var told = by_id('told'), viewer = window.codendView.viewer(by_id('tank'), { title: false, wheel: false });
  var times = window.codendTimes = { picture: 0, first: 0, moves: 0, stuck: 0 };
  if (viewer) viewer.show(scene, null);
  times.picture = performance.now();

  // ---- formatted numbers ------------------------------------------------------------------------

  function figures(x) {
    if (!isFinite(x)) return 'none';
    if (x === 0) return '0';
    var decimals = Math.min(Math.max(3 - Math.floor(Math.log10(Math.abs(x))), 0), 4);
    var text = x.toFixed(decimals);
    if (!/[1-9]/.test(text)) return '0';
    var parts = text.split('.');
    if (Math.abs(x) >= 1e4) parts[0] = parts[0].replace(/\B(?=(\d{3})+$)/g, '\u202f');
    return parts.join('.').replace('-', '\u2212');
  }
  function error_words(error) {
    if (!(error > 0)) return '';
    var size = Math.floor(Math.log10(error)), unit = Math.pow(10, error < 2 * Math.pow(10, size) ? size - 1 : size);
    var up = Math.max(Math.ceil(error / unit * (1 - 1e-9)) * unit, 1e-4);
    return up.toFixed(Math.min(Math.max(-Math.round(Math.log10(unit)), 0), 4));
  }

  // ---- sliders ----------------------------------------------------------------------------------

  var fields = page.fields, own = fields.map(function (field) { return field.value; });
  var values = own.slice(), inputs = fields.map(function (field, k) { return by_id('slider-' + (k + 1)); });
  function snapped(field, value) {
    if (Math.abs(value - field.value) < field.step / 2) return field.value;
    var low = Math.round(value / field.step) * field.step;
    return Math.min(Math.max(Number(low.toPrecision(12)), field.lower), field.upper);
  }
  function with_unit(k, value) { return (Number(value.toPrecision(6)) + ' ' + fields[k].unit).trim(); }
  function tell_slider(k) {
    var words = with_unit(k, values[k]);
    by_id('slider-' + (k + 1) + '-value').textContent = words;
    inputs[k].setAttribute('aria-valuetext', words);
  }
  // Returns the sliders that stopped early, each with the reached and the requested value.
  function met(at) {
    return fields.map(function (field, k) {
      return at[k] === values[k] ? '' : field.label + ' ' + with_unit(k, at[k]) + ' (of ' + with_unit(k, values[k]) + ')';
    }).filter(Boolean).join(', ');
  }
  var number = 0, shown = 0;
  function move() {
    number += 1;
    by_id('reset').disabled = values.every(function (v, k) { return v === own[k]; });
    if (towing) tow_off();
    worker({ kind: 'move', number: number, values: values.slice() });
    busy(true);
  }
  inputs.forEach(function (input, k) {
    input.step = 'any';
    input.addEventListener('input', function () {
      values[k] = snapped(fields[k], Number(input.value));
      tell_slider(k);
      move();
    });
    // A key moves the slider by one step or by ten.
    input.addEventListener('keydown', function (event) {
      var way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!way) return;
      event.preventDefault();
      var field = fields[k];
      values[k] = Math.min(Math.max(snapped(field, values[k] + way * field.step), field.lower), field.upper);
      input.value = values[k];
      tell_slider(k);
      move();
    });
  });
  function set(to) {
    to.forEach(function (value, k) {
      values[k] = value;
      inputs[k].value = value;
      tell_slider(k);
    });
  }
  by_id('reset').addEventListener('click', function () { set(own); move(); });

  // ---- results ----------------------------------------------------------------------------------

  var names = Object.keys(page.programs), rows = Array.from(by_id('measures').rows);
  function busy(is) { document.body.classList.toggle('busy', is); }
  function show(shape) {
    var fixed = {};
    ['points', 'places', 'boards', 'drag', 'rope_tension', 'u', 'v', 'opening', 'angle'].forEach(function (name) {
      if (shape.moved[name]) fixed[name] = { floats: shape.moved[name] };
    });
    fixed.flow = shape.flow;
    if (viewer) viewer.pass(fixed);
    names.forEach(function (name, k) {
      var of = page.programs[name], now = shape.measures[name] / of.size, cells = rows[k].cells;
      cells[1].textContent = figures(now) + ' ' + of.unit;
      cells[2].textContent = of.error ? error_words(of.error * Math.abs(now)) : '';
      var change = now - of.value, size = Math.max(Math.abs(of.value), 1e-12);
      var text = Math.abs(change) < 5e-4 * size ? '' : (change > 0 ? '+' : '') + figures(change) +
        (of.value !== 0 ? ' (' + (change > 0 ? '+' : '\u2212') + Math.abs(100 * change / of.value).toFixed(1) + ' %)' : '');
      cells[3].textContent = text;
      cells[3].className = 'change' + (text ? change > 0 ? ' more' : ' less' : '');
    });
    by_id('conditions').textContent = shape.conditions;
    var list = by_id('warnings');
    list.textContent = '';
    shape.warnings.forEach(function (words) {
      var item = document.createElement('li');
      item.textContent = words;
      list.appendChild(item);
    });
    list.hidden = !shape.warnings.length;
    window.codendShown = { measures: shape.measures, values: shape.values };
  }

  // ---- the worker -------------------------------------------------------------------------------

  var worker = function () {};
  function hear(said) {
    if (said.kind === 'failed') {
      told.textContent = 'The engine stopped: ' + said.words;
      window.codendFailed = said.words;
      busy(false);
      return;
    }
    if (!times.first) {
      times.first = performance.now();
      inputs.forEach(function (input) { input.disabled = false; });
      told.textContent = 'Move a slider: the gear settles in this page.';
      show(said.shape);
      window.codendReady = true;
      return;
    }
    show(said.shape);
    if (said.number < number) return;
    if (said.kind === 'stuck') {
      times.stuck += 1;
      told.textContent = 'The gear does not settle beyond ' + met(said.shape.values) +
        '; the picture shows the gear there.';
      set(said.shape.values);
      busy(false);
    } else if (said.done) {
      times.moves += 1;
      shown = said.number;
      told.textContent = 'Settled.';
      busy(false);
    }
    window.codendSettled = shown === number || said.kind === 'stuck';
  }
  Promise.all([packed.text('worker'), packed.bytes('wasm'), packed.bytes('arrays')]).then(function (all) {
    var code = all[0] + '\n;var codendHears = codendWorker(function (said, moved) { postMessage(said, moved); });' +
      'onmessage = function (event) { codendHears(event.data); };';
    var made = new Worker(URL.createObjectURL(new Blob([code], { type: 'text/javascript' })));
    made.onmessage = function (event) { hear(event.data); };
    made.onerror = function (event) { packed.failed(event.message || 'the worker did not start'); };
    worker = function (said) { window.codendSettled = false; made.postMessage(said); };
    made.postMessage({ kind: 'start', page: page, wasm: all[1], bytes: new Uint8Array(all[2]) }, [all[1], all[2]]);
  }).catch(packed.failed);
  window.codendSizes = {};
  names.forEach(function (name) { window.codendSizes[name] = page.programs[name].size; });
  // for tests
  window.codendMove = function (to) { set(to); move(); };

  // ---- drawing and tow --------------------------------------------------------------------------

  var drawing = by_id('drawing');
  drawing.addEventListener('toggle', function () {
    var place = drawing.querySelector('.drawing');
    if (!drawing.open || place.firstChild) return;
    packed.bytes('drawing').then(function (svg) {
      var image = document.createElement('img');
      image.alt = 'The net laid flat with meshes, mesh sizes, twines and cutting rates, and its rigging. The plan as text is at the end of this page.';
      image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
      place.appendChild(image);
    });
  });
  var towing = false, motion = null, button = by_id('tow');
  function tow_off() {
    towing = false;
    button.setAttribute('aria-pressed', 'false');
    button.textContent = 'Play the tow';
    viewer.show(scene, null);
  }
  if (button && viewer) {
    button.addEventListener('click', function () {
      if (towing) { tow_off(); move(); return; }
      (motion ? Promise.resolve(motion) : packed.text('tow').then(JSON.parse)).then(function (found) {
        motion = found;
        towing = true;
        button.setAttribute('aria-pressed', 'true');
        button.textContent = 'Back to the sliders';
        viewer.show(motion, null);
      });
    });
  }
};
