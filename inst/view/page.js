// Lays the legends over the scene. Where data.move is given (from the middle of the whole gear to
// that of the net, m) two buttons look at the net or at the whole gear, each with its own axes.
function (el, x, data) {
  el.style.position = 'relative';
  el.insertAdjacentHTML('beforeend', data.html);
  if (!data.move) return;

  var scene = el.rglinstance;
  var root = scene.scene.rootSubscene;
  var view = scene.getObj(root).par3d;
  var net = { turn: new CanvasMatrix4(view.userMatrix), zoom: view.zoom, axes: data.net_axes };
  var gear = { turn: new CanvasMatrix4(), zoom: data.zoom, axes: data.whole_axes };
  gear.turn.translate(
    data.move[0] * view.scale[0], data.move[1] * view.scale[1], data.move[2] * view.scale[2]
  );
  gear.turn.multRight(net.turn);

  function look(at, away) {
    away.axes.forEach(function (id) { scene.delFromSubscene(id, root); });
    at.axes.forEach(function (id) { scene.addToSubscene(id, root); });
    view.userMatrix.load(at.turn);
    view.zoom = at.zoom;
    scene.drawScene();
  }

  var bar = document.createElement('div');
  bar.className = 'view-buttons';
  bar.style.cssText = 'position: absolute; right: 14px; top: 12px; ' +
    'font: 13px system-ui, sans-serif';
  [['Net', net, gear], ['Whole gear', gear, net]].forEach(function (choice) {
    var button = document.createElement('button');
    button.textContent = choice[0];
    button.style.cssText = 'margin-left: 6px; padding: 4px 10px; border: 1px solid #8a949c; ' +
      'border-radius: 4px; background: #ffffff; color: #202428; cursor: pointer';
    button.onclick = function () { look(choice[1], choice[2]); };
    bar.appendChild(button);
  });
  el.appendChild(bar);
  look(net, gear);
}
