/** The part of a widget's model that the view needs; see https://anywidget.dev/en/afm. */

import type { Json } from "../core/protocol";

export interface WidgetModel {
  get(name: string): unknown;
  set(name: string, value: Json): void;
  save_changes(): void;
  on(name: string, listener: (content: never) => void): void;
  off(name: string, listener: (content: never) => void): void;
  send(content: Json): void;
}

/** The bytes of a frame; a view into a longer buffer becomes one of its own. Null where there is none yet. */
export function bytesOf(value: unknown): ArrayBuffer | null {
  if (!(value instanceof DataView) || value.byteLength === 0) return null;
  return value.buffer.slice(value.byteOffset, value.byteOffset + value.byteLength) as ArrayBuffer;
}
