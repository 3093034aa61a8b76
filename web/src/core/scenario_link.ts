/** Links that carry a scenario, or those of two runs side by side: compressed, behind the # of an address, which no browser sends to a server. */

import type { JsonObject } from "./protocol";

const MARK = "#scenario=";
/** Characters of a link; beyond, programs for messages and mail cut them off. */
const LONGEST = 16_000;
/** Characters of a scenario that a link may unfold to. */
const LARGEST = 1 << 20;
/** A format with a check sum, so that a damaged link is noticed. */
const FORMAT = "deflate";

const CUT_OFF = "The link is damaged: part of it was cut off or changed on its way. Ask for it again, or for the scenario as a file.";

/** The link of a scenario, or of two, the left one first. Throws where one needs a file, or the link is too long. */
export async function scenarioLink(scenarios: JsonObject[], address: string): Promise<string> {
  const held = scenarios.length > 1 ? scenarios : scenarios[0]!;
  const files = pathsIn(held);
  if (files.length) throw new Error(`${scenarios.length > 1 ? "One of these scenarios" : "This scenario"} uses ${[...new Set(files)].join(", ")}, which a link cannot carry. Save the scenario instead, and hand the file on beside it.`);
  const packed = await collected(stream(new TextEncoder().encode(JSON.stringify(held))).pipeThrough(new CompressionStream(FORMAT)), LARGEST);
  const link = `${address}${MARK}${inLetters(packed)}`;
  if (link.length > LONGEST) throw new Error(`The link would have ${link.length} characters; allowed: ${LONGEST}. Save the scenario as a file instead.`);
  return link;
}

/** Whether a text holds a link of a scenario. */
export function holdsScenario(text: string): boolean {
  return text.includes(MARK);
}

/** The texts of the scenarios in a link: of one, or of two, the left one first. Throws where the link is damaged or too long. */
export async function scenariosIn(link: string): Promise<string[]> {
  const letters = link.slice(link.indexOf(MARK) + MARK.length).trim();
  if (!holdsScenario(link)) throw new Error(`This is no link of a scenario: it lacks ${MARK}`);
  if (letters.length > LONGEST) throw new Error(`The link has ${letters.length} characters; allowed: ${LONGEST}. Ask for the scenario as a file.`);
  try {
    const text = new TextDecoder("utf-8", { fatal: true }).decode(await collected(stream(inBytes(letters)).pipeThrough(new DecompressionStream(FORMAT)), LARGEST));
    const held: unknown = JSON.parse(text);
    return Array.isArray(held) ? held.slice(0, 2).map((one) => JSON.stringify(one)) : [text];
  } catch (error) {
    throw error instanceof RangeError ? error : new Error(CUT_OFF);
  }
}

/** The files that a scenario names. */
function pathsIn(data: unknown): string[] {
  if (data === null || typeof data !== "object") return [];
  return Object.entries(data).flatMap(([key, value]) => (key === "path" && typeof value === "string" ? [value.split("/").at(-1)!] : pathsIn(value)));
}

function stream(bytes: Uint8Array<ArrayBuffer>): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new Blob([bytes]).stream();
}

/** All bytes of a stream; throws RangeError beyond the most, before they fill the memory. */
async function collected(from: ReadableStream<Uint8Array>, most: number): Promise<Uint8Array> {
  const parts: Uint8Array[] = [];
  let size = 0;
  const reader = from.getReader();
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    size += next.value.length;
    if (size > most) {
      void reader.cancel();
      throw new RangeError(`The link unfolds to more than ${most >> 20} MB, which no scenario needs.`);
    }
    parts.push(next.value);
  }
  const all = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** Bytes as letters, digits, - and _, which addresses may hold as they are. */
function inLetters(bytes: Uint8Array): string {
  const text = [...bytes].map((byte) => String.fromCharCode(byte)).join("");
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function inBytes(letters: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (sign) => sign.charCodeAt(0));
}
