/** What the page keeps in the browser, checked when it is read: an older version, or a hand, may have written something else. */

type Settings = Record<keyof never, unknown>;

/** Settings that are two numbers. */
const PAIRS = new Set(["limits"]);

type Choices<T> = Partial<Record<keyof T, readonly string[]>>;

/** The settings under a key; those that are missing, or are not of the kind of the usual ones, as usual. */
export function stored<T extends object>(key: string, usual: T, choices: Choices<T> = {}): T {
  return checked(read(key), usual, choices);
}

/** Settings that were found somewhere; those that are missing, or are not of the kind of the usual ones, as usual. */
export function checked<T extends object>(given: object, usual: T, choices: Choices<T> = {}): T {
  const found = given as Settings;
  // null stands for a number that is chosen by itself, or for a pair of them
  const kinds = (name: keyof T) => (usual[name] === null ? ["null", PAIRS.has(String(name)) ? "pair" : "number"] : [kindOf(usual[name])]);
  const fits = (name: keyof T) => kinds(name).includes(kindOf(found[name]));
  const allowed = (name: keyof T) => !choices[name] || choices[name].includes(String(found[name]));
  const names = (Object.keys(usual) as (keyof T)[]).filter((name) => found[name] !== undefined && fits(name) && allowed(name));
  return { ...usual, ...Object.fromEntries(names.map((name) => [name, found[name]])) };
}

/** Keep settings under a key, where the browser lets it. */
export function keep(key: string, settings: object): void {
  try {
    localStorage.setItem(key, JSON.stringify(settings));
  } catch {
    // private windows keep nothing
  }
}

/** What stands under a key, unchecked; nothing where that is no group of settings. */
export function read(key: string): Settings {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(key) ?? "{}");
    return found !== null && typeof found === "object" ? (found as Settings) : {};
  } catch {
    return {};
  }
}

function kindOf(value: unknown): string {
  if (value === null) return "null";
  if (typeof value === "number") return Number.isFinite(value) ? "number" : "nothing";
  if (!Array.isArray(value)) return typeof value;
  if (value.every((item) => typeof item === "string")) return "words";
  return value.length === 2 && value.every((item) => Number.isFinite(item)) ? "pair" : "nothing";
}
