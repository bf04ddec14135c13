// Required values of measures. The user clicks the value of a measure, types a required value and
// chooses a field; R finds the value of the field.
//
// `codendTarget`:
//   `show(message)` sets the field to R's result, or reports the nearest value.
//   `form()` updates the list of fields.
window.codendTarget = (function () {
  'use strict';

  var say = window.codendSay, measure = null;
  function find(id) { return document.getElementById(id); }
  function tell(error, said) {
    window.codendPage.tell('target_error', error);
    find('target_said').textContent = said;
  }

  function open(button) {
    measure = button.dataset;
    find('target_label').textContent = say('target_required', { measure: measure.label });
    window.codendForm.offer(find('target_field'));
    tell('', '');
    find('target_asks').hidden = false;
    find('target_value').value = button.textContent.split('\n')[0].replace(/\s/g, '').replace('\u2212', '-');
    find('target_value').select();
    find('target_value').focus();
  }

  function ask() {
    tell('', '');
    window.codendTalk.tell('target_wanted', {
      paths: find('target_field').value.split(' '), measure: measure.measure, unit: measure.unit,
      target: find('target_value').value, number: Date.now()
    });
  }

  document.addEventListener('click', function (event) {
    var button = event.target.closest('.measure-value');
    if (button) open(button);
    if (event.target.id === 'target_start') ask();
    if (event.target.id === 'target_close') find('target_asks').hidden = true;
  });
  document.addEventListener('keydown', function (event) {
    if (event.target.id === 'target_value' && event.key === 'Enter') ask();
  });

  return {
    show: function (message) {
      tell('', message.message);
      if (!message.reached) return;
      var all = {};
      message.paths.forEach(function (path) { all[path] = { value: message.value, unit: message.unit }; });
      window.codendForm.edits(all);
    },
    form: function () { if (!find('target_asks').hidden) window.codendForm.offer(find('target_field')); }
  };
}());
