// The worker of a shared page settles the gear at the latest values of the sliders, in steps if
// they are far away. A new move replaces an older one after the current step.
//
// It receives {kind: 'start', page, bytes, wasm}, then {kind: 'move', number, values}. It sends
// {kind: 'shape', number, done, shape}, {kind: 'stuck', number, shape} or {kind: 'failed', words}.
// `number` identifies the move.
function codendWorker(tell) {
  'use strict';
  var model = null, wanted = null, busy = false, number = 0, next = null;
  function buffers(moved) {
    return Object.keys(moved).map(function (name) { return moved[name].buffer; });
  }
  function show(kind, done) {
    var shape = model.shape();
    tell({ kind: kind, number: number, done: done, shape: shape }, buffers(shape.moved));
  }
  function work() {
    if (wanted) {
      next = model.walk(wanted.values);
      number = wanted.number;
      wanted = null;
    }
    if (!next) { busy = false; return; }
    try {
      var way = next();
      if (way !== 'more') next = null;
      show(way === 'stuck' ? 'stuck' : 'shape', way === 'done');
    } catch (error) {
      next = null;
      tell({ kind: 'failed', number: number, words: String(error.message || error) });
    }
    // The timeout lets messages of new moves arrive.
    setTimeout(work, 0);
  }
  return function (said) {
    if (said.kind === 'start') {
      codendEngine({ wasmBinary: said.wasm, print: function () {}, printErr: function () {} })
        .then(function (engine) {
          model = codendModel(engine, said.page, said.bytes);
          show('shape', true);
        })
        .catch(function (error) { tell({ kind: 'failed', number: 0, words: String(error.message || error) }); });
      return;
    }
    wanted = said;
    if (!busy && model) { busy = true; setTimeout(work, 0); }
  };
}
