// `codendGraphs(place, select, first)` draws graphs of the chosen measures in the element `place`;
// `select` offers the others. `first(words)` returns the default choice. Methods:
//   `show(all, about)` draws [{words, shown, values, errors}], with `shown` in the page's language.
//   `about` is as in codendView.graph(), plus `drawn()`, which is called after each drawing.
//   `each(act)` calls act(graph, measure, element for the present value).
window.codendGraphs = function (place, select, first) {
  'use strict';
  var element = window.codendView.element, say = window.codendSay;
  var all = [], about = {}, chosen = [], drawn = [];

  function said(one) { return one.shown || one.words; }

  function save(graph, words) {
    graph.png().then(function (address) {
      var link = element('a', '', undefined, {
        href: address, download: words.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '') + '.png'
      });
      link.click();
    });
  }

  function figure(one) {
    var box = element('figure', 'graph'), head = element('figcaption', '', said(one));
    var now = element('span', 'now'), png = element('button', 'btn btn-link btn-sm save-graph', 'PNG',
      { type: 'button', 'aria-label': say('save_graph', { words: said(one) }) });
    var out = element('button', 'take-out', '\u00d7',
      { type: 'button', 'aria-label': say('take_graph', { words: said(one) }) });
    [now, png, out].forEach(function (part) { head.appendChild(part); });
    box.appendChild(head);
    place.appendChild(box);
    var graph = window.codendView.graph(box, about);
    graph.draw(one);
    png.addEventListener('click', function () { save(graph, one.words); });
    out.addEventListener('click', function () {
      chosen = chosen.filter(function (words) { return words !== one.words; });
      lay_out();
    });
    drawn.push([graph, one, now]);
  }

  function lay_out() {
    place.textContent = '';
    select.textContent = '';
    select.appendChild(element('option', '', say('which_measure'), { value: '' }));
    drawn = [];
    all.forEach(function (one) {
      if (chosen.indexOf(one.words) >= 0) figure(one);
      else select.appendChild(element('option', '', said(one), { value: one.words }));
    });
    if (about.drawn) about.drawn();
  }
  select.addEventListener('change', function () {
    if (!select.value) return;
    chosen.push(select.value);
    lay_out();
  });

  function each(act) { drawn.forEach(function (one) { act(one[0], one[1], one[2]); }); }
  return {
    show: function (measures, what) {
      var words = measures.map(function (one) { return one.words; });
      var same = words.join() === all.map(function (one) { return one.words; }).join();
      all = measures;
      Object.assign(about, what);
      if (!same) {
        var kept = chosen.filter(function (one) { return words.indexOf(one) >= 0; });
        chosen = kept.length ? kept : first(words);
        lay_out();
        return;
      }
      // Graphs are redrawn in place, so that buttons stay under the pointer.
      drawn.forEach(function (one) {
        one[1] = measures[words.indexOf(one[1].words)];
        one[0].draw(one[1]);
      });
      if (about.drawn) about.drawn();
    },
    each: each
  };
};
