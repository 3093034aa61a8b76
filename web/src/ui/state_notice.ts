/** The notice over the scene: how the page stands with the server and its runs, and the way out where it fails. */

import { type App, PREPARING } from "../core/app";
import type { ConnectionState } from "../core/connection";
import { COMPILING } from "../core/notices";
import { titleOf } from "../core/run";
import { queryIn } from "../core/token";
import { h, short } from "./dom";

interface State {
  text: string;
  /** Whether it is the course of things, no failure. */
  calm?: boolean;
  way?: () => HTMLElement;
}

export class StateNotice {
  readonly element = h("div", { className: "notice", role: "alert", hidden: true });
  private connection: ConnectionState = "connecting";
  /** Functions that have been compiled; null where none is being. */
  private compiling: number | null = null;
  private shown = "";
  /** Whether it was read that there is no WebGL. */
  private read = false;

  constructor(private readonly app: App) {
    app.connection.state.watch((state) => {
      this.connection = state;
      this.show();
    });
    app.compiling.watch((functions) => {
      this.compiling = functions;
      this.show();
    });
    app.framed.watch(() => {
      this.compiling = null;
      this.show();
    });
    app.changed.watch(() => this.show());
  }

  private dismiss(): void {
    this.read = true;
    this.show();
  }

  private show(): void {
    const state = this.connection === "open" ? this.ofRuns() : this.ofConnection(this.connection);
    this.element.hidden = state === null;
    const text = state?.text ?? "";
    if (text === this.shown) return;
    this.shown = text;
    this.element.classList.toggle("calm", state?.calm === true);
    this.element.replaceChildren(h("span", {}, text), ...(state?.way ? [state.way()] : []));
  }

  private ofConnection(state: Exclude<ConnectionState, "open">): State {
    const again = (label: string) => () => action(label, () => this.app.connection.connect());
    const states: Record<typeof state, State> = {
      connecting: { text: "Connecting …", calm: true },
      "no token": this.app.handedOn ? { text: "The scenario of this link is offered in the studio’s window that is open already; this one can be closed.", calm: true } : { text: "The address of this page lacks the token that opens the studio. Paste the address that the terminal shows:", way: addressForm },
      "wrong token": this.app.watching ? { text: "The link by which you watch is not the present one: the studio was started again since, or the link was cut off. Paste the new link:", way: addressForm } : {
        text: "The token in the address of this page is not the present one: the studio was started again since, or the address was cut off. Paste the address that the terminal shows:",
        way: addressForm,
      },
      replaced: { text: "The studio is in use in another window; only one can show it.", way: again("use it here") },
      "too much": { text: "The page sent more messages than the server takes, and the connection was closed.", way: again("connect again") },
      full: { text: "No more windows may watch this studio at once.", way: again("try again") },
      "other version": { text: "This page was built from another version of Barchan than the one that serves it. Load it again. If this message comes back, end the studio in its terminal and start it again: the terminal then says how the page is brought up to date.", way: () => action("load the page again", () => location.reload()) },
      "no answer": { text: `The studio’s server does not answer: it has ended, or the network is down. Start the studio again if it has ended; this page tries to reach it every second.${this.fate()}`, way: again("try now") },
    };
    return states[state];
  }

  /** What becomes of the runs of a server that does not answer; nothing is promised that it has told it cannot keep. */
  private fate(): string {
    const { runs, unkept, watching } = this.app;
    if (watching || unkept || !runs.some((run) => run.ready)) return "";
    return " If it ended unexpectedly, the runs are on disk as they were a short while before, with one that was set aside, and the studio offers them when it starts again; after Ctrl-C only what was saved is left.";
  }

  private ofRuns(): State | null {
    const { runs, current } = this.app;
    if (runs.some((run) => run.lost)) {
      const text = "The simulation’s process ended by itself.";
      return this.app.watching ? { text: `${text} The window that commands can go on with it.` } : { text, way: () => this.revival() };
    }
    if (this.app.graphicsLost) {
      return {
        text: "The browser has taken the graphics card away from this page: its driver was started again, or too many pages use it. The run goes on, and the picture comes back by itself; if it does not, load the page again.",
        way: () => action("load the page again", () => location.reload()),
      };
    }
    const coming = runs.find((run) => run.coming && performance.now() - run.coming.since >= PREPARING)?.coming;
    const title = coming ? `“${titleOf(coming.description)}” is being prepared. ` : "";
    if (this.compiling !== null) {
      const done = this.compiling > 1 ? `: ${this.compiling} functions so far` : "";
      return { text: `${title}${COMPILING}${done} …`, calm: true };
    }
    if (title) return { text: title.trim(), calm: true };
    if (!runs.some((run) => run.ready)) return { text: "Starting …", calm: true };
    const finished = current?.status?.finished;
    if (this.app.flat && !this.read) {
      return {
        text: "This browser draws no three-dimensional pictures: WebGL is off or missing. The surface is shown from above; all else works. Another browser, or hardware acceleration in this one’s settings, brings the third dimension back.",
        way: () => action("go on with the map", () => this.dismiss()),
      };
    }
    if (finished) return { text: `The run ended: ${finished}.`, calm: true };
    if (!this.atItsEnd()) return null;
    const goOn = () => action("go on", () => void this.app.send({ command: "run" }));
    return { text: "Here the scenario ends.", calm: true, ...(this.app.watching ? {} : { way: goOn }) };
  }

  /** Both ways out of a loss: from the state that the server kept, and from the beginning. */
  private revival(): HTMLElement {
    const { kept } = this.app;
    return h(
      "span",
      {},
      kept !== null && action(`go on from step ${short(kept, 9)}`, () => void this.app.send({ command: "revive", kept })),
      action("restart the run", () => void this.app.send({ command: "revive" })),
    );
  }

  /** Whether the run stands where it has stopped by itself. */
  private atItsEnd(): boolean {
    const { current, running, runs } = this.app;
    const end = Math.min(...runs.map(({ status }) => status?.end ?? Infinity)); // two runs stop together, where the first one does
    return !running && !current?.status?.looking && current?.status?.step === end;
  }
}

function action(label: string, act: () => void): HTMLElement {
  return h("button", { type: "button", onclick: act }, label);
}

/** A field for the address that the terminal shows, or only its token. */
function addressForm(): HTMLElement {
  const input = h("input", { type: "text", required: true, "aria-label": "Address or token", autocomplete: "off", spellcheck: false });
  const open = (event: Event) => {
    event.preventDefault();
    location.search = queryIn(input.value);
  };
  return h("form", { onsubmit: open }, input, h("button", { type: "submit" }, "open"));
}
