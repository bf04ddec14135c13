// Unpacks a shared page and starts it: first what is drawn, then the engine.
(function () {
  'use strict';
  var packed = JSON.parse(document.getElementById('packed').textContent);
  function bytes(name) {
    var raw = atob(packed[name]), out = new Uint8Array(raw.length);
    for (var i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
    delete packed[name];
    var stream = new Blob([out]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
  }
  function text(name) {
    return bytes(name).then(function (all) { return new TextDecoder().decode(all); });
  }
  function run(code) {
    var script = document.createElement('script');
    script.textContent = code;
    document.head.appendChild(script);
  }
  function failed(error) {
    document.getElementById('told').textContent = 'This browser cannot run the page: ' +
      (error.message || error) + '. It takes Chrome 91, Firefox 113, Safari 16.4 or newer.';
    window.codendFailed = String(error);
  }
  if (!window.DecompressionStream || !window.WebAssembly || !window.Worker) {
    failed(new Error('it is too old'));
    return;
  }
  Promise.all([text('three'), text('viewer'), text('page')]).then(function (codes) {
    codes.forEach(run);
    return Promise.all([text('scene'), text('model')]);
  }).then(function (told) {
    window.codendPage(JSON.parse(told[0]), JSON.parse(told[1]), {
      bytes: bytes, text: text, has: function (name) { return name in packed; }, failed: failed
    });
  }).catch(failed);
})();
