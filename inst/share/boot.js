// Unpacks a shared page and starts it: first the picture, then the engine.
(function () {
  'use strict';
  var packed = JSON.parse(document.getElementById('packed').textContent);
  // Each pair of letters (base 91) encodes 13 bits, lowest first.
  function letter(code) { return code - 33 - (code > 34) - (code > 60) - (code > 92); }
  function bytes(name) {
    var count = packed[name][0], text = packed[name][1], out = new Uint8Array(count);
    for (var at = 0, k = 0, held = 0, bits = 0; at < count; k += 2) {
      held |= (letter(text.charCodeAt(k)) + 91 * letter(text.charCodeAt(k + 1))) << bits;
      for (bits += 13; bits > 7 && at < count; bits -= 8, held >>= 8) out[at++] = held & 255;
    }
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
      (error.message || error) + '. The page needs Chrome 91, Firefox 113, Safari 16.4 or newer.';
    window.codendFailed = String(error);
  }
  if (!window.DecompressionStream || !window.WebAssembly || !window.Worker) {
    failed(new Error('it is too old'));
    return;
  }
  Promise.all([text('three'), text('viewer'), text('page')]).then(function (codes) {
    codes.forEach(run);
    return Promise.all([text('scene'), bytes('shapes'), text('model')]);
  }).then(function (told) {
    window.codendPage(JSON.parse(told[0]), new Uint8Array(told[1]), JSON.parse(told[2]), {
      bytes: bytes, text: text, failed: failed
    });
  }).catch(failed);
})();
