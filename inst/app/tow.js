// A tow of the design on screen: what is asked of it, its picture with the slider of time, its graphs.
//
// codendTow.show(scene) plays what R found; .design(planned) tells that another design is on screen and
// whether its plan has a tow of its own.
window.codendTow = (function () {
  'use strict';

  var element = window.codendView.element;
  var viewer = null, curves = [], told = null, chosen = [];
  function find(id) { return document.getElementById(id); }
  function text(id) { return find(id).value.trim(); }

  function changes() {
    var said = {};
    [['speed', 'to'], ['course', 'by'], ['warp_out', 'by']].forEach(function (one) {
      var id = 'tow_' + one[0], value = text(id);
      if (!value) return;
      said[one[0]] = { from: text(id + '_from'), over: text(id + '_over') };
      said[one[0]][one[1]] = value;
    });
    return said;
  }

  function ask(planned) {
    window.codendPage.tell('tow_error', '');
    var said = { until: text('tow_until'), number: Date.now() };
    if (planned) said.planned = true;
    else said.changes = changes();
    window.codendTalk.tell('tow_wanted', said);
  }

  // What is looked at first: at most two of a kind.
  var first = [/door spread|spread/, /mouth height|height/, /tension/, /depth/, /energy imbalance/];
  function choose(graph) {
    var all = graph.map(function (one) { return one.words; });
    var kept = chosen.filter(function (words) { return all.indexOf(words) >= 0; });
    if (kept.length) return kept;
    return first.map(function (kind) {
      return all.filter(function (words) { return kind.test(words); })[0];
    }).filter(function (words, k, found) { return words && found.indexOf(words) === k; });
  }

  function draw_graphs() {
    var place = find('tow_graphs'), select = find('tow_more');
    place.textContent = '';
    select.textContent = '';
    select.appendChild(element('option', '', 'Which measure?', { value: '' }));
    curves = [];
    told.graph.forEach(function (one) {
      if (chosen.indexOf(one.words) < 0) {
        select.appendChild(element('option', '', one.words, { value: one.words }));
        return;
      }
      var figure = element('figure', 'tow-graph'), head = element('figcaption', '', one.words);
      head.appendChild(element('span', 'now'));
      head.appendChild(element('button', 'take-out', '\u00d7',
        { type: 'button', 'aria-label': 'Take out the graph of ' + one.words, 'data-graph': one.words }));
      figure.appendChild(head);
      place.appendChild(figure);
      var curve = window.codendView.graph(figure, {
        times: told.graph_times, ends: told.ends,
        range: [told.times[0], told.times[told.times.length - 1]],
        seek: function (time) { viewer.seek(time); }
      });
      curve.draw(one);
      curves.push({ curve: curve, values: one.values, now: head.querySelector('.now') });
    });
  }

  function moved(time) {
    curves.forEach(function (one) {
      one.curve.mark(time);
      var k = 0, at = told.graph_times;
      while (k < at.length - 1 && at[k + 1] <= time + 1e-9) k++;
      var value = one.values[k];
      one.now.textContent = typeof value === 'number' ? Number(value.toPrecision(4)) : '';
    });
  }

  function show(scene) {
    told = scene;
    find('towed').hidden = false;
    window.codendPage.tell('tow_stale', '');
    $(find('towed')).trigger('shown');
    if (!viewer) {
      var host = element('div', 'tow-view');
      find('tow_place').appendChild(host);
      viewer = window.codendView.viewer(host, { title: true, graph: false, moved: moved, still: false });
      if (!viewer) return;
    }
    chosen = choose(scene.graph);
    draw_graphs();
    viewer.show(scene);
    moved(scene.times[0]);
    find('tow_place').scrollIntoView({ block: 'nearest' });
  }

  document.addEventListener('click', function (event) {
    var target = event.target;
    if (target.id === 'tow_start') ask(false);
    else if (target.id === 'tow_planned') ask(true);
    else if (target.dataset && target.dataset.graph) {
      chosen = chosen.filter(function (words) { return words !== target.dataset.graph; });
      draw_graphs();
    }
  });
  document.addEventListener('change', function (event) {
    if (event.target.id !== 'tow_more' || !event.target.value) return;
    chosen.push(event.target.value);
    draw_graphs();
  });

  return {
    show: show,
    design: function (planned) {
      find('tow_planned').hidden = !planned;
      if (told) window.codendPage.tell('tow_stale', 'The design on screen has changed since this tow.');
    },
    viewer: function () { return viewer; }
  };
}());
