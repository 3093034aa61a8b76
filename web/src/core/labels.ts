/** A key as people read it: `hop length` for `hop_length`; short symbols stay, `p_ns`. */
export function labelOf(name: string): string {
  return name.replaceAll(/_(?=[a-z0-9]{3})/g, " ");
}

/** Stands in titles and citations before the keys and values in which a scenario differs from the one it came of. */
const CHANGED = "changed: ";

/** A title or citation with those keys and values as the panel names them, models by their titles: `columns 128` for `lattice.columns 128`. */
export function readable(words: string, models: Record<string, string> = {}): string {
  const [own, changes] = split(words);
  return changes === null ? words : own + changes.split(", ").map((change) => spoken(change, models)).join(", ");
}

/** A value that is a word as the page names it: a model by its title. */
export function valueLabel(value: string, models: Record<string, string> = {}): string {
  if (models[value] !== undefined) return models[value];
  return /^[a-z]\w*$/.test(value) ? labelOf(value) : value;
}

/** Words of a preset without the names by which the command line knows other presets: each stands behind the title. */
export function withoutNames(words: string): string {
  return words.replaceAll(/” \([a-z0-9.-]+\)/g, "”");
}

/** A title without those keys. */
export function withoutChanges(title: string): string {
  return title.split(`, ${CHANGED}`)[0]!;
}

/** What the titles of two scenarios that came of one have in common: neither names a change that the other one lacks. */
export function commonTitle(title: string, other: string): string {
  const [own, changes] = split(title);
  const others = split(other)[1]?.split(", ") ?? [];
  const common = changes?.split(", ").filter((change) => others.includes(change)) ?? [];
  return common.length ? own + common.join(", ") : withoutChanges(title);
}

function split(words: string): [string, string | null] {
  const at = words.indexOf(CHANGED);
  return at < 0 ? [words, null] : [words.slice(0, at + CHANGED.length), words.slice(at + CHANGED.length)];
}

function spoken(change: string, models: Record<string, string>): string {
  const [key = "", ...value] = change.split(" ");
  const parts = key.split(".");
  const last = parts.at(-1)!;
  const name = (last === "kind" || last === "name") && parts.length > 1 ? parts.at(-2)! : last;
  return [labelOf(name), ...value.map((word) => valueLabel(word, models))].join(" ");
}
