// Dividers between drawing, tank and fields, moved by pointer or arrow keys. This browser keeps their
// positions, in percent of the width of their parent.

import { on } from './events';

type Divider = HTMLElement & { parentElement: HTMLElement };
const least = 15, most = 85, step = 2;
const divider_of = (target: HTMLElement) => target.role === 'separator' ? target as Divider : null;

function place(divider: Divider, share: number) {
  const at = Math.min(Math.max(share, least), most);
  divider.parentElement.style.setProperty('--' + divider.id, at + '%');
  divider.ariaValueNow = String(Math.round(at));
  localStorage.setItem('codend-' + divider.id, String(at));
}
function share_of(divider: Divider, x = divider.getBoundingClientRect().left) {
  const { left, width } = divider.parentElement.getBoundingClientRect();
  return 100 * (x - left) / width;
}

// Restores the positions.
export function listen(): void {
  document.querySelectorAll<Divider>('[role=separator]').forEach((divider) => {
    const share = Number(localStorage.getItem('codend-' + divider.id));
    if (share) place(divider, share);
  });
}
on('pointerdown', (target, { pointerId }) => divider_of(target)?.setPointerCapture(pointerId));
on('pointermove', (target, { buttons, clientX }) => {
  const divider = buttons ? divider_of(target) : null;
  if (divider) place(divider, share_of(divider, clientX));
});
on('keydown', (target, { key }) => {
  const divider = divider_of(target), by = { ArrowLeft: -step, ArrowRight: step }[key];
  if (divider && by) place(divider, share_of(divider) + by);
});
