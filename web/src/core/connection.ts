/** The connection to the server: commands out, messages and frames in; it reconnects by itself. */

import { PROTOCOL } from "./commands";
import type { Command, Message, Problem, RunName } from "./protocol";
import { Signal } from "./signal";

const REPLACED = 4001;
const NOT_ALLOWED = 4403;
const TOO_MUCH = 4429;
const FORBIDDEN = 403;
/** Milliseconds between two attempts to reach a server that does not answer. */
const AGAIN = 1000;

/** How the page stands with the server; every kind has its own words and its own way out. */
export type ConnectionState = "connecting" | "open" | "no token" | "wrong token" | "replaced" | "too much" | "other version" | "no answer";

export class Refused extends Error {
  constructor(
    text: string,
    readonly problems: Problem[],
  ) {
    super(text);
  }
}

export type Progress = (done: number, of: number) => void;

interface Waiting {
  done: (message: Message) => void;
  refused: (reason: Refused) => void;
  /** Takes how much is done, and of how much, of what takes long. */
  progress: Progress | undefined;
  /** The run that is to answer; where it is not named, any of them. */
  run: unknown;
}

export class Connection {
  readonly message = new Signal<Message>();
  readonly frame = new Signal<ArrayBuffer>();
  readonly state = new Signal<ConnectionState>();
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private lastId = 0;
  private again: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly token: string) {}

  /** Whether the address holds a token at all. */
  get hasToken(): boolean {
    return this.token !== "";
  }

  connect(): void {
    if (!this.hasToken) return this.state.send("no token");
    clearTimeout(this.again);
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/connection?token=${encodeURIComponent(this.token)}`);
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event) => this.onData(event.data);
    socket.onclose = (event) => this.onClose(event.code);
    this.socket = socket;
  }

  /** Send a command; returns whether there is a connection. */
  send(command: Command): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(command));
    return true;
  }

  /** Send a command and wait for its answer; `progress` is called while that takes long, and `signal` breaks it off. */
  ask(command: Command, progress?: Progress, signal?: AbortSignal): Promise<Message> {
    const id = ++this.lastId;
    signal?.addEventListener("abort", () => this.waiting.has(id) && this.send({ command: "cancel", of: id }));
    return new Promise((done, refused) => {
      this.waiting.set(id, { done, refused, progress, run: command.run });
      if (!this.send({ ...command, id })) this.abandon("There is no connection to the studio's server.");
    });
  }

  /** Refuse what is waiting for an answer that will not come: of one run, or of all. */
  abandon(reason: string, run?: RunName): void {
    for (const [id, waiting] of this.waiting) {
      if (run !== undefined && waiting.run !== undefined && waiting.run !== run) continue;
      this.waiting.delete(id);
      waiting.refused(new Refused(reason, []));
    }
  }

  /** Fetch something that the server gives once. */
  async fetch<T>(path: string, init?: RequestInit): Promise<T> {
    const answer = await fetch(`api/${path}`, {
      ...init,
      headers: { "x-barchan-token": this.token },
    });
    if (answer.status === FORBIDDEN) throw new Error("The address of this page does not hold the present token.");
    const content = await answer.json().catch(() => ({}));
    if (!answer.ok) throw new Error(content.text ?? answer.statusText);
    return content as T;
  }

  /** A file of the server's, as it is. */
  async file(path: string): Promise<Blob> {
    const answer = await fetch(`api/${path}`, { headers: { "x-barchan-token": this.token } });
    if (!answer.ok) throw new Error((await answer.json().catch(() => ({}))).text ?? answer.statusText);
    return answer.blob();
  }

  picture(name: string): string {
    return `api/pictures/${name}?token=${encodeURIComponent(this.token)}`;
  }

  private onData(data: string | ArrayBuffer): void {
    if (typeof data !== "string") return this.frame.send(data);
    const message = JSON.parse(data) as Message;
    if (message.type === "hello") this.state.send(message.protocol === PROTOCOL ? "open" : "other version");
    const waiting = typeof message.id === "number" ? this.waiting.get(message.id) : undefined;
    if (waiting && message.type === "progress") return waiting.progress?.(Number(message.done), Number(message.of));
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
    this.abandon("The connection to the studio's server was lost before it answered.");
    const final = { [REPLACED]: "replaced", [NOT_ALLOWED]: "wrong token", [TOO_MUCH]: "too much" } as const;
    const reason: ConnectionState | undefined = final[code as keyof typeof final];
    this.state.send(reason ?? "no answer");
    if (!reason) this.again = setTimeout(() => this.connect(), AGAIN);
  }
}
