/** The run that is set aside because another one took its place: the way back to it, and what would be lost. */

import type { App } from "./app";
import { readable } from "./labels";
import type { Entry } from "./notices";
import type { Command, Json, Message } from "./protocol";

export class WayBack {
  /** Asks whether what a text says may happen; the page sets it. */
  allowed: (text: string) => Promise<boolean> = async () => true;
  private entry: Entry | null = null;
  /** The title of the run that is set aside; null where none is. */
  private title: string | null = null;

  constructor(private readonly app: App) {}

  /** Let another run take the place of the one that there is, which is set aside; null where that was not wanted. Throws where it is refused. */
  async replace(command: Command): Promise<Message | null> {
    if (!(await this.mayEndRight())) return null;
    const answer = await this.app.connection.ask(command);
    this.app.restarts.length = 0;
    this.app.notices.dismissAll(); // they are of the run before
    this.offer(answer.aside);
    return answer;
  }

  /** Whether two runs may be compared although the run that is set aside now would be lost. */
  async mayEndAside(): Promise<boolean> {
    if (this.title === null || this.app.runs.length > 1) return true;
    return this.allowed(`The run “${this.title}”, which is set aside, ends where two runs are compared: the one that is shown now is set aside in its place.`);
  }

  /** Two runs are compared: the run that is set aside now is the one before the comparison. */
  forget(): void {
    if (this.entry) this.app.notices.dismiss(this.entry);
    this.entry = this.title = null;
  }

  /** Whether the right one of two runs may end: unlike the left one it is not set aside. */
  private async mayEndRight(): Promise<boolean> {
    const right = this.app.runs[1];
    if (!right?.description || !right.status?.live) return true;
    return this.allowed(`The right one of the two runs, “${right.description.model.title}” at step ${right.status.live}, ends. What of it is not saved is lost. The left one is set aside with its moments.`);
  }

  /** Offer the way back to the run that is set aside, by its title; it leads there and back again. */
  private offer(aside: Json | undefined): void {
    const before = this.title;
    this.forget();
    if (typeof aside !== "string") return;
    const title = (this.title = aside ? readable(aside, this.app.current?.description?.models) : "without a title");
    const ended = before !== null && before !== title ? ` “${before}”, which was set aside before, has ended.` : "";
    const way = { name: "go back to it", act: () => void this.lead() };
    this.entry = this.app.notices.note("info", `Your run “${title}” is set aside with its moments.${ended}`, "", true, way);
  }

  private async lead(): Promise<void> {
    const { title } = this;
    if (!(await this.mayEndRight())) return this.offer(title);
    const answer = await this.app.ask({ command: "alone", back: true });
    if (!answer) return;
    this.app.restarts.length = 0;
    this.title = null; // it is the one that is shown now
    this.app.note("info", `Back at the run “${title}”, paused.`);
    this.offer(answer.aside);
  }
}
