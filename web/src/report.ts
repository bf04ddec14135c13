// Copies the plan of a report to the clipboard.

window.addEventListener('load', () => {
  document.querySelectorAll<HTMLElement>('[data-copies]').forEach((button) => {
    const said = button.nextElementSibling as HTMLElement;
    const source = document.getElementById(button.dataset.copies ?? '') as HTMLElement;
    function select() {
      window.getSelection()?.selectAllChildren(source);
      said.textContent = document.execCommand('copy') ? 'Copied.' : 'Selected: copy it by keyboard.';
    }
    button.addEventListener('click', () => {
      // Browsers may refuse the clipboard to a page opened from a file.
      if (!('clipboard' in navigator)) { select(); return; }
      navigator.clipboard.writeText(source.textContent ?? '').then(() => { said.textContent = 'Copied.'; }, select);
    });
  });
});
