// Opens plans from a file dialog, by drag and drop, or from the text area.
//
// codendFiles.showLine(path) selects the line of the plan text that `path` refers to.
window.codendFiles = (function () {
  'use strict';

  var say = window.codendSay, largest = 2 * 1024 * 1024;
  function find(id) { return document.getElementById(id); }

  function refuse(why) {
    window.codendPage.gallery(true);
    window.codendPage.tell('plan_file_error', why + ' ' + say('gear_stays'));
  }

  // Saved designs are opened as such; other files are sent to R as plans.
  function open(file) {
    window.codendPage.tell('plan_file_error', '');
    if (file.size > largest) {
      refuse(say('file_large', { file: file.name, n: (file.size / largest * 2).toFixed(1) }));
      return;
    }
    file.arrayBuffer().then(function (bytes) {
      var text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
      if (text.indexOf('\0') >= 0) throw new TypeError('NUL');
      if (/^\s*\{\s*"codend_designs"/.test(text)) {
        window.codendDesigns.open(JSON.parse(text), 'plan_file');
        return;
      }
      window.codendTalk.ask('plan_file', { name: file.name, text: text });
    }).catch(function (error) {
      refuse(error instanceof SyntaxError ? say('file_no_designs', { file: file.name }) :
        say('file_no_text', { file: file.name }));
    });
  }

  document.addEventListener('change', function (event) {
    var input = event.target;
    if (!input.classList.contains('plan-file') || !input.files.length) return;
    open(input.files[0]);
    // Otherwise the same file could not be chosen again.
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

  document.addEventListener('click', function (event) {
    if (event.target.id !== 'plan_text_settle') return;
    window.codendPage.tell('plan_text_error', '');
    window.codendTalk.ask('plan_text', find('plan_area').value);
  });

  return {
    showLine: function (path) {
      var area = find('plan_area'), from = 0;
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
  };
}());
