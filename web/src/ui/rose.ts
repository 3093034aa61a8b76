/** The roses of a wind: how long it blows from each side, and how much sand it moves. */

import type { JsonObject } from "../core/protocol";
import { h, short, svg } from "./dom";

/** The roses that the server computes of a wind; directions in degrees clockwise from north. */
export interface Rose {
  /** How long the wind was looked at; null where its steps have no duration. */
  days: number | null;
  /** Limits of the classes of speed (m/s); none where speeds are not in m/s. */
  limits: number[];
  /** Shares of the time by direction and class of speed. */
  shares: number[][];
  calms: number;
  /** How much sand winds from each side move; null over snow. */
  sand: number[] | null;
  toward: number | null;
  steadiness: number | null;
  crest: number | null;
}

const R = 44;

export function roses(answer: JsonObject): HTMLElement {
  const rose = answer as unknown as Rose;
  const still = `calm ${short(100 * rose.calms, 2)} %${rose.days === null ? "" : ` of ${short(rose.days, 3)} days`}`;
  const time = wheel(rose.shares, `How often the wind blows from each side; ${still}`);
  return h(
    "div",
    { className: "roses" },
    h("figure", {}, time as unknown as HTMLElement, h("figcaption", {}, h("b", {}, "time "), still)),
    rose.sand && ofSand(rose, rose.sand),
    rose.limits.length > 0 && h("div", { className: "speeds" }, ...legend(rose.limits), "m/s"),
  );
}

/** How much sand moves from each side, where to, and the crests to expect of it. */
function ofSand(rose: Rose, moved: number[]): HTMLElement {
  const sand = wheel(moved.map((amount) => [amount]), "Sand that winds from each side move", "sand");
  if (rose.crest !== null) sand.append(svg("line", { y1: -R, y2: R, transform: `rotate(${rose.crest})`, class: "crest" }));
  if (rose.toward !== null) sand.append(arrow(rose.toward, rose.steadiness ?? 0));
  const crest = rose.crest === null ? "" : `; crests expected along ${short(rose.crest, 3)}°`;
  return h("figure", {}, sand as unknown as HTMLElement, h("figcaption", {}, h("b", {}, "sand "), netTransport(rose, moved) + crest));
}

function netTransport(rose: Rose, moved: number[]): string {
  if (rose.toward !== null) return `net transport towards ${short(rose.toward, 3)}°, ${short(100 * (rose.steadiness ?? 0), 2)} % of all that moves`;
  return moved.some((amount) => amount > 0) ? "no net transport: the winds cancel" : "nothing moves";
}

function legend(limits: number[]): HTMLElement[] {
  return [0, ...limits].map((low, at) => {
    const high = limits[at];
    const text = high === undefined ? `over ${short(low, 2)}` : `${short(low, 2)}–${short(high, 2)}`;
    return h("span", {}, h("i", { className: `speed-${at}` }), text);
  });
}

/** Petals that point where winds come from, their parts one beyond the other. */
function wheel(parts: number[][], label: string, name = "speed"): SVGElement {
  const most = Math.max(...parts.map((petal) => petal.reduce((sum, part) => sum + part, 0)), 1e-9);
  const half = (0.42 * 2 * Math.PI) / parts.length;
  const petals = parts.flatMap((petal, number) => {
    let from = 0;
    return petal.map((part, at) => {
      const [inner, outer] = [(from / most) * R, ((from + part) / most) * R];
      from += part;
      const turn = `rotate(${(360 * number) / parts.length})`;
      return svg("path", { d: ring(inner, outer, half), transform: turn, class: `${name}-${at}` });
    });
  });
  const names = ["N", "E", "S", "W"].map((text, i) =>
    svg("text", { x: Math.sin((i * Math.PI) / 2) * (R + 8), y: -Math.cos((i * Math.PI) / 2) * (R + 8) + 3 }, text),
  );
  const circles = [R / 2, R].map((r) => svg("circle", { r, class: "face" }));
  return svg("svg", { viewBox: "-60 -60 120 120", class: "rose", role: "img", "aria-label": label }, ...circles, ...petals, ...names);
}

/** A piece of a ring about north, its half angle given. */
function ring(inner: number, outer: number, half: number): string {
  const at = (r: number, angle: number) => `${(r * Math.sin(angle)).toFixed(2)} ${(-r * Math.cos(angle)).toFixed(2)}`;
  const [i, o] = [inner.toFixed(2), outer.toFixed(2)];
  return `M${at(inner, -half)} L${at(outer, -half)} A${o} ${o} 0 0 1 ${at(outer, half)} L${at(inner, half)} A${i} ${i} 0 0 0 ${at(inner, -half)} Z`;
}

/** The resultant, as long as it is of all that moves. */
function arrow(toward: number, share: number): SVGElement {
  const tip = -R * share;
  return svg(
    "g",
    { transform: `rotate(${toward})`, class: "resultant" },
    svg("line", { y1: 0, y2: tip }),
    svg("path", { d: `M0 ${tip - 4} L-4 ${tip + 4} L4 ${tip + 4} Z` }),
  );
}
