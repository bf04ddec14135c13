// The flume tank's controls: sends what they say to R, one question at a time and always the latest
// values, and shows what R answers.
(function () {
  'use strict';

  var moved = {};        // values of the controls that were moved since they were laid out
  var number = 0;        // of the last question
  var asked = 0;         // number of the question that waits for an answer, or 0
  var more = false;      // whether something moved since
  var largestPlan = 2 * 1024 * 1024;

  function find(id) { return document.getElementById(id); }

  function ask() {
    if (asked) { more = true; return; }
    more = false;
    asked = ++number;
    window.setTimeout(function () { find('working').hidden = !asked; }, 300);
    Shiny.setInputValue('design', { number: number, values: moved }, { priority: 'event' });
  }

  function answered(by) {
    if (by !== asked) return;
    asked = 0;
    find('working').hidden = true;
    if (more) ask();
  }

  function show(id, words) {
    var place = find(id);
    if (!place) return;
    place.textContent = words || '';
    place.hidden = !words;
  }

  function clearErrors() {
    document.querySelectorAll('.field-error').forEach(function (place) { show(place.id, ''); });
    document.querySelectorAll('[aria-invalid]').forEach(function (field) {
      field.removeAttribute('aria-invalid');
    });
    show('refused', '');
  }

  function refuseField(control, words) {
    show(control.dataset.control + '_error', words);
    control.querySelectorAll('input, select').forEach(function (field) {
      field.setAttribute('aria-invalid', 'true');
    });
  }

  // ---- moving controls --------------------------------------------------------------------------

  function tidy(value) { return Number(value.toPrecision(6)); }

  function move(control, source) {
    var kind = control.dataset.kind, id = control.dataset.control;
    if (kind === 'choice') {
      moved[id] = { value: control.querySelector('.choice').value };
    } else if (kind === 'truth') {
      moved[id] = { value: control.querySelector('.truth').checked };
    } else {
      var slider = control.querySelector('[type=range]');
      var field = control.querySelector('[type=number]');
      var unit = control.querySelector('.unit');
      if (source === slider) field.value = slider.value;
      if (field.value === '' || !isFinite(field.valueAsNumber)) {
        refuseField(control, 'A number is needed here.');
        return;
      }
      if (source === field) reach(slider, field.valueAsNumber);
      moved[id] = { value: field.valueAsNumber, unit: unit ? unit.value : '' };
      slider.setAttribute('aria-valuetext', field.value + ' ' + moved[id].unit);
    }
    ask();
  }

  // A slider goes as far as the number beside it.
  function reach(slider, value) {
    if (value < Number(slider.min)) slider.min = value;
    if (value > Number(slider.max)) slider.max = value;
    slider.value = value;
  }

  // Another unit says the same in other numbers.
  function convert(control, unit) {
    var option = unit.selectedOptions[0], before = Number(unit.dataset.factor);
    var share = before / Number(option.dataset.factor);
    unit.dataset.factor = option.dataset.factor;
    var slider = control.querySelector('[type=range]');
    var field = control.querySelector('[type=number]');
    var value = tidy(field.valueAsNumber * share);
    var ends = [tidy(slider.min * share), tidy(slider.max * share)];
    var step = tidy(slider.step * share);
    slider.min = ends[0];
    slider.max = ends[1];
    slider.step = step;
    slider.value = value;
    field.value = value;
    if (moved[control.dataset.control]) {
      moved[control.dataset.control] = { value: value, unit: unit.value };
    }
  }

  document.addEventListener('focusin', function (event) {
    var unit = event.target;
    if (!unit.classList.contains('unit')) return;
    unit.dataset.factor = unit.selectedOptions[0].dataset.factor;
  });

  document.addEventListener('input', function (event) {
    var control = event.target.closest('.control');
    if (control && (event.target.type === 'range' || event.target.type === 'number')) {
      move(control, event.target);
    }
  });

  document.addEventListener('change', function (event) {
    var control = event.target.closest('.control');
    if (!control) return;
    if (event.target.classList.contains('unit')) convert(control, event.target);
    else if (event.target.matches('.choice, .truth')) move(control, event.target);
  });

  // ---- plans ------------------------------------------------------------------------------------

  function refuse(file, why) {
    show('plan_file_error', '"' + file.name + '" ' + why + ' The gear on screen stays.');
  }

  // Sends what is in a file; its answer comes as any plan's.
  function open(file) {
    clearErrors();
    if (file.size > largestPlan) {
      refuse(file, 'has ' + (file.size / largestPlan * 2).toFixed(1) +
        ' MB; a plan has at most 2 MB.');
      return;
    }
    file.arrayBuffer().then(function (bytes) {
      var text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
      if (text.indexOf('\0') >= 0) throw new TypeError('NUL');
      Shiny.setInputValue('plan_file', { name: file.name, text: text }, { priority: 'event' });
    }).catch(function () { refuse(file, 'is not UTF-8 text.'); });
  }

  document.addEventListener('change', function (event) {
    var input = event.target;
    if (!input.classList.contains('plan-file') || !input.files.length) return;
    open(input.files[0]);
    // the same file chosen again is read again
    input.value = '';
  });

  document.addEventListener('dragover', function (event) {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  ['dragleave', 'drop'].forEach(function (name) {
    document.addEventListener(name, function () { document.body.classList.remove('dropping'); });
  });
  document.addEventListener('drop', function (event) {
    event.preventDefault();
    var files = event.dataTransfer && event.dataTransfer.files;
    if (files && files.length) open(files[0]);
  });

  // Marks the line of the plan's text that a path names, as well as it can be found.
  function showLine(path) {
    var area = find('plan_text'), from = 0;
    if (!path) return;
    path.replace(/\[\d+\]/g, '').split('.').forEach(function (step) {
      var at = area.value.slice(from).search(new RegExp('(^|[\\s{,])' +
        step.replace(/[^A-Za-z0-9_]/g, '.') + ':', 'm'));
      if (at >= 0) from += at + 1;
    });
    var to = area.value.indexOf('\n', from);
    area.focus();
    area.setSelectionRange(from, to < 0 ? area.value.length : to);
    var share = from / Math.max(area.value.length, 1);
    area.scrollTop = area.scrollHeight * share - area.clientHeight / 2;
  }

  document.addEventListener('click', function (event) {
    if (event.target.id === 'plan_text_settle') {
      clearErrors();
      Shiny.setInputValue('plan_text', find('plan_text').value, { priority: 'event' });
    }
    if (event.target.id === 'mark') {
      clearErrors();
      Shiny.setInputValue('mark', find('mark_path').value, { priority: 'event' });
    }
  });

  // ---- answers ----------------------------------------------------------------------------------

  var speaking = null;
  // Only what stands still is said aloud.
  function say(words) {
    window.clearTimeout(speaking);
    speaking = window.setTimeout(function () { find('said').textContent = words; }, 700);
  }

  function listen() {
    window.codendTank.listen();
    Shiny.addCustomMessageHandler('flume_picture', function (message) {
      clearErrors();
      window.codendTank.picture(message);
      find('gear_name').textContent = message.name;
      find('gear_conditions').textContent = message.conditions;
      show('noted', message.notes.join(' '));
      say(message.said);
      answered(message.answers);
    });
    Shiny.addCustomMessageHandler('flume_refused', function (message) {
      clearErrors();
      var control = message.control &&
        document.querySelector('[data-control="' + message.control + '"]');
      if (control) refuseField(control, message.message);
      if (message.where === 'plan_file') {
        show('plan_file_error', message.message + ' The gear on screen stays.');
      } else if (message.where === 'plan_text') {
        show('plan_text_error', message.message);
        showLine(message.path);
      } else if (message.where === 'mark') {
        show('mark_error', message.message);
      } else {
        show('refused', (control ? control.querySelector('label').textContent + ': see below. ' :
          message.message + ' ') + 'The last shape that settled stays on screen.');
      }
      answered(message.answers);
    });
    Shiny.addCustomMessageHandler('flume_plan', function (message) {
      find('plan_text').value = message.text;
      show('plan_text_error', '');
    });
  }

  // Controls that are laid out anew show what R has.
  $(document).on('shiny:value', function (event) {
    if (event.name === 'controls') { moved = {}; more = false; }
  });
  $(document).on('shiny:connected', listen);
  $(document).on('shiny:disconnected', function () {
    show('refused', 'The R process that settles the gear has ended or cannot be reached.');
  });
}());
