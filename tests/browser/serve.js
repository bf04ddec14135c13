// Starts codend's flume tank. CODEND: the command [exec/codend of the checkout].
'use strict';
const { spawn } = require('node:child_process');
const net = require('node:net');
const path = require('node:path');

const command = process.env.CODEND || path.join(__dirname, '..', '..', 'exec', 'codend');

// Calls back as soon as a server answers. Shiny prints its address before it listens.
function answering(url, then) {
  const { hostname, port } = new URL(url);
  const socket = net.connect(port, hostname, () => { socket.destroy(); then(); });
  socket.on('error', () => setTimeout(answering, 20, url, then));
}

// Resolves to { url, log (output of the process so far), pid, stop } when the page is served.
function serve(...arguments_) {
  const child = spawn(command, ['flume', ...arguments_], { stdio: ['ignore', 'pipe', 'pipe'] });
  const tank = { log: '', pid: child.pid, stop: () => child.kill('SIGTERM') };
  return new Promise((resolve, reject) => {
    const listen = (chunk) => {
      tank.log += chunk;
      const found = tank.log.match(/Listening on (http:\S+)\s/);
      if (found && !tank.url) {
        tank.url = found[1];
        answering(tank.url, () => resolve(tank));
      }
    };
    child.stdout.on('data', listen);
    child.stderr.on('data', listen);
    child.on('exit', (code) => reject(new Error(`codend flume ended (${code}): ${tank.log}`)));
  });
}

module.exports = { serve };
