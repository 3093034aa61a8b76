/** The connection to the studio's server, which reconnects by itself. */

import { PROTOCOL } from "./commands";
import { Connection, type ConnectionState, type Progress } from "./connection";
import type { Command, Message } from "./protocol";
import { type Access, watchQuery } from "./token";

const REPLACED = 4001;
const NOT_ALLOWED = 4403;
const TOO_MUCH = 4429;
const FULL = 4503;
const FORBIDDEN = 403;
const BAD = 400;
const STRANGER = "The address of this page does not hold the present token.";
/** Milliseconds between two attempts to reach a server that does not answer. */
const AGAIN = 1000;

export class SocketConnection extends Connection {
  private socket: WebSocket | null = null;
  private again: ReturnType<typeof setTimeout> | undefined;

  private readonly token: string;

  constructor(private readonly access: Access) {
    super();
    this.token = access.token;
  }

  /** Whether the address holds a token at all. */
  override get allowed(): boolean {
    return this.token !== "";
  }

  connect(): void {
    if (!this.allowed) return this.state.send("no token");
    clearTimeout(this.again);
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/connection?token=${encodeURIComponent(this.token)}`);
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event) => this.onData(event.data);
    socket.onclose = (event) => this.onClose(event.code);
    this.socket = socket;
  }

  send(command: Command): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(command));
    return true;
  }

  async fetch<T>(path: string, init?: RequestInit): Promise<T> {
    const answer = await fetch(`api/${path}`, {
      ...init,
      headers: { "x-barchan-token": this.token },
    });
    if (answer.status === FORBIDDEN) throw new Error(STRANGER);
    const content = await answer.json().catch(() => ({}));
    if (!answer.ok) throw new Error(content.text ?? answer.statusText);
    return content as T;
  }

  upload<T>(path: string, file: Blob, progress?: Progress, signal?: AbortSignal): Promise<T> {
    const request = new XMLHttpRequest(); // fetch does not say how much is sent
    request.open("POST", `api/${path}`);
    request.setRequestHeader("x-barchan-token", this.token);
    request.responseType = "json";
    return new Promise((done, refused) => {
      signal?.throwIfAborted();
      signal?.addEventListener("abort", () => request.abort());
      request.upload.onprogress = ({ loaded, total }) => progress?.(loaded, total);
      request.onabort = () => refused(new DOMException("broken off", "AbortError"));
      request.onerror = () => refused(new Error("The studio’s server does not answer."));
      request.onload = () => {
        if (request.status === FORBIDDEN) refused(new Error(STRANGER));
        else if (request.status >= BAD) refused(new Error(request.response?.text ?? request.statusText));
        else done(request.response as T);
      };
      request.send(file);
    });
  }

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
    if (message.watching && !this.access.watching) location.replace(watchQuery(this.token)); // it was the token of those who watch
    this.onMessage(message);
  }

  private onClose(code: number): void {
    this.socket = null;
    this.abandon("The connection to the studio's server was lost before it answered.");
    const final = { [REPLACED]: "replaced", [NOT_ALLOWED]: "wrong token", [TOO_MUCH]: "too much", [FULL]: "full" } as const;
    const reason: ConnectionState | undefined = final[code as keyof typeof final];
    this.state.send(reason ?? "no answer");
    if (!reason) this.again = setTimeout(() => this.connect(), AGAIN);
  }
}
