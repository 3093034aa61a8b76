/** A key as people read it: `hop length` for `hop_length`; short symbols stay, `p_ns`. */
export function labelOf(name: string): string {
  return name.replaceAll(/_(?=[a-z0-9]{3})/g, " ");
}
