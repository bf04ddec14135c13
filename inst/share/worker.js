// The worker of a shared page: settles the gear at the sliders' values, the last that it was told,
// in parts where they are far; what is overtaken is dropped after the part at hand.
//
// It is told {kind: 'start', page, bytes, wasm}, then {kind: 'move', number, values}, and tells
// {kind: 'shape', number, done, shape}, {kind: 'stuck', number, shape} or {kind: 'failed', words}.
// `number` is that of the move.
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
    // so that moves that have come meanwhile are heard
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
