// Shiny's connection to R.

import type { Asked, FromR, Told } from '../protocol';

declare const Shiny: {
  setInputValue(name: string, value: unknown, options: { priority: 'event' }): void;
  addCustomMessageHandler(name: string, handler: (message: never) => void): void;
};
declare function $(element: Document | HTMLElement): {
  on(event: string, act: () => void): void; trigger(event: string): void;
};

export function send<Name extends keyof Told>(name: Name, what: Told[Name]): void;
export function send<Name extends keyof Asked>(name: Name, what: { number: number; asked: Asked[Name] }): void;
export function send(name: string, what: unknown): void {
  Shiny.setInputValue(name, what, { priority: 'event' });
}

export function hear<Name extends keyof FromR>(name: Name, act: (message: FromR[Name]) => void): void {
  // Shiny rejects handlers without an argument.
  Shiny.addCustomMessageHandler(name, (message) => act(message));
}
export function hear_bytes(name: string, act: (bytes: ArrayBuffer) => void): void {
  Shiny.addCustomMessageHandler(name, act);
}

// Calls act() on an event of Shiny or Bootstrap.
export function on_page(event: string, act: () => void): void { $(document).on(event, act); }

// Shiny computes visible outputs only, so it must know what is visible.
export function tell_visible(element: HTMLElement, visible: boolean): void {
  $(element).trigger(visible ? 'shown' : 'hidden');
}
