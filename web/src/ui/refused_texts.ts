/** Texts that were refused at the fields of a form: they stay, with the reason, where the form is drawn anew. */

import type { App } from "../core/app";
import { NumberField, type RefusedText } from "./number_field";

const NUMBERS = "input.number[data-path]";

export class RefusedTexts {
  /** Of every scenario that the form has shown since another was opened: by the paths of its fields. */
  private readonly kept = new Map<string, Map<string, RefusedText>>();
  /** The run and the scenario that the form shows. */
  private shown = "";

  constructor(
    private readonly app: App,
    private readonly form: HTMLElement,
  ) {
    app.opened.watch(() => this.kept.clear());
  }

  /** Draw the form anew, of whichever run the page shows now. */
  through(draw: () => void): void {
    this.read();
    draw();
    const run = this.app.current!;
    this.shown = `${run.name} ${run.description!.loaded}`;
    this.putBack();
  }

  /** The form's rows move or go: forget what stands in fields whose paths begin so. */
  forget(path: string): void {
    this.read();
    const texts = this.texts();
    for (const one of texts.keys()) if (one.startsWith(path)) texts.delete(one);
    for (const field of this.fields()) if (field.path.startsWith(path)) field.number.takeBack();
  }

  /** Texts at fields that are not drawn for the moment are kept. */
  private read(): void {
    const texts = this.texts();
    for (const { path, number } of this.fields()) {
      const { refused } = number;
      if (refused) texts.set(path, refused);
      else texts.delete(path);
    }
  }

  private putBack(): void {
    const texts = this.texts();
    for (const { path, number } of this.fields()) {
      const text = texts.get(path);
      if (text && !number.refuseAgain(text)) texts.delete(path);
    }
  }

  private texts(): Map<string, RefusedText> {
    if (!this.kept.has(this.shown)) this.kept.set(this.shown, new Map());
    return this.kept.get(this.shown)!;
  }

  private fields(): { path: string; number: NumberField }[] {
    return [...this.form.querySelectorAll<HTMLInputElement>(NUMBERS)].map((element) => ({ path: element.dataset.path!, number: NumberField.of(element)! }));
  }
}
