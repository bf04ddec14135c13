// A report's few moving parts: a still of the scene for paper, the wheel only for a scene that was
// clicked, and the button that copies the plan.
window.addEventListener('load', function () {
  var element = document.getElementById('gear');
  var frame = element && element.parentNode;

  // WebGL keeps no picture after it has drawn: draw and take it at once.
  function take() {
    var scene = element && element.rglinstance;
    if (!scene || !scene.canvas) return;
    var still = frame.querySelector('.still');
    if (!still) {
      still = document.createElement('img');
      still.className = 'still';
      still.alt = '';
      element.insertBefore(still, element.firstChild);
    }
    scene.drawScene();
    still.src = scene.canvas.toDataURL('image/png');
  }
  setTimeout(take, 300);
  window.addEventListener('beforeprint', take);

  if (frame) {
    var chosen = false;
    document.addEventListener('pointerdown', function (event) {
      chosen = frame.contains(event.target);
    });
    frame.addEventListener('wheel', function (event) {
      if (!chosen) event.stopImmediatePropagation();
    }, true);
  }

  document.querySelectorAll('[data-copies]').forEach(function (button) {
    var said = button.nextElementSibling;
    var source = document.getElementById(button.dataset.copies);
    function byHand() {
      var range = document.createRange();
      range.selectNodeContents(source);
      var selection = window.getSelection();
      selection.removeAllRanges();
      selection.addRange(range);
      said.textContent = document.execCommand('copy') ? 'Copied.' : 'Selected: copy it by keyboard.';
    }
    button.addEventListener('click', function () {
      // Browsers may refuse the clipboard to a page opened from a file.
      if (!navigator.clipboard) return byHand();
      navigator.clipboard.writeText(source.textContent).then(function () {
        said.textContent = 'Copied.';
      }, byHand);
    });
  });
});
