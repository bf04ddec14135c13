// The connection to R by a WebSocket, or to the server of a shared page. Each text message is a JSON object with one
// item: its type and its content.

import type { Asked, FileHeader, FromR, MovedHeader, PredictionHeader, Told } from '../protocol';

type Heard = { [Name in keyof FromR]?: (message: FromR[Name]) => void };

type HeardBytes = (
  header: MovedHeader | PredictionHeader | FileHeader, arrays: Record<string, Float32Array>, rest: ArrayBuffer
) => void;

let to_server: (name: string, what: unknown) => void = () => {};
const heard: Heard = {};
let hear_arrays: HeardBytes = () => {};
function take<Name extends keyof FromR>(name: Name, message: FromR[Name]) { heard[name]?.(message); }

// For tests: called with the type of each sent message.
export const sending: { watch?(name: string): void } = {};

export function send<Name extends keyof Told>(name: Name, what: Told[Name]): void;
export function send<Name extends keyof Asked>(name: Name, what: { number: number; asked: Asked[Name] }): void;
export function send(name: string, what: unknown): void {
  sending.watch?.(name);
  to_server(name, what);
}

export function hear(handlers: Heard): void { Object.assign(heard, handlers); }
// Calls act() with the header of each binary message, its arrays and the bytes that follow.
export function hear_bytes(act: HeardBytes): void { hear_arrays = act; }

// Connects to the server of the page. After a lost connection, calls lost() and connects again.
// continues: returns true if the page will open its design again.
export function connect(lost: () => void, continues: () => boolean): void {
  if (window.codendServer) {
    to_server = window.codendServer(take, (header, arrays) => hear_arrays(header, arrays, new ArrayBuffer()));
    return;
  }
  const address = new URL(window.location.href);
  address.protocol = address.protocol.replace('http', 'ws');
  address.hash = '';
  if (continues()) address.searchParams.set('continues', '1');
  const socket = new WebSocket(address);
  to_server = (name, what) => {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ [name]: what }));
  };
  socket.binaryType = 'arraybuffer';
  socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
    if (typeof data !== 'string') {
      const size = new DataView(data).getUint32(0, true);
      const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, size)));
      let at = 4 + size;
      const arrays = Object.fromEntries(Object.entries<number>(header.counts ?? {}).map(([name, count]) => {
        at += 4 * count;
        return [name, new Float32Array(data, at - 4 * count, count)];
      }));
      hear_arrays(header, arrays, data.slice(at));
      return;
    }
    const [name, message] = Object.entries(JSON.parse(data) as object)[0];
    take(name as keyof FromR, message as never);
  };
  socket.onclose = ({ code }) => {
    // The server refused the page, with a message.
    if (code === 4000) return;
    lost();
    window.setTimeout(() => connect(lost, continues), 2000);
  };
}
