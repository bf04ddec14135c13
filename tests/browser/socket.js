// A page of codend's flume tank without a browser: it uses Shiny's protocol. Node.js 20 needs
// --experimental-websocket.
'use strict';

// Returns the content of a message by type. A binary message has its type before its bytes; only
// the header is read (R/flume-picture.R).
function messages(data) {
  if (typeof data === 'string') return data[0] === '{' ? JSON.parse(data).custom || {} : {};
  const size = new DataView(data).getUint8(0);
  const text = (from, length) => new TextDecoder().decode(new Uint8Array(data, from, length));
  const header = new DataView(data).getUint32(1 + size, true);
  return { [text(1, size)]: JSON.parse(text(5 + size, header)) };
}

// A page without a browser. wait(type, test) resolves to the next message of a type, or null after
// a minute. shown: the visible outputs.
function page(url, shown = ['measures', 'tensions', 'drag', 'designs', 'code']) {
  const socket = new WebSocket(url.replace('http', 'ws') + '/websocket/');
  socket.binaryType = 'arraybuffer';
  const waiting = new Set();
  const where = new URL(url);
  socket.onmessage = (event) => {
    for (const [type, message] of Object.entries(messages(event.data))) {
      for (const one of [...waiting]) {
        if (one.types.includes(type) && one.test(message)) {
          waiting.delete(one);
          one.resolve({ type, ...message });
        }
      }
    }
  };
  const send = (method, data) => socket.send(JSON.stringify({ method, data }));
  return {
    wait: (types, test = () => true, seconds = 60) => new Promise((resolve) => {
      const one = { types, test, resolve };
      waiting.add(one);
      setTimeout(() => { if (waiting.delete(one)) resolve(null); }, 1000 * seconds);
    }),
    set: (inputs) => send('update', inputs),
    open: () => new Promise((resolve, reject) => {
      socket.onerror = (event) => reject(new Error(`no connection to ${socket.url}: ${event.message}`));
      socket.onopen = () => {
        const data = {
          '.clientdata_url_protocol': 'http:', '.clientdata_url_hostname': where.hostname,
          '.clientdata_url_port': where.port, '.clientdata_url_pathname': '/',
          '.clientdata_url_search': '', '.clientdata_pixelratio': 1
        };
        for (const name of shown) data[`.clientdata_output_${name}_hidden`] = false;
        send('init', data);
        resolve();
      };
    }),
    close: () => socket.close()
  };
}

module.exports = { page };
