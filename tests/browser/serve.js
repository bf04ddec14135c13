// Starts codend's flume tank. CODEND: the command [exec/codend of the checkout].
'use strict';
const { spawn } = require('node:child_process');
const path = require('node:path');

const command = process.env.CODEND || path.join(__dirname, '..', '..', 'exec', 'codend');

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
        resolve(tank);
      }
    };
    child.stdout.on('data', listen);
    child.stderr.on('data', listen);
    child.on('exit', (code) => reject(new Error(`codend flume ended (${code}): ${tank.log}`)));
  });
}

module.exports = { serve };
