// A tow of the present design: its inputs, its view with a time slider, and its graphs.
//
// `codendTow`:
//   `show(scene)` plays a computed tow.
//   `design(planned)` marks the tow as out of date; planned: true if the new plan defines a tow.
window.codendTow = (function () {
  'use strict';

  var element = window.codendView.element;
  var viewer = null, graphs = null, told = null;
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

  // Default graphs: the first measure that matches each pattern.
  var first = [/door spread|spread/, /mouth height|height/, /tension/, /depth/, /energy imbalance/];
  function choose(all) {
    return first.map(function (kind) {
      return all.filter(function (words) { return kind.test(words); })[0];
    }).filter(function (words, k, found) { return words && found.indexOf(words) === k; });
  }

  function moved(time) {
    graphs.each(function (graph, one, now) {
      var k = 0, at = told.graph_times;
      graph.mark(time);
      while (k < at.length - 1 && at[k + 1] <= time + 1e-9) k++;
      var value = one.values[k];
      now.textContent = typeof value === 'number' ? Number(value.toPrecision(4)) : '';
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
    graphs = graphs || window.codendGraphs(find('tow_graphs'), find('tow_more'), choose);
    var time = scene.times[0];
    scene.graph.forEach(function (one) { one.shown = window.codendSay.measure(one.words); });
    graphs.show(scene.graph, {
      times: scene.graph_times, ends: scene.ends, range: [time, scene.times[scene.times.length - 1]],
      seek: function (at) { viewer.seek(at); }, drawn: function () { moved(time); }
    });
    viewer.show(scene);
    moved(time);
    find('tow_place').scrollIntoView({ block: 'nearest' });
  }

  document.addEventListener('click', function (event) {
    var target = event.target;
    if (target.id === 'tow_start') ask(false);
    else if (target.id === 'tow_planned') ask(true);
  });

  return {
    show: show,
    design: function (planned) {
      find('tow_planned').hidden = !planned;
      if (told) window.codendPage.tell('tow_stale', window.codendSay('tow_stale'));
    },
    viewer: function () { return viewer; }
  };
}());
