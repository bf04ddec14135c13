// Settles the gear of a page from share() in node, as the page's worker does.
'use strict';
const fs = require('fs'), zlib = require('zlib');

const bytes = (text) => zlib.unzipSync(Buffer.from(text, 'base64'));

// Returns {model, page, move(values): TRUE if the solve converged}.
exports.opened = async function (file) {
  const html = fs.readFileSync(file, 'utf8');
  const packed = JSON.parse(html.split('id="packed">')[1].split('</script>')[0]);
  const page = JSON.parse(bytes(packed.model).toString());
  const code = bytes(packed.worker).toString();
  const made = new Function('require', '__dirname',
    code + '\n;return [codendEngine, codendWorker.new_model];')(require, __dirname);
  const engine = await made[0]({ wasmBinary: bytes(packed.wasm) });
  const model = made[1](engine, page, new Uint8Array(bytes(packed.arrays)));
  return {
    model, page,
    move(values) {
      const next = model.walk(values);
      for (let way = 'more'; ;) {
        way = next();
        if (way !== 'more') return way === 'done';
      }
    }
  };
};
