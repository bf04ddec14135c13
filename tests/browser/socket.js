// A page of codend's flume tank without a browser: it uses the messages of web/src/protocol.ts.
// Node.js 20 needs --experimental-websocket.
'use strict';

// Returns the content of a message by type. Only the header of a binary message is read
// (R/flume-message.R).
function messages(data) {
  if (typeof data === 'string') return JSON.parse(data);
  const size = new DataView(data).getUint32(0, true);
  return { flume_moved: JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, size))) };
}

// A page without a browser. wait(type, test) resolves to the next message of a type, or null after
// a minute.
function page(url) {
  const socket = new WebSocket(url.replace('http', 'ws') + '/');
  socket.binaryType = 'arraybuffer';
  const waiting = new Set();
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
  return {
    wait: (types, test = () => true, seconds = 60) => new Promise((resolve) => {
      const one = { types, test, resolve };
      waiting.add(one);
      setTimeout(() => { if (waiting.delete(one)) resolve(null); }, 1000 * seconds);
    }),
    // messages by type
    send: (all) => Object.entries(all).forEach(([type, content]) => socket.send(JSON.stringify({ [type]: content }))),
    open: () => new Promise((resolve, reject) => {
      socket.onerror = (event) => reject(new Error(`no connection to ${socket.url}: ${event.message}`));
      socket.onopen = resolve;
    }),
    close: () => socket.close()
  };
}

module.exports = { page };
