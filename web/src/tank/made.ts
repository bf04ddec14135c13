import { render, type ComponentChild } from 'preact';

// Returns the element of JSX, for parts of the page that are changed without Preact.
export function made<Kind extends HTMLElement>(content: ComponentChild): Kind {
  const box = document.createElement('div');
  render(content, box);
  return box.firstElementChild as Kind;
}
