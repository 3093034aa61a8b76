/** The run that is set aside because another one took its place: the way back to it, and what would be lost. */

import type { App } from "./app";
import { readable } from "./labels";
import { titleOf } from "./run";
import type { Entry } from "./notices";
import type { Command, Message } from "./protocol";

export class WayBack {
  /** Asks whether what a text says may happen; the page sets it. */
  allowed: (text: string) => Promise<boolean> = async () => true;
  /** Whether the run of a title, whose place another one has taken, is still on disk; the page sets it. */
  kept: (title: string) => Promise<boolean> = async () => false;
  private entry: Entry | null = null;
  /** The title of the run that is set aside, as the server has it; null where none is. */
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

  /** Two runs are compared: the run that is set aside now is the one before the comparison. */
  async compared(): Promise<void> {
    const { title } = this;
    this.forget();
    if (title !== null) this.app.note("info", await this.fate(title));
  }

  private forget(): void {
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
    this.title = aside;
    this.say(`Set aside with its moments: “${this.spoken(aside)}”`);
    if (typeof ended === "string") void this.fate(ended).then((text) => this.app.note("info", text));
  }

  /** What became of the run that was set aside before another one. */
  private async fate(title: string): Promise<string> {
    const name = `“${this.spoken(title)}”, which was set aside before,`;
    return (await this.kept(title)) ? `${name} is kept too: Presets offers it.` : `${name} has ended.`;
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
    const title = this.spoken(this.title ?? "");
    if (!(await this.mayEndRight())) return void (this.entry && this.app.notices.restore(this.entry));
    const answer = await this.app.ask({ command: "alone", back: true });
    if (!answer) return;
    this.app.restarts.length = 0;
    this.title = null; // it is the one that is shown now
    this.app.note("info", `Back at the run “${title}”, paused.`);
    this.offer(answer);
  }
}
