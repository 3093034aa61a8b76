/** The connection to the server: commands out, messages and frames in; it reconnects by itself. */

import { PROTOCOL } from "./commands";
import type { Command, Message, Problem } from "./protocol";
import { Signal } from "./signal";

const REPLACED = 4001;
const NOT_ALLOWED = 4403;
const AGAIN = 1000;

export class Refused extends Error {
  constructor(
    text: string,
    readonly problems: Problem[],
  ) {
    super(text);
  }
}

type Waiting = { done: (message: Message) => void; refused: (reason: Refused) => void };

export class Connection {
  readonly message = new Signal<Message>();
  readonly frame = new Signal<ArrayBuffer>();
  /** Empty while connected; otherwise the reason why not. */
  readonly state = new Signal<string>();
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;

  constructor(private readonly token: string) {}

  connect(): void {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/connection?token=${encodeURIComponent(this.token)}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.state.send("");
    socket.onmessage = (event) => this.onData(event.data);
    socket.onclose = (event) => this.onClose(event.code);
    this.socket = socket;
  }

  send(command: Command): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(command));
  }

  /** Send a command and wait for its answer. */
  ask(command: Command): Promise<Message> {
    const id = ++this.lastId;
    return new Promise((done, refused) => {
      this.waiting.set(id, { done, refused });
      this.send({ ...command, id });
    });
  }

  /** Fetch something that the server gives once. */
  async fetch<T>(path: string, init?: RequestInit): Promise<T> {
    const answer = await fetch(`api/${path}`, {
      ...init,
      headers: { "x-barchan-token": this.token },
    });
    const content = await answer.json();
    if (!answer.ok) throw new Error(content.text ?? answer.statusText);
    return content as T;
  }

  picture(name: string): string {
    return `api/pictures/${name}?token=${encodeURIComponent(this.token)}`;
  }

  private onData(data: string | ArrayBuffer): void {
    if (typeof data !== "string") return this.frame.send(data);
    const message = JSON.parse(data) as Message;
    if (message.type === "hello" && message.protocol !== PROTOCOL) {
      this.state.send("This page is of another version than the server. Reload it.");
    }
    const waiting = typeof message.id === "number" ? this.waiting.get(message.id) : undefined;
    if (waiting && typeof message.id === "number") {
      this.waiting.delete(message.id);
      if (message.type === "refused") {
        waiting.refused(new Refused(String(message.text), message.problems as never));
      } else waiting.done(message);
      return;
    }
    this.message.send(message);
  }

  private onClose(code: number): void {
    this.socket = null;
    for (const { refused } of this.waiting.values()) refused(new Refused("the connection was lost", []));
    this.waiting.clear();
    if (code === REPLACED) return this.state.send("The studio was opened in another window.");
    if (code === NOT_ALLOWED) {
      return this.state.send("The address lacks the token. Open the one that the terminal shows.");
    }
    this.state.send("The studio's server does not answer.");
    setTimeout(() => this.connect(), AGAIN);
  }
}
