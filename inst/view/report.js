// Copies the plan of a report to the clipboard.
window.addEventListener('load', function () {
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
