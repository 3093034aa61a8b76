/** Runs written for other programs: a sheet with every format of `barchan export`. */

import type { App } from "../core/app";
import type { Progress } from "../core/connection";
import { plainFields } from "../scene/colouring";
import { formDialog } from "./dialog";
import { download, h } from "./dom";

/** A format, as the server lists it. */
interface Format {
  name: string;
  suffix: string;
  meaning: string;
  series: boolean;
  one_field: boolean;
  smooth: boolean;
}

const SMOOTHING = "Whole slabs make terraces in close views; smoothing takes them away and keeps the mean.";

export async function exportRun(app: App): Promise<void> {
  const formats = await app.connection.fetch<Format[]>("formats");
  const choice = h(
    "select",
    { "aria-label": "Format", onchange: () => show() },
    ...formats.map((one) => h("option", { value: one.name }, `${one.suffix}: ${one.meaning}`)),
  );
  const fields = [...plainFields(app.current?.material ?? "sand"), ...(app.current?.description?.fields ?? [])];
  const field = h("select", { "aria-label": "Field" }, ...fields.map((one) => h("option", { value: one.name }, one.meaning)));
  const smooth = h("input", { type: "number", min: "0", max: "20", step: "0.1", value: "0", "aria-label": "Smoothing in cells" });
  const name = h("input", { type: "text", value: "dunes", required: true, pattern: "[A-Za-z0-9_\\-]+", "aria-label": "Name of the file" });
  const told = h("p", { className: "hint" });
  const one = h("div", { className: "row" }, h("span", {}, "field"), field);
  const soft = h("div", { className: "row", title: SMOOTHING }, h("span", {}, "smoothing (cells)"), smooth);

  const chosen = () => formats.find((format) => format.name === choice.value)!;
  const show = () => {
    one.hidden = !chosen().one_field;
    soft.hidden = !chosen().smooth;
    told.textContent = chosen().series ? "All states that are kept, in one file." : "The state that is shown.";
  };
  const save = async (progress: Progress) => {
    const format = chosen();
    const options = {
      ...(format.smooth && Number(smooth.value) > 0 ? { smooth: Number(smooth.value) } : {}),
      ...(format.one_field ? { fields: [field.value] } : {}),
    };
    const request = { command: "export" as const, name: `${name.value}${format.suffix}`, format: format.name, ...options, run: app.selected };
    const answer = await app.connection.ask(request, progress);
    const file = String(answer.file);
    download(file.split("/").at(-1)!, await app.connection.file(`exports/${file}`));
    app.note("info", `Exported ${file.split("/").at(-1)}; it is kept in studio-exports, with a file that tells what its numbers mean.`);
  };
  formDialog("Export for other programs", "export", save, h("div", { className: "row" }, h("span", {}, "format"), choice), one, soft, h("div", { className: "row" }, h("span", {}, "name"), name), told);
  show();
}
