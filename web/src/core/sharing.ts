/** How those who watch come to see the surface as the window that commands shows it. */

import type { Command, JsonObject, Message } from "./protocol";
import { checked } from "./stored";
import { CHOICES, LOOK, type Look, type View } from "./view";

/** What everybody chooses for their own screen. */
const OWN = ["theme", "quality", "turning"] as const;

export class Sharing {
  /** How many windows watch this one's runs. */
  watchers = 0;

  constructor(
    private readonly view: View,
    private readonly send: (command: Command) => void,
  ) {
    view.changed.watch(() => this.share());
  }

  /** So many windows watch now; those that came last know nothing of the view yet. */
  count(message: Message): void {
    this.watchers = Number(message.count);
    this.share();
  }

  /** Show the surface as the window that commands does; its settings are checked as those are that the browser keeps. */
  follow(message: Message): void {
    const { theme, quality, turning } = this.view.look;
    this.view.follow({ ...checked(message.look as object, LOOK, CHOICES), theme, quality, turning });
  }

  private share(): void {
    if (!this.watchers) return;
    const look: Partial<Look> = { ...this.view.look };
    for (const name of OWN) delete look[name];
    this.send({ command: "share_look", look: look as JsonObject });
  }
}
