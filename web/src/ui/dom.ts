/** Small helpers to build the page. */

type Child = Node | string | null | undefined | false;
type Props = Record<string, unknown>;

/** An element with properties, attributes (what has a dash or is called role), listeners (on…) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  apply(element, props);
  element.append(...(children.filter((child) => child !== null && child !== undefined && child !== false) as Node[]));
  return element;
}

/** An element of a drawing. */
export function svg(tag: string, props: Props = {}, ...children: Child[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(props)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else element.setAttribute(name, String(value));
  }
  element.append(...(children.filter(Boolean) as Node[]));
  return element;
}

function apply(element: HTMLElement, props: Props): void {
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === null) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value as EventListener);
    else if (name.includes("-") || name === "role" || name === "for") element.setAttribute(name, String(value));
    else (element as unknown as Props)[name] = value;
  }
}

let numbered = 0;

/** A new id for an element. */
export function id(prefix: string): string {
  return `${prefix}-${++numbered}`;
}

/** A button that shows a sign or a word and is called by its label, after the word where the label lacks it. */
export function button(label: string, sign: Child, action: () => void, props: Props = {}): HTMLButtonElement {
  const lacks = typeof sign === "string" && !label.toLowerCase().includes(sign.toLowerCase());
  const name = lacks ? `${sign}: ${label}` : label; // who speaks to the page says what is seen
  return h("button", { type: "button", title: label, "aria-label": name, onclick: action, ...props }, sign);
}

/** A number in few digits. */
export function short(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size >= 1e7) return value.toExponential(2);
  if (size >= 1000) return Math.round(value).toLocaleString("en-GB").replaceAll(",", "\u202f");
  return String(Number(value.toPrecision(digits)));
}

/** A count with its noun, in the plural unless it is one. */
export function counted(count: number, noun: string): string {
  return `${short(count, 9)} ${noun}${Math.abs(count) === 1 ? "" : "s"}`;
}

/** Below this (m) lengths are given in millimetres. */
const SMALL = 0.1;

/** The unit for lengths up to a size (m), and how many of it make a metre. */
export function lengthUnit(size: number): [string, number] {
  return Math.abs(size) < SMALL ? ["mm", 1000] : ["m", 1];
}

/** A length (m) with its unit. */
export function metres(value: number | undefined, digits = 4): string {
  const [unit, factor] = lengthUnit(value || SMALL);
  return `${short(value === undefined ? value : factor * value, digits)} ${unit}`;
}

/** The least length (m) that is given in each unit, the largest first, and how many of it make a metre; as reports do. */
const LENGTHS: [string, number, number][] = [["m", 0.1, 1], ["cm", 0.01, 100], ["mm", 0, 1000]];

/** A length (m) by itself, in the unit of m, cm and mm that suits it. */
export function suitedLength(value: number, digits = 4): string {
  const [unit, , factor] = LENGTHS.find(([, least]) => Math.abs(value) >= least && value !== 0) ?? LENGTHS[0]!;
  return `${short(factor * value, digits)} ${unit}`;
}

/** How many times as steep as they are heights are drawn, in words. */
export function heights(times: number): string {
  return Math.abs(times - 1) < 0.05 ? "heights to scale" : `heights × ${short(times, 2)}`;
}

/** A duration in the units that people would state it in. */
export function duration(seconds: number): string {
  const two = (value: number) => String(Math.floor(value)).padStart(2, "0");
  const [days, day] = [Math.floor(seconds / 86_400), seconds % 86_400];
  const clock = `${two(day / 3600)}:${two((day % 3600) / 60)}`;
  if (seconds < 120) return `${short(seconds, 3)} s`;
  if (seconds < 7200) return `${Math.floor(seconds / 60)} min ${two(seconds % 60)} s`;
  if (days < 1) return `${clock} h`;
  return days < 1000 ? `${days} d ${clock}` : `${(days / 365.2425).toFixed(1)} years`;
}

const TIMES: [string, number][] = [["years", 31_557_600], ["days", 86_400], ["hours", 3600], ["minutes", 60]];

/** The unit for durations up to one (s), and how many seconds it has; as the pictures that are saved have it. */
export function timeUnit(seconds: number): [string, number] {
  return TIMES.find(([, length]) => seconds >= length) ?? ["s", 1];
}

/** Give a text to the user as a file. */
export function download(name: string, content: Blob | string): void {
  const blob = typeof content === "string" ? new Blob([content], { type: "text/plain" }) : content;
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Put a text on the clipboard, also where the page is not served as browsers ask of those that may write there. */
export async function copyText(text: string): Promise<void> {
  if (navigator.clipboard) return navigator.clipboard.writeText(text);
  const field = h("textarea", { className: "unseen", value: text });
  document.body.append(field);
  field.select();
  document.execCommand("copy");
  field.remove();
}

/** Call a function a while after the last call. */
export function later<A extends unknown[]>(milliseconds: number, action: (...args: A) => void): (...args: A) => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return (...args) => {
    clearTimeout(timer);
    timer = setTimeout(() => action(...args), milliseconds);
  };
}

/** A canvas as sharp as the screen, its size in pixels of the page. */
export function fitCanvas(canvas: HTMLCanvasElement): { context: CanvasRenderingContext2D; width: number; height: number } {
  const { clientWidth: width, clientHeight: height } = canvas;
  const ratio = window.devicePixelRatio || 1;
  const [w, hh] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== hh) {
    canvas.width = w;
    canvas.height = hh;
  }
  const context = canvas.getContext("2d")!;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return { context, width, height };
}

/** Whether an element, of the page or of a view in it, has the focus. */
export function isActive(element: Element): boolean {
  return (element.getRootNode() as Document | ShadowRoot).activeElement === element;
}

/** A colour of the theme of an element, which is the page's unless it has its own. */
export function themeColour(name: string, of: Element = document.documentElement): string {
  return getComputedStyle(of).getPropertyValue(`--${name}`).trim();
}

/** The letters of numbers and names on charts. */
export const CHART_FONT = "12px system-ui, sans-serif";

/** Round marks on an axis from `low` to `high`, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const found: number[] = [];
  for (let tick = Math.ceil(low / step) * step; tick <= high + step * 1e-6; tick += step) {
    found.push(Number(tick.toPrecision(12)));
  }
  return found;
}
