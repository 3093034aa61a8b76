/** The line to the server: orders out, answers and frames in; it comes back by itself. */

import { type JsonObject, PROTOCOL, type Told } from "./protocol";
import { Signal } from "./signal";

const REPLACED = 4001;
const NOT_ALLOWED = 4403;
const AGAIN = 1000;

export class Refused extends Error {
  constructor(
    message: string,
    readonly problems: { key: string; message: string; place: string }[],
  ) {
    super(message);
  }
}

type Waiting = { done: (told: Told) => void; refused: (reason: Refused) => void };

export class Line {
  readonly told = new Signal<Told>();
  readonly framed = new Signal<ArrayBuffer>();
  /** Empty while the line stands; otherwise why it does not. */
  readonly state = new Signal<string>();
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private asked = 0;

  constructor(private readonly token: string) {}

  connect(): void {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/line?token=${encodeURIComponent(this.token)}`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.state.send("");
    socket.onmessage = (event) => this.hear(event.data);
    socket.onclose = (event) => this.closed(event.code);
    this.socket = socket;
  }

  send(order: JsonObject): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(order));
  }

  /** Send an order and wait for its answer. */
  ask(order: JsonObject): Promise<Told> {
    const re = ++this.asked;
    return new Promise((done, refused) => {
      this.waiting.set(re, { done, refused });
      this.send({ ...order, re });
    });
  }

  /** Fetch what the server tells once. */
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

  private hear(data: string | ArrayBuffer): void {
    if (typeof data !== "string") return this.framed.send(data);
    const told = JSON.parse(data) as Told;
    if (told.tell === "hello" && told.protocol !== PROTOCOL) {
      this.state.send("This page is of another version than the server. Reload it.");
    }
    const waiting = typeof told.re === "number" ? this.waiting.get(told.re) : undefined;
    if (waiting && typeof told.re === "number") {
      this.waiting.delete(told.re);
      if (told.tell === "refused") {
        waiting.refused(new Refused(String(told.text), told.problems as never));
      } else waiting.done(told);
      return;
    }
    this.told.send(told);
  }

  private closed(code: number): void {
    this.socket = null;
    for (const { refused } of this.waiting.values()) refused(new Refused("the line was cut", []));
    this.waiting.clear();
    if (code === REPLACED) return this.state.send("The studio was opened in another window.");
    if (code === NOT_ALLOWED) {
      return this.state.send("The address lacks the token. Open the one that the terminal shows.");
    }
    this.state.send("The studio's server does not answer.");
    setTimeout(() => this.connect(), AGAIN);
  }
}
