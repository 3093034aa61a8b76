/** Tables as text, values parted by commas. */

/** A text as a cell of such a table. */
export function cell(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
