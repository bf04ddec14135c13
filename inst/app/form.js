// The flume tank's form: all fields of the plan, from the description that R/flume-form.R makes of
// the schema. Edits are sent to R as changes of the plan that the form shows.
//
// `codendForm`:
//   `show(message)` builds the form.
//   `open(path, quiet)` opens the part of a path.
//   `answered(number)`, `refused(message)` handle R's replies.
//   `offers(message)` lists the fields that can be added.
window.codendForm = (function () {
  'use strict';

  var element = window.codendView.element, say = window.codendSay;
  var form = null;       // R's description of the form
  var moved = {};        // unsent edits by path
  var sent = null;       // number of the pending request
  var typing = null;     // timer while a number is typed
  var anew = false;      // true if R must send a new form with the reply
  var last = null;       // control that was edited last
  var gesture = 0;       // number of the present gesture, which undo reverts as one step
  var opened = {};       // open groups and parts, by title or path
  var made = 0;          // number of controls, for their ids
  var preferred = {};
  // Units that a preferred unit replaces. Mesh sizes stay in millimetres.
  var large = {
    length: ['m', 'metre', 'metres', 'meter', 'meters', 'fathom', 'fathoms', 'ft', 'foot', 'feet'],
    force: ['kN', 'tf', 'lbf', 'kgf'], speed: ['m/s', 'knot', 'knots', 'kn', 'kt', 'kts']
  };

  function find(id) { return document.getElementById(id); }
  function tidy(value) { return Number(value.toPrecision(6)); }

  // ---- a control ----------------------------------------------------------------------------------

  function units_of(field) {
    var all = [[field.unit, field.factor]], known = form.units[field.dimension] || {};
    Object.keys(known).forEach(function (unit) {
      if (Math.abs(known[unit] / field.factor - 1) > 1e-12) all.push([unit, known[unit]]);
    });
    return all;
  }

  // Returns the preferred unit of a field, or null if the unit of the field stays.
  function liked(field) {
    var wanted = preferred[field.dimension], sizes = large[field.dimension];
    if (!wanted || !sizes || sizes.indexOf(field.unit) < 0 || wanted === field.unit) return null;
    var factor = (form.units[field.dimension] || {})[wanted];
    return factor ? { unit: wanted, factor: factor } : null;
  }

  function number_row(field, id, box) {
    var row = element('div', 'control-row'), known = typeof field.value === 'number';
    var like = liked(field), share = like ? field.factor / like.factor : 1;
    function shown(value) { return share === 1 ? value : tidy(value * share); }
    if (known && field.low !== undefined) {
      row.appendChild(element('input', 'form-range', undefined, {
        type: 'range', min: shown(field.low), max: shown(field.high), step: shown(field.step),
        'aria-label': field.label
      }));
      row.lastChild.value = shown(field.value);
      row.lastChild.setAttribute('aria-valuetext', shown(field.value) + ' ' + field.unit);
    }
    var input = element('input', 'form-control form-control-sm number', undefined, {
      type: 'text', id: id, inputmode: 'text', autocomplete: 'off', spellcheck: 'false',
      'aria-describedby': id + '_help ' + id + '_error ' + id + '_echo'
    });
    if (known) input.value = shown(field.value);
    else if (field.typed) input.value = field.typed;
    row.appendChild(input);
    if (field.dimension) {
      var select = element('select', 'form-select form-select-sm unit', undefined,
        { 'aria-label': say('unit_of', { label: field.label }) });
      units_of(field).forEach(function (one) {
        select.appendChild(element('option', '', say.unit(one[0]), { value: one[0], 'data-factor': one[1] }));
      });
      select.value = like ? like.unit : field.unit;
      select.dataset.factor = like ? like.factor : field.factor;
      row.appendChild(select);
    }
    box.appendChild(row);
    return row;
  }

  function text_row(field, id, box) {
    var row = element('div', 'control-row'), input;
    if (field.kind === 'yaml' && String(field.value).length > 40) {
      input = element('textarea', 'form-control form-control-sm text', undefined, { rows: 2 });
    } else {
      input = element('input', 'form-control form-control-sm text', undefined, { type: 'text' });
    }
    input.id = id;
    input.spellcheck = false;
    input.setAttribute('autocomplete', 'off');
    input.setAttribute('aria-describedby', id + '_help ' + id + '_error');
    input.value = field.value;
    if (field.kind === 'yaml') input.placeholder = say('as_plan_writes');
    row.appendChild(input);
    if (field.suggest && field.suggest.length) {
      var list = element('datalist', '', undefined, { id: id + '_list' });
      field.suggest.forEach(function (one) {
        list.appendChild(element('option', '', undefined, { value: one }));
      });
      input.setAttribute('list', list.id);
      row.appendChild(list);
    }
    box.appendChild(row);
    return row;
  }

  // removable: true if the user may delete the field.
  function control(field, removable) {
    made += 1;
    var id = 'control_' + made;
    var box = element('div', 'control', undefined, {
      'data-control': id, 'data-kind': field.kind, 'data-paths': field.paths.join(' ')
    });
    var label = element('label', '', field.label, { 'for': id }), row;
    if (field.kind === 'truth') {
      row = element('div', 'form-check');
      var tick = element('input', 'form-check-input truth', undefined,
        { type: 'checkbox', id: id, 'aria-describedby': id + '_help ' + id + '_error' });
      tick.checked = field.value === true;
      label.className = 'form-check-label';
      row.appendChild(tick);
      row.appendChild(label);
      box.appendChild(row);
    } else {
      box.appendChild(label);
      if (field.kind === 'number') row = number_row(field, id, box);
      else if (field.kind === 'choice') {
        row = element('div', 'control-row');
        var select = element('select', 'form-select form-select-sm choice', undefined,
          { id: id, 'aria-describedby': id + '_help ' + id + '_error' });
        if (!field.value) select.appendChild(element('option', '', '', { value: '' }));
        field.choices.forEach(function (one) {
          select.appendChild(element('option', '', one.replace(/_/g, ' '), { value: one }));
        });
        select.value = field.value;
        row.appendChild(select);
        box.appendChild(row);
      } else row = text_row(field, id, box);
    }
    if (removable) {
      row.appendChild(element('button', 'take-out', '\u00d7', {
        type: 'button', 'aria-label': say('take_out', { label: field.label }), title: say('take_out_tip')
      }));
    }
    var help = [field.help, field.must && say('must_be', { must: field.must })].filter(Boolean).join(' ');
    box.appendChild(element('p', 'help note', help, { id: id + '_help', lang: 'en' }));
    box.appendChild(element('p', 'echo note', '', { id: id + '_echo', hidden: '' }));
    box.appendChild(element('p', 'field-error', '', { id: id + '_error', hidden: '' }));
    return box;
  }

  // ---- groups and parts ---------------------------------------------------------------------------

  function fold(kind, key, title, count, fill) {
    var box = element('details', kind, undefined, { 'data-key': key });
    var head = element('summary', '', title);
    if (count) head.appendChild(element('span', 'count', count));
    box.appendChild(head);
    var filled = false;
    function now() {
      if (filled) return;
      filled = true;
      fill(box);
    }
    box.fill = now;
    box.addEventListener('toggle', function () {
      if (box.open) now();
      opened[key] = box.open;
    });
    if (opened[key]) { now(); box.open = true; }
    return box;
  }

  function part_tools(part, title, box) {
    var tools = element('div', 'part-tools');
    if (part.open) {
      tools.appendChild(element('button', 'btn btn-outline-secondary btn-sm add-field', say('add_field'),
        { type: 'button', 'data-path': part.path, 'data-title': title }));
    }
    if (part.named) {
      var its = { part: part.title };
      [['copy', say('copy'), say('copy_part', its)], ['rename', say('rename'), say('rename_part', its)],
        ['ahead', '\u2191', say('move_ahead', its)], ['behind', '\u2193', say('move_behind', its)]].forEach(function (one) {
        tools.appendChild(element('button', 'btn btn-outline-secondary btn-sm part-act', one[1],
          { type: 'button', 'data-path': part.path, 'data-act': one[0], 'aria-label': one[2] }));
      });
    }
    if (part.path && !part.required) {
      tools.appendChild(element('button', 'btn btn-outline-danger btn-sm take-part', say('take_part'),
        { type: 'button', 'data-path': part.path, 'aria-label': say('take_out', { label: part.title }) }));
    }
    (part.picks || []).forEach(function (pick) {
      tools.appendChild(element('button', 'btn btn-outline-secondary btn-sm pick', say('from_catalogue') +
        (pick.path === part.path ? '' : ': ' + say.field(pick.path.split('.').pop())), { type: 'button',
        'data-path': pick.path, 'data-classes': pick.classes.join(' ') }));
    });
    if (tools.childNodes.length) box.appendChild(tools);
  }

  // ---- the catalogue ------------------------------------------------------------------------------

  var known = null, own = [], listed = null;
  // Stores the user's own catalogue rows and refreshes an open list.
  function take_own(rows) {
    own = rows || [];
    if (listed) listed();
    window.codendDesigns.moved();
  }
  function tell_own(rows) {
    window.codendPage.tell('own_error', '');
    window.codendTalk.tell('own', { number: Date.now(), rows: rows });
  }

  // Returns the form for a new catalogue row of the user.
  function own_form(kind) {
    var box = element('details', 'own-row'), fields = known.fields[kind], inputs = {};
    box.appendChild(element('summary', '', say('own_row')));
    function ask(name, label) {
      var line = element('label', '', label);
      inputs[name] = element('input', 'form-control form-control-sm', undefined,
        { type: 'text', autocomplete: 'off', maxlength: 60, 'data-own': name });
      line.appendChild(inputs[name]);
      box.appendChild(line);
    }
    ask('title', say('own_name'));
    Object.keys(fields).forEach(function (name) {
      ask(name, say.field(name) + (fields[name] ? ' (' + say.unit(fields[name]) + ')' : ''));
    });
    var add = element('button', 'btn btn-primary btn-sm own-add', say('own_add'), { type: 'button' });
    add.addEventListener('click', function () {
      var values = {};
      Object.keys(fields).forEach(function (name) { values[name] = inputs[name].value; });
      tell_own(own.concat([{ 'class': kind, title: inputs.title.value, values: values }]));
    });
    box.appendChild(add);
    box.appendChild(element('p', 'field-error', '', { id: 'own_error', role: 'alert', hidden: '' }));
    return box;
  }

  // Replaces a button by a list of catalogue items that fit its part, at most `found`.
  function pick_from(button) {
    var found = 40, path = button.dataset.path, classes = button.dataset.classes.split(' ');
    known = known || JSON.parse(find('catalogue').textContent);
    // Only one list is open at a time.
    if (listed) listed.close();
    function fitting(things) {
      return things.filter(function (thing) { return classes.indexOf(thing['class']) >= 0; });
    }
    var fits = fitting(known.things);
    var box = element('div', 'picks'), input = element('input', 'form-control form-control-sm', undefined,
      { type: 'search', 'aria-label': say('find_in_catalogue'), placeholder: say('find_such_as',
        { word: fits[0] ? fits[0].title.split(' ')[0] : '' }), autocomplete: 'off' });
    var list = element('ul', 'pick-list');
    function row(thing) {
      var facts = Object.keys(thing.values).map(function (name) {
        return say.field(name) + ' ' + thing.values[name].replace(/_/g, ' ');
      });
      var item = element('li'), one = element('button', 'btn btn-link btn-sm', thing.title, { type: 'button' });
      item.appendChild(one);
      if (own.indexOf(thing) >= 0) {
        var out = element('button', 'take-out', '\u00d7', { type: 'button',
          'aria-label': say('take_out', { label: thing.title }) });
        out.addEventListener('click', function (event) {
          event.stopPropagation();
          tell_own(own.filter(function (each) { return each !== thing; }));
        });
        item.appendChild(out);
      }
      item.appendChild(element('span', 'note', facts.join(', ') + (thing.says ? '. ' + thing.says : '') +
        '. ' + say('source', { source: thing.source === 'own' ? say('own_source') : thing.source })));
      one.addEventListener('click', function () {
        var all = {};
        Object.keys(thing.values).forEach(function (name) {
          all[path + '.' + name] = { value: thing.values[name], unit: '' };
        });
        edits(all);
        close();
      });
      return [item, (thing.title + ' ' + facts.join(' ') + ' ' + thing.says).toLowerCase()];
    }
    function close() {
      listed = null;
      box.replaceWith(button);
    }
    var rows = fits.map(row);
    function narrow() {
      var words = input.value.trim().toLowerCase().replace(',', '.').split(/\s+/).filter(Boolean);
      list.textContent = '';
      fitting(own).map(row).concat(rows).filter(function (one) {
        return words.every(function (word) { return one[1].indexOf(word) >= 0; });
      }).slice(0, found).forEach(function (one) { list.appendChild(one[0]); });
      if (!list.childNodes.length) list.appendChild(element('li', 'note', say('nothing_here')));
    }
    input.addEventListener('input', narrow);
    box.addEventListener('keydown', function (event) {
      if (event.key === 'Escape') { close(); button.focus(); }
    });
    box.appendChild(input);
    box.appendChild(list);
    box.appendChild(own_form(classes[0]));
    listed = narrow;
    listed.close = close;
    narrow();
    button.replaceWith(box);
    input.focus();
  }

  function fill_part(part, title, box) {
    if (part.help) box.appendChild(element('p', 'note', part.help, { lang: 'en' }));
    if (part.named) part_tools(part, title, box);
    (part.fields || []).forEach(function (field) { box.appendChild(control(field, !field.required)); });
    if (!part.named) part_tools(part, title, box);
  }

  function group(one) {
    var parts = one.parts || [];
    var count = parts.length > 1 ? say('parts_many', { n: parts.length }) : '';
    return fold('group', one.title, one.words, count, function (box) {
      parts.forEach(function (part) {
        if (!part.path) { fill_part(part, one.title, box); return; }
        box.appendChild(fold('part', part.path, part.title, '', function (inner) {
          inner.dataset.path = part.path;
          fill_part(part, one.title, inner);
        }));
      });
      if (one.open) {
        var tools = element('div', 'part-tools');
        tools.appendChild(element('button', 'btn btn-outline-secondary btn-sm add-field',
          say('add_to', { group: one.words.toLowerCase() }), { type: 'button', 'data-path': '', 'data-title': one.title }));
        box.appendChild(tools);
      }
    });
  }

  function lay_out() {
    var at = document.activeElement && document.activeElement.closest('.control');
    var focused = at && [at.dataset.paths, document.activeElement.type];
    var quick = find('quick'), all = find('form'), kept = window.scrollY;
    quick.textContent = '';
    (form.quick || []).forEach(function (field) { quick.appendChild(control(field, false)); });
    all.textContent = '';
    form.groups.forEach(function (one) {
      if ((one.parts && one.parts.length) || one.open) all.appendChild(group(one));
    });
    search();
    mark();
    window.scrollTo({ top: kept, behavior: 'instant' });
    if (focused) {
      controls_of(focused[0].split(' ')[0]).some(function (box) {
        var to = box.querySelector('[type="' + focused[1] + '"]') || box.querySelector('input, select');
        if (to) to.focus({ preventScroll: true });
        return !!to;
      });
    }
  }

  function controls_of(path) {
    return [].slice.call(document.querySelectorAll('.control')).filter(function (box) {
      return box.dataset.paths.split(' ').indexOf(path) >= 0;
    });
  }

  // Opens the part of a path, or its nearest parent. Returns false if there is none.
  // quiet: true leaves the keyboard focus unchanged.
  function open(path, quiet) {
    if (!form) return false;
    var steps = path.split('.'), found = null;
    while (steps.length && !found) {
      var near = steps.join('.');
      form.groups.forEach(function (one) {
        (one.parts || []).forEach(function (part) {
          var own = part.path === near || (part.fields || []).some(function (field) {
            return field.paths.indexOf(near) >= 0;
          });
          if (own && !found) found = [one.title, part.path, near];
        });
      });
      steps.pop();
    }
    if (!found) return false;
    find('find_field').value = '';
    search();
    var outer = [].slice.call(document.querySelectorAll('#form > .group')).filter(function (box) {
      return box.dataset.key === found[0];
    })[0];
    outer.fill();
    outer.open = true;
    var inner = [].slice.call(outer.querySelectorAll('.part')).filter(function (box) {
      return box.dataset.key === found[1];
    })[0];
    if (inner) { inner.fill(); inner.open = true; }
    var box = controls_of(found[2]).filter(function (one) { return outer.contains(one); })[0];
    var target = box || inner || outer;
    document.querySelectorAll('.marked').forEach(function (one) { one.classList.remove('marked'); });
    target.classList.add('marked');
    if (quiet) return true;
    target.scrollIntoView({ block: 'nearest' });
    var field = target.querySelector('input[type=text], select, textarea, input');
    if (field) field.focus({ preventScroll: true });
    return true;
  }

  // ---- search -------------------------------------------------------------------------------------

  function search() {
    var words = say.bare(find('find_field').value).split(/\s+/).filter(Boolean);
    var all = find('form'), place = find('found_fields');
    if (!place) {
      place = element('div', '', undefined, { id: 'found_fields' });
      all.parentNode.insertBefore(place, all);
    }
    place.textContent = '';
    all.hidden = words.length > 0;
    if (!words.length || !form) return;
    var found = matches(words);
    found.fields.slice(0, 30).forEach(function (one) {
      var field = Object.assign({}, one[1], {
        label: (one[0].path ? one[0].title + ': ' : '') + one[1].label.toLowerCase()
      });
      place.appendChild(control(field, !field.required));
    });
    var n = found.fields.length;
    if (n !== 1) {
      place.appendChild(element('p', 'note', n > 30 ? say('and_more_fields', { n: n - 30 }) :
        n ? say('fields_many', { n: n }) : say('no_field')));
    }
    if (n || !found.absent.length) return;
    place.appendChild(element('p', 'note', say('could_have')));
    found.absent.slice(0, 8).forEach(function (one) {
      var tools = element('div', 'part-tools');
      tools.appendChild(element('button', 'btn btn-outline-secondary btn-sm add-field', one.label,
        { type: 'button', 'data-path': one.path, 'data-title': one.title, 'data-wanted': one.wanted }));
      place.appendChild(tools);
    });
  }

  // Returns the present and absent fields that match all words. Words match anywhere in names and
  // labels, and at the start of synonyms in any language.
  function matches(words) {
    var found = { fields: [], absent: [] };
    function has(text, paths) {
      text = say.bare(text + ' ' + paths.replace(/[._]/g, ' '));
      var called = ' ' + say.sought(paths);
      return words.every(function (word) { return text.indexOf(word) >= 0 || called.indexOf(' ' + word) >= 0; });
    }
    form.groups.forEach(function (one) {
      (one.absent || []).forEach(function (name) {
        if (has('', name)) found.absent.push({ label: say.field(name), path: '', title: one.title, wanted: name });
      });
      (one.parts || []).forEach(function (part) {
        (part.fields || []).forEach(function (field) {
          if (has([one.title, one.words, part.title, field.label].join(' '), field.paths.join(' '))) {
            found.fields.push([part, field]);
          }
        });
        (part.absent || []).forEach(function (path) {
          var steps = path.split('.'), name = steps.pop();
          if (has('', name)) {
            found.absent.push({ label: say.path(path), path: steps.join('.'), title: one.title, wanted: path });
          }
        });
      });
    });
    return found;
  }
  document.addEventListener('input', function (event) {
    if (event.target.id === 'find_field') search();
  });

  // ---- edits --------------------------------------------------------------------------------------

  function send() {
    if (sent || !Object.keys(moved).length) return;
    sent = window.codendTalk.next('settling');
    var edits = moved;
    moved = {};
    Shiny.setInputValue('design', { number: sent, turn: form.turn, gesture: gesture, edits: edits,
      anew: anew }, { priority: 'event' });
    anew = false;
  }

  function change(box, edit) {
    if (last !== box) gesture += 1;
    last = box;
    box.dataset.paths.split(' ').forEach(function (path) {
      delete moved[path];
      moved[path] = edit;
    });
    send();
  }

  // Applies a change as an undo step of its own.
  function edit(path, what) {
    var one = {};
    one[path] = what;
    edits(one);
  }
  function edits(all) {
    gesture += 1;
    last = null;
    Object.keys(all).forEach(function (path) {
      delete moved[path];
      moved[path] = all[path];
    });
    anew = true;
    send();
    gesture += 1;
  }

  // Copies an edit to the other controls of the same field.
  function mirror(box, edit) {
    controls_of(box.dataset.paths.split(' ')[0]).forEach(function (other) {
      if (other === box || other.dataset.kind !== box.dataset.kind) return;
      if (other.dataset.kind === 'number') {
        var unit = other.querySelector('.unit'), mine = box.querySelector('.unit'), value = edit.value;
        if (unit && mine && typeof value === 'number') value = tidy(value * mine.dataset.factor / unit.dataset.factor);
        other.querySelector('.number').value = value;
        reach(other.querySelector('[type=range]'), value);
      } else if (other.dataset.kind === 'truth') other.querySelector('.truth').checked = edit.value;
      else other.querySelector('.choice, .text').value = edit.value;
    });
  }

  // Extends the range of a slider to a typed value.
  function reach(slider, value) {
    if (!slider) return;
    if (value < Number(slider.min)) slider.min = value;
    if (value > Number(slider.max)) slider.max = value;
    slider.value = value;
  }

  function move(box, source) {
    var kind = box.dataset.kind, edit;
    if (kind === 'number') {
      var slider = box.querySelector('[type=range]'), field = box.querySelector('.number');
      var unit = box.querySelector('.unit');
      if (source === slider) field.value = slider.value;
      var typed = field.value.trim(), plain = /^[-+]?\d*\.?\d+$/.test(typed);
      if (!typed) return;
      if (source === field && plain) reach(slider, Number(typed));
      edit = { value: source === slider ? Number(typed) : typed, unit: unit ? unit.value : '' };
      if (slider) slider.setAttribute('aria-valuetext', typed + ' ' + edit.unit);
    } else if (kind === 'truth') {
      edit = { value: box.querySelector('.truth').checked };
    } else {
      edit = { value: box.querySelector('.choice, .text').value };
      if (edit.value === '') return;
    }
    mirror(box, edit);
    change(box, edit);
  }

  // Converts the displayed numbers to another unit.
  function convert(box, unit) {
    var option = unit.selectedOptions[0], before = Number(unit.dataset.factor);
    var share = before / Number(option.dataset.factor);
    unit.dataset.factor = option.dataset.factor;
    var slider = box.querySelector('[type=range]'), field = box.querySelector('.number');
    if (field.value === '' || !isFinite(Number(field.value))) return;
    var value = tidy(Number(field.value) * share);
    if (slider) {
      var ends = [tidy(slider.min * share), tidy(slider.max * share)], step = tidy(slider.step * share);
      slider.min = ends[0];
      slider.max = ends[1];
      slider.step = step;
      slider.value = value;
    }
    field.value = value;
  }

  document.addEventListener('input', function (event) {
    var box = event.target.closest('.control'), target = event.target;
    if (!box) return;
    if (target.type === 'range') move(box, target);
    else if (target.classList.contains('number')) {
      window.clearTimeout(typing);
      typing = window.setTimeout(function () { typing = null; move(box, target); }, 400);
    }
  });
  document.addEventListener('change', function (event) {
    var box = event.target.closest('.control'), target = event.target;
    if (!box) return;
    if (target.classList.contains('unit')) convert(box, target);
    else if (target.classList.contains('number')) {
      if (typing !== null) { window.clearTimeout(typing); typing = null; move(box, target); }
    } else if (target.matches('.choice, .truth, .text')) move(box, target);
    gesture += 1;
  });

  document.addEventListener('click', function (event) {
    var button = event.target.closest('button');
    if (!button) return;
    if (button.classList.contains('take-out')) {
      var box = button.closest('.control');
      change(box, { gone: true });
    } else if (button.classList.contains('take-part')) {
      edit(button.dataset.path, { gone: true });
    } else if (button.classList.contains('pick')) {
      pick_from(button);
    } else if (button.classList.contains('doubt')) {
      edit(button.dataset.path, { value: button.dataset.instead, unit: '' });
    } else if (button.classList.contains('add-field')) {
      adding = button;
      Shiny.setInputValue('offers', { path: button.dataset.path, title: button.dataset.title },
        { priority: 'event' });
    } else if (button.classList.contains('part-act')) {
      var act = button.dataset.act;
      if (act === 'ahead' || act === 'behind') {
        edit(button.dataset.path, { move: act === 'ahead' ? -1 : 1 });
      } else ask_name(button, act);
    }
  });

  // Shows a text field for the name of a copy or for a new name.
  function ask_name(button, act) {
    var path = button.dataset.path, steps = path.split('.'), name = steps.pop(), parent = steps.join('.');
    var number = name.match(/^(.*?)(\d+)$/);
    var row = element('form', 'control-row name-row');
    var input = element('input', 'form-control form-control-sm', undefined,
      { type: 'text', 'aria-label': act === 'copy' ? say('copy_name') : say('new_name', { name: name }),
        autocomplete: 'off' });
    input.value = act === 'rename' ? name : number ? number[1] + (Number(number[2]) + 1) : name + '_2';
    row.appendChild(input);
    row.appendChild(element('button', 'btn btn-primary btn-sm', act === 'copy' ? say('copy') : say('rename'),
      { type: 'submit' }));
    row.addEventListener('submit', function (event) {
      event.preventDefault();
      var made = input.value.trim().replace(/[^A-Za-z0-9_]+/g, '_');
      if (!made || made === name) return;
      opened[parent + '.' + made] = true;
      window.codendDrawing.seek(parent + '.' + made);
      if (act === 'copy') edit(parent + '.' + made, { like: path, after: name });
      else edit(path, { rename: made });
    });
    button.replaceWith(row);
    input.select();
    input.focus();
  }

  var adding = null;  // the button that requested the list of fields
  // Lists the fields that can be added. The chosen field becomes a control.
  function offers(message) {
    var button = adding;
    if (button && (button.dataset.path !== message.path || button.dataset.title !== message.title)) return;
    if (!button || !button.isConnected) return;
    var all = message.offers || [];
    var select = element('select', 'form-select form-select-sm offered', undefined,
      { 'aria-label': say('field_to_add') });
    select.appendChild(element('option', '', say('which_field'), { value: '' }));
    all.forEach(function (field, k) {
      select.appendChild(element('option', '', field.label, { value: k, title: field.help }));
    });
    select.addEventListener('change', function () {
      if (select.value === '') return;
      var field = all[Number(select.value)], tools = select.closest('.part-tools');
      var box = control(field, false);
      box.classList.add('marked');
      tools.parentNode.insertBefore(box, tools);
      opened[field.paths[0]] = true;
      select.replaceWith(button);
      var input = box.querySelector('input, select, textarea');
      input.focus();
    });
    button.replaceWith(select);
    var wanted = all.map(function (field) { return field.paths[0]; }).indexOf(button.dataset.wanted);
    if (wanted >= 0) {
      select.value = wanted;
      select.dispatchEvent(new Event('change'));
    } else select.focus();
  }

  // ---- problems -----------------------------------------------------------------------------------

  function show_error(box, words) {
    var place = box.querySelector('.field-error');
    if (!place) return false;
    place.textContent = words;
    place.hidden = !words;
    box.querySelectorAll('input, select, textarea').forEach(function (field) {
      if (words) field.setAttribute('aria-invalid', 'true');
      else field.removeAttribute('aria-invalid');
    });
    return true;
  }
  // Marks all fields and parts that prevent the draft from settling.
  var problems = [];
  function plain_path(path) { return (path || '').replace(/\[(\d+)\]/g, '.$1'); }
  function mark() {
    document.querySelectorAll('.control').forEach(function (box) { show_error(box, ''); });
    document.querySelectorAll('.group, .part').forEach(function (box) { box.classList.remove('wrong'); });
    problems.forEach(function (problem) {
      var path = plain_path(problem.path);
      if (!path) return;
      form.groups.forEach(function (one) {
        (one.parts || []).forEach(function (part) {
          var in_part = part.path && (path === part.path || path.indexOf(part.path + '.') === 0);
          if (!in_part && !(part.fields || []).some(function (f) { return f.paths.indexOf(path) >= 0; })) return;
          document.querySelectorAll('.group, .part').forEach(function (box) {
            if (box.dataset.key === one.title || (part.path && box.dataset.key === part.path)) {
              box.classList.add('wrong');
            }
          });
        });
      });
      controls_of(path).forEach(function (box) { show_error(box, problem.message); });
    });
  }

  // Displays R's interpretation of typed numbers, with its doubts.
  function echo(understood) {
    Object.keys(understood || {}).forEach(function (path) {
      var one = understood[path];
      if (!one) return;
      controls_of(path).forEach(function (box) {
        var place = box.querySelector('.echo');
        if (!place) return;
        place.textContent = '= ' + one.text + (one.doubt ? '. ' + one.doubt.message + ' ' : '');
        place.hidden = false;
        if (one.doubt && one.doubt.instead) {
          place.appendChild(element('button', 'btn btn-outline-secondary btn-sm doubt',
            say('no_instead', { instead: one.doubt.instead }),
            { type: 'button', 'data-path': path, 'data-instead': one.doubt.instead }));
        }
      });
    });
  }

  // message: {understood, problems, settling}.
  function draft(message) {
    if (!form) return;
    if (!message.settling) {
      problems = message.problems || [];
      mark();
      var list = find('draft_problems');
      list.textContent = '';
      problems.forEach(function (problem) {
        var item = element('li'), path = plain_path(problem.path);
        if (path) {
          item.appendChild(element('button', 'btn btn-link btn-sm go-to', problem.message,
            { type: 'button', 'data-path': path }));
        } else item.textContent = problem.message;
        list.appendChild(item);
      });
      find('unfinished').hidden = !problems.length;
      window.codendDrawing.wrong(problems.map(function (one) { return plain_path(one.path); }));
    }
    echo(message.understood);
  }
  document.addEventListener('click', function (event) {
    var button = event.target.closest && event.target.closest('.go-to');
    if (!button) return;
    open(button.dataset.path);
    window.codendDrawing.seek(button.dataset.path);
  });

  // Marks the control of a rejected edit. Returns false if no control shows it.
  function refused(message) {
    if (message.answers !== sent) return false;
    var boxes = message.path ? controls_of(plain_path(message.path)) : [];
    boxes.forEach(function (box) { show_error(box, message.message); });
    return boxes.length > 0;
  }

  function answered(number) {
    if (number !== sent) return;
    sent = null;
    send();
  }

  return {
    show: function (message) {
      if (form && form.turn !== message.turn) moved = {};
      form = message;
      last = null;
      lay_out();
    },
    prefer: function (units) {
      preferred = units;
      if (form) lay_out();
    },
    open: open,
    draft: draft,
    edit: edit,
    edits: edits,
    own: take_own,
    turn: function () { return form ? form.turn : null; },
    // Returns the field of a path in its displayed unit, or null.
    field: function (path) {
      var found = null;
      if (form) form.groups.forEach(function (one) {
        (one.parts || []).forEach(function (part) {
          (part.fields || []).forEach(function (field) {
            if (field.paths.indexOf(path) >= 0) found = field;
          });
        });
      });
      if (!found) return null;
      var like = found.kind === 'number' && liked(found);
      function shown(value) {
        return typeof value === 'number' && like ? tidy(value * found.factor / like.factor) : value;
      }
      return { label: found.label, kind: found.kind, choices: found.choices, suggest: found.suggest,
        unit: like ? like.unit : found.unit || '', value: found.typed || shown(found.value),
        low: shown(found.low), high: shown(found.high) };
    },
    // Fills a list with all numeric fields, frequently changed ones first. The selection stays; the
    // default is the field whose path matches `first`.
    offer: function (select, first) {
      var groups = [element('optgroup', '', undefined, { label: say('changed_first') }),
        element('optgroup', '', undefined, { label: say('all_others') })];
      var names = [], before = select.value;
      function take(field, label, group) {
        var key = field.paths.join(' ');
        if (field.kind !== 'number' || !field.value || names.indexOf(key) >= 0) return;
        names.push(key);
        groups[group].appendChild(element('option', '', label, { value: key }));
      }
      if (form) {
        (form.quick || []).forEach(function (field) { take(field, field.label, 0); });
        form.groups.forEach(function (one) {
          (one.parts || []).forEach(function (part) {
            (part.fields || []).forEach(function (field) {
              take(field, (part.path ? part.title + ': ' : '') + field.label.toLowerCase(), 1);
            });
          });
        });
      }
      if (select.dataset.names === names.join('|')) return;
      select.dataset.names = names.join('|');
      select.textContent = '';
      groups.forEach(function (group) { if (group.childNodes.length) select.appendChild(group); });
      var liked = first && names.filter(function (name) { return first.test(name); })[0];
      select.value = names.indexOf(before) >= 0 ? before : liked || names[0];
    },
    offers: offers,
    answered: answered,
    refused: refused,
    // Returns true if no edit is pending.
    still: function () { return !sent && typing === null; }
  };
}());
