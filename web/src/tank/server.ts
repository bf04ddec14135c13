// The WebSocket to R. Each text message is a JSON object with one item: its type and its content.

import type { Asked, FromR, Told } from '../protocol';

type Heard = { [Name in keyof FromR]?: (message: FromR[Name]) => void };

let socket: WebSocket | null = null;
const heard: Heard = {};
let hear_header: (header: never, bytes: ArrayBuffer, at: number) => void = () => {};

// For tests: called with the type of each sent message.
export const sending: { watch?(name: string): void } = {};

export function send<Name extends keyof Told>(name: Name, what: Told[Name]): void;
export function send<Name extends keyof Asked>(name: Name, what: { number: number; asked: Asked[Name] }): void;
export function send(name: string, what: unknown): void {
  sending.watch?.(name);
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ [name]: what }));
}

export function hear(handlers: Heard): void { Object.assign(heard, handlers); }
// Calls act() with the header of each binary message and the position of its data.
export function hear_bytes<Header>(act: (header: Header, bytes: ArrayBuffer, at: number) => void): void {
  hear_header = act;
}

// Connects to the server of the page. After a lost connection, calls lost() and connects again.
// continues: returns true if the page will open its design again.
export function connect(lost: () => void, continues: () => boolean): void {
  const address = new URL(window.location.href);
  address.protocol = address.protocol.replace('http', 'ws');
  address.hash = '';
  if (continues()) address.searchParams.set('continues', '1');
  socket = new WebSocket(address);
  socket.binaryType = 'arraybuffer';
  socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
    if (typeof data !== 'string') {
      const size = new DataView(data).getUint32(0, true);
      const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, size)));
      hear_header(header as never, data, 4 + size);
      return;
    }
    const [name, message] = Object.entries(JSON.parse(data) as object)[0];
    heard[name as keyof FromR]?.(message as never);
  };
  socket.onclose = ({ code }) => {
    // The server refused the page, with a message.
    if (code === 4000) return;
    lost();
    window.setTimeout(() => connect(lost, continues), 2000);
  };
}
