// HTML elements and displayed strings of all pages.

export type Values = Record<string, unknown>;

// Replaces {n} in a string by values.n.
export function fill(words: string, values?: Values): string {
  return words.replace(/\{(\w+)\}/g, (place, name: string) =>
    values && values[name] !== undefined ? String(values[name]) : place);
}

let translate = fill;
// Returns the displayed string for English words.
export function say(words: string, values?: Values): string { return translate(words, values); }
// Makes say() return translations.
export function translate_by(translator: typeof fill): void { translate = translator; }

// Returns a new HTML element. Undefined attributes are omitted.
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name, class_name?: string, words?: string,
  attributes: Record<string, string | number | undefined> = {}
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  if (class_name) made.className = class_name;
  if (words !== undefined) made.textContent = words;
  Object.entries(attributes).forEach(([key, value]) => {
    if (value !== undefined) made.setAttribute(key, String(value));
  });
  return made;
}

// Returns the element with an id, which the page contains.
export function find<Kind extends HTMLElement = HTMLElement>(id: string): Kind {
  return document.getElementById(id) as Kind;
}

// Returns a file name without spaces and special characters.
export function file_name(words: string): string {
  return words.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '');
}

// Saves an address or a Blob as a file.
export function save_as(content: string | Blob, name: string): void {
  const address = typeof content === 'string' ? content : URL.createObjectURL(content);
  element('a', '', undefined, { href: address, download: name }).click();
  if (content instanceof Blob) window.setTimeout(() => URL.revokeObjectURL(address), 60000);
}
