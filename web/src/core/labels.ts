/** A key as people read it: `hop length` for `hop_length`; short symbols stay, `p_ns`. */
export function labelOf(name: string): string {
  return name.replaceAll(/_(?=[a-z0-9]{3})/g, " ");
}

/** Stands in titles and citations before the keys and values in which a scenario differs from the one it came of. */
const CHANGED = "changed: ";

/** A title or citation with those keys as the panel names them: `columns 128` for `lattice.columns 128`. */
export function readable(words: string): string {
  const [own, changes] = split(words);
  return changes === null ? words : own + changes.split(", ").map(withoutDots).join(", ");
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

function withoutDots(change: string): string {
  const [key = "", ...value] = change.split(" ");
  const parts = key.split(".");
  const last = parts.at(-1)!;
  const name = (last === "kind" || last === "name") && parts.length > 1 ? parts.at(-2)! : last;
  return [labelOf(name), ...value].join(" ");
}
