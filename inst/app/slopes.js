// Effects of a small change of a field, next to the measures. The user chooses field and change; R
// computes the derivatives.
//
// `codendSlopes`:
//   `show(fields)` adds R's results to the known ones.
//   `stale()` discards all results after a change of the design.
//   `form()` updates the list of fields.
window.codendSlopes = (function () {
  'use strict';

  var element = window.codendView.element, say = window.codendSay;
  var found = {}, timer = null, amounts = {};
  function find(id) { return document.getElementById(id); }
  function key() { return find('more_field').value; }

  function ask(paths) {
    window.codendPage.tell('slopes_error', '');
    window.codendTalk.tell('slopes_wanted', { paths: paths, number: Date.now() });
  }

  // Requests derivatives of the chosen field if it is visible and unknown, after pending requests.
  function want() {
    window.clearTimeout(timer);
    if (!find('more_of').open) return;
    window.codendForm.offer(find('more_field'), /^floats\.number/);
    var one = found[key()];
    write();
    if (one || !key()) return;
    timer = window.setTimeout(function () {
      if (window.codendTalk.waits()) { want(); return; }
      ask(key().split(' '));
    }, 300);
  }

  function figures(x, like) {
    if (x === null) return '';
    var size = Math.abs(like), decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : 3;
    var text = Math.abs(x).toFixed(decimals);
    if (!/[1-9]/.test(text)) {
      if (!x) return '0';
      text = Math.abs(x).toPrecision(2);
    }
    return (x < 0 ? '\u2212' : '+') + text;
  }

  function write() {
    var place = find('more_does'), one = found[key()];
    place.textContent = '';
    find('more_amount').disabled = !one;
    if (!one) {
      find('more_unit').textContent = '';
      return;
    }
    find('more_unit').textContent = one.unit;
    var input = find('more_amount');
    if (document.activeElement !== input) {
      input.value = amounts[key()] === undefined ? one.more : amounts[key()];
    }
    var more = input.valueAsNumber;
    if (!isFinite(more)) return;
    var scroll = element('div', 'table-scroll', undefined, { tabindex: 0, role: 'region',
      'aria-label': say('would_do') });
    var table = element('table', 'table table-sm flume-table'), body = element('tbody'), kinks = false;
    one.measures.forEach(function (words, k) {
      var change = one.slope[k] * more;
      // Measures that the field does not affect are omitted.
      if (Math.abs(change) < 1e-9) return;
      var row = element('tr');
      row.appendChild(element('th', '', words + ' (' + one.units[k] + ')', { scope: 'row' }));
      var cell = element('td', 'number', figures(change, change));
      if (!one.smooth[k]) {
        kinks = true;
        cell.appendChild(element('abbr', 'kink', ' ' + say('kink'), { title: say('kink_tip', {
          below: figures(-one.below[k] * more, change), above: figures(one.above[k] * more, change) }) }));
      }
      row.appendChild(cell);
      body.appendChild(row);
    });
    table.appendChild(body);
    scroll.appendChild(table);
    place.appendChild(scroll);
    place.appendChild(element('p', 'note', say('slope_at', {
      value: (Number(one.value.toPrecision(6)) + ' ' + one.unit).trim()
    }) + (kinks ? ' ' + say('kink_note') : '')));
  }

  function show(fields) {
    (fields || []).forEach(function (one) { found[one.paths.join(' ')] = one; });
    write();
  }

  document.addEventListener('toggle', function (event) {
    if (event.target.id === 'more_of') want();
  }, true);
  document.addEventListener('change', function (event) {
    if (event.target.id === 'more_field') want();
  });
  document.addEventListener('input', function (event) {
    if (event.target.id !== 'more_amount') return;
    amounts[key()] = event.target.valueAsNumber;
    write();
  });
  document.addEventListener('click', function (event) {
    if (event.target.id === 'slopes_table') ask(null);
    if (event.target.id !== 'slopes_all') return;
    ask(null);
    var tab = document.querySelector('#shown [data-value="Slopes"]');
    tab.click();
    tab.scrollIntoView({ block: 'start' });
  });

  return {
    show: show,
    stale: function () { found = {}; want(); },
    form: want
  };
}());
