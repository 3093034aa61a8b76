/** The balance of what the wind can move: what was, came, went and is, to the last unit. */

import type { App } from "../core/app";
import { nameBeside } from "../core/run";
import { h } from "../ui/dom";

export class BalanceTable {
  readonly element = h("dl", { className: "balance", "aria-label": "Balance" });

  constructor(private readonly app: App) {
    app.framed.watch((run) => run === app.current && this.show());
    app.changed.watch(() => this.show());
  }

  private show(): void {
    const { runs, current } = this.app;
    const balance = current?.status?.balance;
    if (!balance) return;
    const whose = runs.length > 1 ? ` of ${nameBeside(current!, runs.find((run) => run !== current))}` : "";
    const mass = balance.mass === null ? "" : ` of ${balance.mass} kg/m²`;
    const rows = Object.entries(balance.parts).map(([name, count]) => h("div", {}, h("dt", {}, name), h("dd", {}, whole(count))));
    this.element.replaceChildren(h("div", {}, h("dt", {}, `balance${whose}, ${balance.unit}${mass}`)), ...rows);
  }
}

/** A whole number with all its digits. */
function whole(count: number): string {
  return count.toLocaleString("en-GB").replaceAll(",", "\u202f");
}
