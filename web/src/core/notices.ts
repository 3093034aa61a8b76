/** What the page says to its user: the log of everything, refusals that stay until dismissed, marks at the places they concern. */

import { labelOf } from "./labels";
import type { Problem } from "./protocol";
import { Signal } from "./signal";

export type Level = "info" | "warning" | "error";

export interface Entry {
  time: Date;
  level: Level;
  text: string;
  /** The key of the scenario that it concerns; empty where there is none. */
  key: string;
  /** Keys whose change was refused; a value that any of them takes since settles it. */
  about?: string[] | undefined;
  /** What its user can do about it. */
  way?: Way | undefined;
}

export interface Way {
  name: string;
  act: () => void;
}

/** Milliseconds for which a confirmation stands on the page. */
const SEEN = 6000;
/** Entries of the log that are kept. */
const MOST = 1000;
/** Said while kernels are compiled: those of a model at first, or what a change of wind or a brush needs. */
export const COMPILING = "Translating the model into machine code, once, for it is kept";

export class Notices {
  readonly log: Entry[] = [];
  readonly logged = new Signal<Entry>();
  /** Refusals that were not dismissed yet. */
  standing: Entry[] = [];
  readonly changed = new Signal<void>();
  /** Why the value of a key was refused, by key. */
  readonly troubles = new Map<string, string>();

  /** Put a line into the log; a refusal also stands on the page until it is dismissed. */
  note(level: Level, text: string, key = "", stands = level === "error", way?: Way): Entry {
    const entry: Entry = { time: new Date(), level, text, key: dotted(key), way };
    this.log.push(entry);
    if (this.log.length > MOST) this.log.shift();
    if (stands) this.standing = [...this.standing.filter((one) => one.text !== text), entry];
    if (key) this.troubles.set(entry.key, text);
    this.logged.send(entry);
    if (stands) this.changed.send();
    return entry;
  }

  /** Confirm what its user has asked for: it stands on the page for a while. */
  confirm(text: string): void {
    const entry = this.note("info", text, "", true);
    setTimeout(() => this.dismiss(entry), SEEN);
  }

  /** Let a line of the log say something else. */
  amend(entry: Entry, text: string): Entry {
    Object.assign(entry, { text, time: new Date() });
    this.logged.send(entry);
    return entry;
  }

  /** Let a line of the log stand on the page again. */
  restore(entry: Entry): void {
    if (!this.standing.includes(entry)) this.standing = [...this.standing, entry];
    this.changed.send();
  }

  dismiss(entry: Entry): void {
    this.standing = this.standing.filter((one) => one !== entry);
    this.troubles.delete(entry.key);
    this.changed.send();
  }

  dismissAll(): void {
    for (const entry of this.standing) this.troubles.delete(entry.key);
    this.standing = [];
    this.changed.send();
  }

  /** Take away the refusals of keys, and of changes of them, for values of them that were taken since. */
  settle(keys: string[]): void {
    const settled = (key: string) => keys.some((one) => one === key || key.startsWith(`${one}.`));
    const before = this.standing.length + this.troubles.size;
    const stays = ({ key, about = [] }: Entry) => !settled(key) && !about.some(settled);
    for (const { key } of this.standing.filter((one) => !stays(one))) this.troubles.delete(key);
    this.standing = this.standing.filter(stays);
    for (const key of this.troubles.keys()) if (settled(key)) this.troubles.delete(key);
    if (this.standing.length + this.troubles.size < before) this.changed.send();
  }

  clearLog(): void {
    this.log.length = 0;
  }
}

/** A problem: where it stands, then what it is. Of a file the key is named as it is written there, else as on the page. */
export function problemText({ key, message, place }: Problem): string {
  const ofFile = place !== "" && !OWN_PLACES.has(place);
  const said = ofFile ? message : spokenMessage(message);
  const text = key ? `${ofFile ? key : spokenKey(key)}: ${said}` : said;
  return ofFile ? `${text} (${place})` : text;
}

/** Why a value is refused, as the page writes it: no value is none, and long numbers are grouped. */
function spokenMessage(message: string): string {
  return message.replaceAll(/\bnull\b/g, "none").replaceAll(/(?<=^|[\s(])\d{5,}(?=$|[\s;,)])/g, (digits) => digits.replaceAll(/(?<=\d)(?=(\d{3})+$)/g, "\u202f"));
}

/** Places that mean the scenario on the page, not a file. */
const OWN_PLACES = new Set(["scenario", "run"]);

/** A key with dots before numbers, as the rows of forms are marked: `wind.regimes.0.speed`. */
function dotted(key: string): string {
  return key.replaceAll(/\[(\d+)\]/g, ".$1");
}

/** A key as the panel's headings and rows name it: `model › hop length`. */
export function spokenKey(key: string): string {
  return dotted(key)
    .split(".")
    .map((part) => (/^\d+$/.test(part) ? String(Number(part) + 1) : labelOf(part)))
    .join(" › ");
}
