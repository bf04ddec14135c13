// Handlers of events of the whole page.

// Calls act(target, event) for every event. A target has the type of an input, because handlers look
// at its id or classes before they use its value.
export function on<Name extends keyof DocumentEventMap>(
  name: Name, act: (target: HTMLInputElement, event: DocumentEventMap[Name]) => void
): void {
  document.addEventListener(name, (event) => {
    act((event.target instanceof Element ? event.target : document.body) as HTMLInputElement, event);
  });
}
