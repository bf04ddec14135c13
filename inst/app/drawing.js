// The net drawing in the flume tank, which is also an editor. Users zoom and pan, click a number to
// change it, or drag the lower edge of a panel to make it deeper.
//
// `codendDrawing`:
//   `show(text)` shows an SVG.
//   `want(moved)` requests a new drawing from R if it is visible and out of date.
//   `wrong(paths)` marks fields with problems.
//   `seek(path)` scrolls to a part now, or when it is next drawn.
//   `opened()` resets the view for another plan.
window.codendDrawing = (function () {
  'use strict';

  var element = window.codendView.element, say = window.codendSay;
  var timer = null, stale = true, wrong_paths = [], box = null, whole = null, handle = null, sought = null;
  var legible = 11;  // px, the smallest letters when the drawing opens
  function find(id) { return document.getElementById(id); }
  function seen() { return find('flume').classList.contains('drawn'); }
  function svg() { return find('drawing').querySelector('svg'); }

  function want(moved) {
    if (moved) stale = true;
    window.clearTimeout(timer);
    if (!stale || !seen()) return;
    timer = window.setTimeout(function () {
      stale = false;
      window.codendTalk.tell('drawing_wanted', Date.now());
    }, 250);
  }

  // Plans can come from strangers, so scripts and links are removed.
  function harmless(root) {
    root.querySelectorAll('script, foreignObject, iframe, image, use, animate, set, style, a')
      .forEach(function (one) { one.remove(); });
    [root].concat([].slice.call(root.querySelectorAll('*'))).forEach(function (one) {
      [].slice.call(one.attributes).forEach(function (attribute) {
        if (/^on|href$/i.test(attribute.name)) one.removeAttribute(attribute.name);
      });
    });
    return root;
  }

  function show(text) {
    var found = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    if (found.nodeName !== 'svg') return;
    var made = document.importNode(harmless(found), true), place = find('drawing');
    var view = made.getAttribute('viewBox').split(' ').map(Number), focused = document.activeElement;
    var at = focused && place.contains(focused) && focused.dataset.path;
    made.removeAttribute('width');
    made.removeAttribute('height');
    place.querySelectorAll('svg').forEach(function (one) { one.remove(); });
    place.appendChild(made);
    handle = null;
    made.querySelectorAll('[data-path]').forEach(function (one) {
      one.setAttribute('tabindex', '0');
      one.setAttribute('role', 'button');
      var shown = one.querySelector('text');
      one.setAttribute('aria-label', say('change_field', { field: say.path(one.dataset.path) }) +
        (shown ? ': ' + shown.textContent : ''));
      if (one.dataset.path === at) one.focus({ preventScroll: true });
    });
    whole = view;
    if (!box) open_view();
    look();
    mark();
    if (sought) seek(sought);
  }

  // ---- zoom and pan -------------------------------------------------------------------------------

  // Zooms so that the smallest letters are legible, and starts at the first panel.
  function open_view() {
    var place = find('drawing'), sizes = [].slice.call(svg().querySelectorAll('[data-path] text'))
      .map(function (one) { return Number(one.getAttribute('font-size')); });
    var least = sizes.length ? Math.min.apply(null, sizes) : 2.5;
    var wide = Math.min(whole[2], place.clientWidth * least / legible);
    box = [whole[0], whole[1], wide, wide * place.clientHeight / place.clientWidth];
    var first = svg().querySelector('[data-component="panel"]');
    if (first && wide < whole[2]) {
      var b = first.getBBox();
      box[0] = Math.max(0, b.x + b.width / 2 - box[2] / 2);
      box[1] = Math.max(0, b.y - 0.1 * box[3]);
    }
  }

  function look() {
    if (!svg() || !box) return;
    var place = find('drawing');
    box[3] = box[2] * place.clientHeight / Math.max(place.clientWidth, 1);
    svg().setAttribute('viewBox', box.map(function (v) { return v.toFixed(3); }).join(' '));
  }

  function see_all() {
    var place = find('drawing'), wide = Math.max(whole[2], whole[3] * place.clientWidth / place.clientHeight);
    box = [whole[0] - (wide - whole[2]) / 2, whole[1], wide, 0];
    look();
  }

  // `share` is a factor on the visible width, below 1 to zoom in. `x` and `y` are the fixed point
  // as fractions of the picture.
  function zoom(share, x, y) {
    if (!box) return;
    share = Math.min(Math.max(share, 5 / box[2]), 1.3 * Math.max(whole[2], whole[3]) / box[2]);
    box[0] += box[2] * (1 - share) * x;
    box[1] += box[3] * (1 - share) * y;
    box[2] *= share;
    look();
  }
  function pan(dx, dy) {
    box[0] += dx * box[2];
    box[1] += dy * box[3];
    look();
  }

  // Scrolls to an element that is out of sight.
  function bring(thing) {
    var b = thing.getBBox(), x = b.x + b.width / 2, y = b.y + b.height / 2;
    if (x > box[0] && y > box[1] && x < box[0] + box[2] && y < box[1] + box[3]) return;
    box[0] = within(whole[0], whole[2], x - box[2] / 2, box[2]);
    box[1] = within(whole[1], whole[3], y - box[3] / 2, box[3]);
    look();
  }
  function within(low, size, from, length) { return Math.max(low, Math.min(from, low + size - length)); }
  function seek(path) {
    var thing = svg() && svg().querySelector('[data-path="' + CSS.escape(path) + '"]');
    sought = thing ? null : path;
    if (!thing || !box) return;
    bring(thing);
    choose(thing);
  }

  var fingers = {}, apart = 0, moved = 0;
  function share_of(event) {
    var r = find('drawing').getBoundingClientRect();
    return [(event.clientX - r.left) / r.width, (event.clientY - r.top) / r.height, r];
  }
  function listen() {
    var place = find('drawing');
    place.addEventListener('wheel', function (event) {
      if (!box) return;
      event.preventDefault();
      var at = share_of(event);
      zoom(Math.exp(event.deltaY * 0.0015), at[0], at[1]);
    }, { passive: false });
    place.addEventListener('pointerdown', function (event) {
      if (event.target.closest('.typed')) return;
      fingers[event.pointerId] = [event.clientX, event.clientY];
      moved = 0;
      if (event.target.classList.contains('edge-handle')) begin_drag(event);
    });
    place.addEventListener('pointermove', function (event) {
      var before = fingers[event.pointerId];
      if (!before || !box) return;
      var r = share_of(event)[2], dx = event.clientX - before[0], dy = event.clientY - before[1];
      if (dragged) { drag(event); return; }
      moved += Math.abs(dx) + Math.abs(dy);
      before[0] = event.clientX;
      before[1] = event.clientY;
      var all = Object.keys(fingers);
      if (all.length > 1) {
        var a = fingers[all[0]], b = fingers[all[1]], gap = Math.hypot(a[0] - b[0], a[1] - b[1]);
        if (apart) zoom(apart / gap, ((a[0] + b[0]) / 2 - r.left) / r.width, ((a[1] + b[1]) / 2 - r.top) / r.height);
        apart = gap;
      } else if (moved > 4) pan(-dx / r.width, -dy / r.height);
    });
    ['pointerup', 'pointercancel', 'pointerleave'].forEach(function (name) {
      place.addEventListener(name, function (event) {
        delete fingers[event.pointerId];
        apart = 0;
        if (dragged) end_drag();
      });
    });
    new ResizeObserver(look).observe(place);
    place.addEventListener('keydown', function (event) {
      if (!box || event.target.closest('.typed')) return;
      var steps = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };
      var thing = event.target.closest('[data-path]');
      if (steps[event.key]) pan.apply(null, steps[event.key]);
      else if (event.key === '+' || event.key === '=') zoom(0.8, 0.5, 0.5);
      else if (event.key === '-') zoom(1.25, 0.5, 0.5);
      else if (event.key === '0') see_all();
      else if ((event.key === 'Enter' || event.key === ' ') && thing) change(thing);
      else return;
      event.preventDefault();
    });
    place.addEventListener('focusin', function (event) {
      var thing = event.target.closest('[data-path]');
      if (!thing || !box || moved) return;
      bring(thing);
    });
    place.addEventListener('click', function (event) {
      var thing = event.target.closest('[data-path]');
      if (moved > 4 || !thing) return;
      change(thing);
    });
  }

  // ---- edits --------------------------------------------------------------------------------------

  // Edits a clicked element: a value in place, a part in the form.
  function change(thing) {
    var path = thing.dataset.path, field = window.codendForm.field(path), text = thing.querySelector('text');
    choose(thing);
    if (text && field) type_in(thing, path, field);
    else if (!window.codendForm.open(path, true)) {
      window.codendPage.tell('refused', say('no_form_field', { path: path }));
    }
    if (!text) grip(thing, path);
  }

  // Returns the elements that display the value of a field.
  function figures(path) {
    return [].slice.call(svg().querySelectorAll('[data-path="' + CSS.escape(path) + '"]'))
      .filter(function (one) { return one.querySelector('text'); });
  }

  // Returns the editable elements in the order of the Tab key: part by part, each field once.
  function by_part() {
    var parts = [], seen = {};
    svg().querySelectorAll('[data-path]').forEach(function (one) {
      var path = one.dataset.path, part = path.replace(/[.](meshes|twine|mesh_size|cutting)([.].*)?$/, '');
      if (seen[path] || !one.querySelector('text') || !window.codendForm.field(path)) return;
      seen[path] = true;
      var own = parts.filter(function (each) { return each.part === part; })[0];
      if (!own) parts.push(own = { part: part, all: [] });
      own.all.push(one);
    });
    return [].concat.apply([], parts.map(function (each) { return each.all; }));
  }

  function choose(thing) {
    document.querySelectorAll('#drawing .chosen').forEach(function (one) { one.classList.remove('chosen'); });
    thing.classList.add('chosen');
  }

  function type_in(thing, path, field) {
    var place = find('drawing'), old = place.querySelector('.typed');
    if (old) old.remove();
    var r = thing.getBoundingClientRect(), home = place.getBoundingClientRect();
    var row = element('form', 'typed control-row'), input = element(field.kind === 'choice' ? 'select' : 'input',
      'form-control form-control-sm', undefined, { 'aria-label': say.path(path), autocomplete: 'off' });
    if (field.kind === 'choice') {
      field.choices.forEach(function (one) { input.appendChild(element('option', '', one, { value: one })); });
    }
    input.value = field.value === null || field.value === undefined ? '' : field.value;
    row.appendChild(input);
    if (field.unit) row.appendChild(element('span', 'note', field.unit));
    row.style.left = Math.max(0, Math.min(r.left - home.left, home.width - 150)) + 'px';
    row.style.top = Math.max(0, Math.min(r.bottom - home.top, home.height - 40)) + 'px';
    var done = false;
    function finish(keep) {
      if (done) return;
      done = true;
      var typed = String(input.value).trim();
      row.remove();
      if (keep && typed && typed !== String(field.value)) {
        figures(path).forEach(function (one) {
          var text = one.querySelector('text');
          text.textContent = typed;
          text.removeAttribute('textLength');
        });
        window.codendForm.edit(path, { value: typed, unit: field.unit });
      }
      var now = figures(path)[0];
      if (now) now.focus({ preventScroll: true });
    }
    row.addEventListener('submit', function (event) { event.preventDefault(); finish(true); });
    input.addEventListener('keydown', function (event) {
      event.stopPropagation();
      if (event.key === 'Escape') { finish(false); return; }
      if (event.key !== 'Tab') return;
      event.preventDefault();
      var all = by_part(), paths = all.map(function (one) { return one.dataset.path; });
      var next = all[paths.indexOf(path) + (event.shiftKey ? -1 : 1)];
      finish(true);
      if (next) { next.focus(); change(next); }
    });
    input.addEventListener('blur', function () { finish(true); });
    place.appendChild(row);
    input.focus();
    if (input.select) input.select();
  }

  // Adds a handle to the lower edge of a chosen panel.
  var dragged = null;
  function grip(thing, path) {
    if (handle) handle.remove();
    handle = null;
    var field = window.codendForm.field(path + '.meshes.deep'), shape = thing.querySelector('polygon');
    if (!field || !shape || typeof field.value !== 'number') return;
    var b = shape.getBBox();
    handle = document.createElementNS(svg().namespaceURI, 'rect');
    handle.setAttribute('class', 'edge-handle');
    Object.entries({ x: b.x, y: b.y + b.height - 1, width: b.width, height: 2 })
      .forEach(function (one) { handle.setAttribute(one[0], one[1]); });
    handle.about = { path: path + '.meshes.deep', deep: field.value, box: b };
    svg().appendChild(handle);
  }
  function begin_drag(event) {
    dragged = { about: handle.about, from: event.clientY, deep: handle.about.deep };
    find('drawing').setPointerCapture(event.pointerId);
  }
  function drag(event) {
    var about = dragged.about, mm = box[3] / find('drawing').clientHeight * (event.clientY - dragged.from);
    dragged.deep = Math.max(1, Math.round(about.deep * (1 + mm / about.box.height)));
    handle.setAttribute('y', about.box.y + about.box.height * dragged.deep / about.deep - 1);
    find('drawing_said').textContent = say('meshes_deep', { n: dragged.deep });
  }
  function end_drag() {
    var one = dragged;
    dragged = null;
    if (one.deep !== one.about.deep) window.codendForm.edit(one.about.path, { value: one.deep, unit: '' });
  }

  // ---- problems -----------------------------------------------------------------------------------

  function mark() {
    if (!svg()) return;
    svg().querySelectorAll('[data-path]').forEach(function (one) {
      var path = one.dataset.path;
      one.classList.toggle('wrong', wrong_paths.some(function (wrong) {
        return wrong && (wrong === path || wrong.indexOf(path + '.') === 0 || path.indexOf(wrong + '.') === 0);
      }));
    });
  }

  function see(drawn) {
    find('flume').classList.toggle('drawn', drawn);
    find('see_tank').setAttribute('aria-pressed', String(!drawn));
    find('see_drawing').setAttribute('aria-pressed', String(drawn));
    want();
    look();
  }
  document.addEventListener('click', function (event) {
    var id = event.target.id;
    if (id === 'see_tank' || id === 'see_drawing') see(id === 'see_drawing');
    else if (id === 'drawing_in') zoom(0.8, 0.5, 0.5);
    else if (id === 'drawing_out') zoom(1.25, 0.5, 0.5);
    else if (id === 'drawing_all' && whole) see_all();
  });
  document.addEventListener('DOMContentLoaded', listen);
  return {
    show: show, want: want, seek: seek, opened: function () { box = sought = null; },
    wrong: function (paths) { wrong_paths = paths; mark(); }
  };
}());
