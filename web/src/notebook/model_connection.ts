/** The connection of a view in a notebook: through its widget's model, to the kernel and without a server. */

import { PROTOCOL } from "../core/commands";
import { Connection } from "../core/connection";
import type { Command, Message } from "../core/protocol";
import { type WidgetModel, bytesOf } from "./model";

const RUN = "a";

export class ModelConnection extends Connection {
  constructor(private readonly model: WidgetModel) {
    super();
  }

  connect(): void {
    this.model.on("msg:custom", this.onCustom);
    this.model.on("change:description", this.describe);
    for (const name of ["ground_frame", "frame"] as const) this.model.on(`change:${name}`, this.onBytes[name]);
    this.state.send("open");
    this.message.send({ type: "hello", protocol: PROTOCOL, runs: [RUN] });
    this.describe();
    this.onBytes.ground_frame();
    this.onBytes.frame();
    this.model.send({ command: "attach" });
  }

  /** Let the model go; the kernel computes on. */
  close(): void {
    this.model.off("msg:custom", this.onCustom);
    this.model.off("change:description", this.describe);
    for (const name of ["ground_frame", "frame"] as const) this.model.off(`change:${name}`, this.onBytes[name]);
    this.abandon("The view was closed.");
  }

  send(command: Command): boolean {
    this.model.send(command);
    return true;
  }

  /** What the widget holds; the page of the studio fetches more, which a view does not need. */
  async fetch<T>(path: string): Promise<T> {
    return (path === "colours" ? this.model.get("colours") : {}) as T;
  }

  async upload<T>(path: string): Promise<T> {
    throw new Error(`a view in a notebook sends no file to ${path}`);
  }

  async file(path: string): Promise<Blob> {
    throw new Error(`a view in a notebook has no file ${path}`);
  }

  picture(): string {
    return "";
  }

  private readonly onCustom = (message: Message): void => this.onMessage(message);

  private readonly describe = (): void => {
    const description = this.model.get("description") as Message;
    if (Object.keys(description).length) this.message.send({ ...description, type: "scenario", run: RUN });
  };

  private readonly onBytes = {
    ground_frame: () => this.onFrame("ground_frame"),
    frame: () => this.onFrame("frame"),
  };

  private onFrame(name: string): void {
    const data = bytesOf(this.model.get(name));
    if (data) this.frame.send(data);
  }
}
