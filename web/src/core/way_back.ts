/** The run that is set aside because another one took its place: the way back to it, and what would be lost. */

import type { App } from "./app";
import { readable } from "./labels";
import { titleOf } from "./run";
import type { Entry } from "./notices";
import type { Command, Message } from "./protocol";

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
    this.offer(answer);
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
    return this.allowed(`The right one of the two runs, “${titleOf(right.description)}” at step ${right.status.live}, ends. What of it is not saved is lost. The left one is set aside with its moments.`);
  }

  /** Offer the way back to the run that an answer says is set aside; it leads there and back again. */
  private offer({ aside, ended }: Message): void {
    this.forget();
    if (typeof aside !== "string") return;
    this.title = this.spoken(aside);
    const lost = typeof ended === "string" ? ` “${this.spoken(ended)}”, which was set aside before, has ended.` : "";
    this.say(`Your run “${this.title}” is set aside with its moments.${lost}`);
  }

  private say(text: string): void {
    const way = { name: "go back to it", act: () => void this.lead() };
    this.entry = this.app.notices.note("info", text, "", true, way);
  }

  /** A title of the server as the page says it. */
  private spoken(title: string): string {
    return title ? readable(title, this.app.current?.description?.models) : "without a title";
  }

  private async lead(): Promise<void> {
    const { title } = this;
    if (!(await this.mayEndRight())) return this.say(`Your run “${title}” is set aside with its moments.`);
    const answer = await this.app.ask({ command: "alone", back: true });
    if (!answer) return;
    this.app.restarts.length = 0;
    this.title = null; // it is the one that is shown now
    this.app.note("info", `Back at the run “${title}”, paused.`);
    this.offer(answer);
  }
}
