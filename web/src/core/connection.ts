/** The connection to those who compute: commands out, messages and frames in. */

import type { Command, Message, Problem, RunName } from "./protocol";
import { Signal } from "./signal";

/** How the page stands with the server; every kind has its own words and its own way out. */
export type ConnectionState = "connecting" | "open" | "no token" | "wrong token" | "replaced" | "too much" | "full" | "other version" | "no answer";

export class Refused extends Error {
  constructor(
    text: string,
    readonly problems: Problem[],
  ) {
    super(text);
  }
}

/** What is counted, where that has a name, or why nothing comes of it for the moment. */
export interface ProgressWords {
  counted?: string;
  waits?: string;
}

/** Takes how much is done, and of how much; 0 of 0 where nobody knows how long it takes. */
export type Progress = (done: number, of: number, words?: ProgressWords) => void;

interface Waiting {
  done: (message: Message) => void;
  refused: (reason: Refused) => void;
  /** Takes how much is done, and of how much, of what takes long. */
  progress: Progress | undefined;
  /** The run that is to answer; where it is not named, any of them. */
  run: unknown;
}

/** Numbers of requests, none given twice on a page: several views may share one way of messages. */
let lastId = 0;

export abstract class Connection {
  readonly message = new Signal<Message>();
  readonly frame = new Signal<ArrayBuffer>();
  readonly state = new Signal<ConnectionState>();
  private readonly waiting = new Map<number, Waiting>();

  /** Open the connection, where it can be opened. */
  abstract connect(): void;

  /** Send a command; returns whether there is a connection. */
  abstract send(command: Command): boolean;

  /** Fetch something that is given once. */
  abstract fetch<T>(path: string, init?: RequestInit): Promise<T>;

  /** Send a file; `progress` takes how many of its bytes are sent, and `signal` breaks that off. */
  abstract upload<T>(path: string, file: Blob, progress?: Progress, signal?: AbortSignal): Promise<T>;

  /** A file, as it is. */
  abstract file(path: string): Promise<Blob>;

  /** The address of a preset's picture. */
  abstract picture(name: string): string;

  /** Whether whoever opened the page may connect at all. */
  get allowed(): boolean {
    return true;
  }

  /** Send a command and wait for its answer; `progress` is called while that takes long, and `signal` breaks it off. */
  ask(command: Command, progress?: Progress, signal?: AbortSignal): Promise<Message> {
    const id = ++lastId;
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

  /** Give a message to the request that it answers, or else to all who watch. */
  protected onMessage(message: Message): void {
    const waiting = typeof message.id === "number" ? this.waiting.get(message.id) : undefined;
    if (!waiting) return this.message.send(message);
    if (message.type === "progress") return waiting.progress?.(Number(message.done), Number(message.of));
    this.waiting.delete(message.id as number);
    if (message.type === "refused") waiting.refused(refusal(message));
    else waiting.done(message);
  }
}

function refusal({ text, problems }: Message): Refused {
  return new Refused(String(text), (problems ?? []) as unknown as Problem[]);
}
