// Lays the legends over the scene. Where data.move is given (from the middle of the whole gear to
// that of the net, m) two buttons look at the net or at the whole gear.
function (el, x, data) {
  el.style.position = 'relative';
  el.insertAdjacentHTML('beforeend', data.html);
  if (!data.move) return;

  var scene = el.rglinstance;
  var view = scene.getObj(scene.scene.rootSubscene).par3d;
  var net = { turn: new CanvasMatrix4(view.userMatrix), zoom: view.zoom };
  var gear = { turn: new CanvasMatrix4(), zoom: data.zoom };
  gear.turn.translate(
    data.move[0] * view.scale[0], data.move[1] * view.scale[1], data.move[2] * view.scale[2]
  );
  gear.turn.multRight(net.turn);

  var bar = document.createElement('div');
  bar.style.cssText = 'position: absolute; right: 14px; top: 12px; font: 13px system-ui, sans-serif';
  [['Net', net], ['Whole gear', gear]].forEach(function (choice) {
    var button = document.createElement('button');
    button.textContent = choice[0];
    button.style.cssText = 'margin-left: 6px; padding: 4px 10px; border: 1px solid #8a949c; ' +
      'border-radius: 4px; background: #ffffff; color: #202428; cursor: pointer';
    button.onclick = function () {
      view.userMatrix.load(choice[1].turn);
      view.zoom = choice[1].zoom;
      scene.drawScene();
    };
    bar.appendChild(button);
  });
  el.appendChild(bar);
}
