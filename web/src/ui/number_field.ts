/** The field of a number, wherever the page takes one: what cannot be read as a number is refused at the field. */

import { numberIn, unreadable } from "../core/number_text";
import { h } from "./dom";

export interface NumberOptions {
  label?: string;
  value?: number | null;
  whole?: boolean;
  least?: number;
  most?: number;
  /** Whether it may be negative, where no least number tells. */
  signed?: boolean;
  /** Whether it may be empty, which counts as null. */
  optional?: boolean;
  /** Whether it is as wide as what stands there asks for. */
  grows?: boolean;
  /** Takes what was typed, once it is whole and can be read. */
  take?: (value: number | null) => void;
  /** Called at every key. */
  typing?: () => void;
  /** Further properties of the element. */
  props?: Record<string, unknown>;
}

/** Characters that a field is wider than its number, for its frame and the place of the cursor. */
const ROOM = 2;

/** A text that was refused, and the number that it was typed in place of. */
export interface RefusedText {
  text: string;
  before: number | null;
}

const FIELDS = new WeakMap<Element, NumberField>();

export class NumberField {
  readonly element: HTMLInputElement;
  /** The number that stood there last. */
  private last: number | null = null;
  private readonly trouble = h("output", { className: "misread", role: "alert" });

  constructor(private readonly options: NumberOptions) {
    const { label, value, signed = false, least = signed ? -1 : 0, props } = options;
    const { className = "", ...more } = props ?? {};
    this.element = h("input", {
      type: "text", // browsers drop a comma from fields of the type number, and read 0,5 as 5
      inputMode: least < 0 ? "text" : "decimal", // keypads for decimals have no minus
      role: "spinbutton",
      autocomplete: "off",
      spellcheck: false,
      ...more,
      ...(label ? { "aria-label": label } : {}),
      className: `number ${String(className)}`.trim(),
      oninput: () => this.typed(),
      onchange: () => this.finished(),
      onkeydown: (event: KeyboardEvent) => this.pressed(event),
    });
    FIELDS.set(this.element, this);
    this.show(value ?? null);
  }

  /** The field that an element is of. */
  static of(element: Element): NumberField | undefined {
    return FIELDS.get(element);
  }

  /** The number that stands there; null where there is none, or none that can be taken. */
  get number(): number | null {
    return this.wrong() ? null : numberIn(this.element.value);
  }

  get valid(): boolean {
    return this.wrong() === "";
  }

  /** Let a number stand there. */
  show(value: number | null): void {
    this.last = value;
    this.element.value = value === null ? "" : String(value);
    this.say("");
    this.check();
  }

  /** Say at the field why its number is not taken. */
  refuse(why: string): void {
    this.say(why);
  }

  /** The text there that was refused; null where none was. */
  get refused(): RefusedText | null {
    return this.trouble.textContent && this.wrong() ? { text: this.element.value, before: this.last } : null;
  }

  /** Let a text that was refused stand there, with the reason; false where another number has taken the place of the one before it. */
  refuseAgain({ text, before }: RefusedText): boolean {
    if (before !== this.last) return false;
    this.element.value = text;
    this.check();
    this.say(this.wrong());
    return true;
  }

  /** Let the number that stood there before a refused text stand there again. */
  takeBack(): void {
    if (this.refused) this.show(this.last);
  }

  /** Why what stands there cannot be taken; empty where it can. */
  private wrong(): string {
    const { optional, whole, least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY } = this.options;
    const text = this.element.value;
    if (text.trim() === "") return optional ? "" : "A number is needed here.";
    const value = numberIn(text);
    if (value === null) return unreadable(text);
    if (whole && !Number.isInteger(value)) return "A whole number is needed here.";
    if (value >= least && value <= most) return "";
    return most === Number.POSITIVE_INFINITY ? `At least ${least}.` : `From ${least} to ${most}.`;
  }

  private typed(): void {
    if (this.check()) this.say("");
    this.options.typing?.();
  }

  /** Tell the form, which is not sent while its fields are wrong, and those who listen instead of looking. */
  private check(): boolean {
    const wrong = this.wrong();
    if (this.options.grows) this.element.style.minWidth = `${this.element.value.length + ROOM}ch`;
    this.element.setCustomValidity(wrong);
    const value = numberIn(this.element.value);
    if (value === null) this.element.removeAttribute("aria-valuenow");
    else this.element.setAttribute("aria-valuenow", String(value));
    return wrong === "";
  }

  private finished(): void {
    const wrong = this.wrong();
    this.say(wrong);
    if (wrong) return;
    this.last = this.number;
    this.options.take?.(this.number);
  }

  private say(why: string): void {
    this.element.setAttribute("aria-invalid", String(why !== ""));
    this.trouble.textContent = why;
    if (why) this.element.after(this.trouble);
    else this.trouble.remove();
  }

  private pressed(event: KeyboardEvent): void {
    if (event.key !== "Escape" || !this.refused) return this.step(event);
    event.preventDefault();
    event.stopPropagation(); // nothing around the field closes
    this.takeBack();
  }

  /** The arrows up and down change the last digit that is written. */
  private step(event: KeyboardEvent): void {
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const value = this.number;
    if (!sign || value === null || this.element.readOnly) return;
    event.preventDefault();
    const { least = Number.NEGATIVE_INFINITY, most = Number.POSITIVE_INFINITY } = this.options;
    const digits = String(value).split(".")[1]?.length ?? 0;
    const next = Number((value + sign * 10 ** -digits).toFixed(digits));
    this.show(Math.min(Math.max(next, least), most));
    this.finished();
  }
}
