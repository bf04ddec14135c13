// Start page of the flume tank: a gallery of gears, and a new gear from a few numbers.
(function () {
  'use strict';
  function find(id) { return document.getElementById(id); }

  document.addEventListener('click', function (event) {
    var card = event.target.closest && event.target.closest('.gear-card');
    if (card) {
      window.codendPage.tell('gallery_refused', '');
      window.codendTalk.ask('shipped', card.dataset.gear, window.codendSay('settling_gear',
        { gear: card.querySelector('.card-title').textContent }));
    }
    if (event.target.id === 'gears') {
      window.codendPage.gallery(find('gallery').hidden);
    }
  });

  document.addEventListener('change', function (event) {
    if (event.target.id !== 'new_kind') return;
    document.querySelectorAll('.new-numbers').forEach(function (each) {
      each.hidden = each.dataset.kind !== event.target.value;
    });
  });

  function make() {
    var kind = find('new_kind').value, values = {};
    document.querySelectorAll('.new-numbers[data-kind="' + kind + '"] [data-ask]').forEach(function (each) {
      values[each.dataset.ask] = each.value;
    });
    window.codendPage.tell('new_error', '');
    window.codendTalk.ask('new', { kind: kind, values: values });
  }
  document.addEventListener('click', function (event) {
    if (event.target.id === 'make_gear') make();
  });
  document.addEventListener('keydown', function (event) {
    if (event.key === 'Enter' && event.target.dataset.ask) make();
  });
}());
