/** A file as the ground: the sheet that asks for it, and the run that begins on it. */

import type { App } from "../core/app";
import { type Heights, type Size, distorts, inProportion, isImage, sizeOf } from "../core/image_ground";
import type { KeptFile } from "../core/kept_file";
import type { Json, JsonObject } from "../core/protocol";
import type { Run } from "../core/run";
import { type Submit, formDialog } from "./dialog";
import { h } from "./dom";
import { HeightEnds, sheetRow } from "./height_ends";

/** Most cells of an elevation model that become cells of the lattice one by one. */
const MOST_CELLS = 2 ** 19;

/** What is asked of an image: the heights of black and white, and whether the field takes its proportions. */
export interface ImageChoice extends Heights {
  keeps: boolean;
}

/** Uses a file as ground, an image as was chosen. */
type Use = (file: File, image: ImageChoice | null, ...work: Parameters<Submit>) => Promise<void>;

/** Ask for a file, unless it is given, and of an image how it is to be read. */
export function groundSheet(app: App, use: Use, given?: File): void {
  const suffixes = app.files.heights;
  const title = "Ground from a file";
  const image = new ImageRows(app.current!);
  const input = h("input", { type: "file", accept: suffixes.join(), required: true, "aria-label": title, onchange: () => void image.show(input.files?.[0]) });
  const submit: Submit = async (progress, signal) => {
    const file = given ?? input.files?.[0];
    if (file) await use(file, isImage(file.name) ? image.choice : null, progress, signal);
  };
  const text = given ? given.name : `One of ${suffixes.join(", ")}. Files can be dropped onto the scene as well.`;
  formDialog(title, "use it", submit, h("p", {}, text), !given && input, image.element, h("p", { className: "hint" }, "The run begins again on it."));
  void image.show(given);
}

/** The rows of the sheet that an image has. */
class ImageRows {
  private readonly ends: HeightEnds;
  private readonly shape = h("select", { "aria-label": "Shape of the field", onchange: () => this.tell() }, h("option", { value: "keep" }, "keep the image's proportions"), h("option", { value: "stretch" }, "stretch it over the field"));
  private readonly told = h("p", { className: "hint", role: "status" });
  readonly element: HTMLElement;
  private file: File | undefined;
  private size: Size | null = null;

  constructor(private readonly run: Run) {
    this.ends = new HeightEnds(run);
    const north = h("p", { className: "hint" }, "The upper edge of the image is north. Of colours the luminance is taken.");
    this.element = h("div", { hidden: true }, this.ends.element, sheetRow("shape", this.shape), this.told, north);
  }

  get choice(): ImageChoice {
    return { ...this.ends.values, keeps: this.shape.value === "keep" };
  }

  async show(file: File | undefined): Promise<void> {
    this.file = file;
    this.element.hidden = !file || !isImage(file.name);
    this.size = null;
    this.tell();
    const size = file && isImage(file.name) ? await sizeOf(file) : null;
    if (file !== this.file) return;
    this.size = size;
    this.tell();
  }

  /** Say what becomes of an image, or of the field, where their proportions differ. */
  private tell(): void {
    const { size, run } = this;
    const field = run.description!.lattice;
    const differ = size !== null && distorts(size, field, hasHexagons(run.description!.scenario));
    this.told.hidden = !differ;
    if (!differ) return;
    const keeps = this.shape.value === "keep";
    const { columns, rows } = inProportion(size, field, hasHexagons(run.description!.scenario));
    this.told.className = keeps ? "hint" : "trouble";
    this.told.textContent = keeps
      ? `The image has ${size.columns} × ${size.rows} pixels. The field, ${field.columns} × ${field.rows} cells now, gets ${columns} × ${rows} of the same size.`
      : `The image has ${size.columns} × ${size.rows} pixels, the field ${field.columns} × ${field.rows} cells: stretched over it a round hill becomes an oval.`;
  }
}

const hasHexagons = (scenario: JsonObject): boolean => (scenario.lattice as JsonObject).kind === "hex";

/** Begin the run again on the heights of a file that is kept. Throws where that is refused. */
export async function beginOn(app: App, file: File, kept: KeptFile, image: ImageChoice | null): Promise<void> {
  const scenario = app.current?.description?.scenario;
  if (!scenario) return;
  const heights = image ? { lowest: image.lowest, highest: image.highest } : {};
  const { codes = [], coloured = false } = kept.heights ?? {};
  const ground: JsonObject = { kind: "file", path: kept.path, resample: true, fill: "interpolate", ...heights, ...(codes.length ? { missing: codes } : {}) };
  const lattice = image ? shaped(scenario, kept, image) : measured(scenario, kept);
  await app.begin({ ...scenario, ...lattice, ground }, true, true);
  app.notices.settle(["ground", "lattice"]);
  const said = [
    `${file.name} is the ground now`,
    image ? `black ${image.lowest} m high, white ${image.highest} m` : "",
    coloured ? "its colours taken by their luminance" : "",
    codes.length ? `${codes.join(", ")} taken as cells without a height` : "",
  ];
  app.note("info", `${said.filter(Boolean).join(", ")}; see Ground in the panel.`);
}

/** The lattice in the proportions of an image, where these are to be kept and differ. */
function shaped(scenario: JsonObject, { heights }: KeptFile, { keeps }: ImageChoice): { [key: string]: Json } {
  const lattice = scenario.lattice as JsonObject & Size;
  if (!keeps || !heights || !distorts(heights, lattice, hasHexagons(scenario))) return {};
  return { lattice: { ...lattice, ...inProportion(heights, lattice, hasHexagons(scenario)) } };
}

/** The lattice over a whole elevation model: its own cells, or larger ones where there are too many. */
function measured(scenario: JsonObject, kept: KeptFile): { [key: string]: Json } {
  const { rows = 0, columns = 0, cell_size = null } = kept.heights ?? {};
  if (cell_size === null) return {};
  const { rows: _rows, columns: _columns, ...rest } = scenario.lattice as JsonObject;
  const times = Math.ceil(Math.sqrt((rows * columns) / MOST_CELLS));
  return { lattice: { ...rest, kind: "from ground", cell_size: cell_size * times } };
}
