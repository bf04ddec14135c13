// Measures against a field of the design. The user chooses the range; R settles the gears.
//
// `codendVary`:
//   `show(message)` draws the results so far.
//   `stale()` marks the results as out of date after a change of the design.
//   `form()` updates the list of fields.
window.codendVary = (function () {
  'use strict';

  var say = window.codendSay, graphs = null, field = '', running = false;
  function find(id) { return document.getElementById(id); }

  // Sets the range to the limits of the field's slider.
  function ends() {
    var select = find('vary_field');
    if (select.value === field) return;
    field = select.value;
    var one = window.codendForm.field(field.split(' ')[0]);
    ['low', 'high'].forEach(function (name, k) {
      find(k ? 'vary_to' : 'vary_from').value = one && one[name] !== undefined ?
        (one[name] + ' ' + one.unit).trim() : '';
    });
  }

  function fill() {
    window.codendForm.offer(find('vary_field'));
    ends();
  }

  function show(message) {
    var varied = message.varied, done = varied.values.length;
    graphs = graphs || window.codendGraphs(find('vary_graphs'), find('vary_more'), function (words) {
      return words.slice(0, 4);
    });
    running = message.running;
    find('varied').hidden = false;
    $(find('varied')).trigger('shown');
    find('vary_stop').hidden = !running;
    var wrong = varied.values.map(function (value, k) {
      return varied.problems[k] && value + ' ' + varied.unit + ': ' + varied.problems[k];
    }).filter(Boolean);
    find('vary_said').textContent = say('values_done', { done: done, of: varied.of }) + (running ? ' \u2026' : '') +
      (wrong.length ? '. ' + wrong.join(' ') : '');
    if (!varied.measures.length) return;
    graphs.show(varied.measures, {
      times: varied.values, range: varied.range, unit: varied.unit,
      axis: varied.words + (varied.unit ? ' (' + varied.unit + ')' : ''),
      drawn: function () { graphs.each(function (graph) { if (varied.now !== null) graph.mark(varied.now); }); }
    });
  }

  document.addEventListener('change', function (event) {
    if (event.target.id === 'vary_field') ends();
  });
  document.addEventListener('click', function (event) {
    if (event.target.id === 'vary_stop') window.codendTalk.tell('vary_stop', Date.now());
    if (event.target.id !== 'vary_start') return;
    window.codendPage.tell('vary_error', '');
    window.codendPage.tell('vary_stale', '');
    var one = window.codendForm.field(field.split(' ')[0]);
    window.codendTalk.tell('vary_wanted', {
      paths: field.split(' '), unit: one ? one.unit : '', from: find('vary_from').value,
      to: find('vary_to').value, number: find('vary_number').valueAsNumber, asked: Date.now()
    });
  });

  return {
    show: show,
    stale: function () {
      if (!find('varied').hidden) {
        window.codendPage.tell('vary_stale', say('vary_stale'));
      }
    },
    form: fill
  };
}());
