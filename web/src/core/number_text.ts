/** Numbers as people write them: with a decimal point or a decimal comma. */

const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i;
/** Digits in groups of three, parted by spaces as the page itself writes them. */
const GROUPED = /^[+-]?\d{1,3}([ \u00a0\u2009\u202f]\d{3})+(?=$|[.,])/;
/** A comma before three digits, which parts thousands for some and decimals for others. */
const DOUBTFUL = /^[+-]?[1-9]\d{0,2},\d{3}$/;

/** The number that a text states; null where it states none, or where it is in doubt which. */
export function numberIn(text: string): number | null {
  const plain = plainly(text);
  return DOUBTFUL.test(plain) || !NUMBER.test(plain) ? null : Number(plain.replace(",", "."));
}

/** Why no number can be read in a text, and how to write it. */
export function unreadable(text: string): string {
  const plain = plainly(text);
  if (!DOUBTFUL.test(plain)) return `“${text.trim()}” is not a number. Write it like 12 or 0.5.`;
  return `“${text.trim()}” may mean ${plain.replace(",", "")} or ${plain.replace(",", ".")}. Write one of them.`;
}

function plainly(text: string): string {
  return text.trim().replace("\u2212", "-").replace(GROUPED, (digits) => digits.replaceAll(/\s/g, ""));
}
