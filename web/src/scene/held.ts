/** A still picture of the scene in its place, while its canvas is used for something else. */

/** Cover a canvas, which was painted just now, with its own picture; to be removed when it shows the scene again. */
export function still(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const picture = document.createElement("canvas");
  [picture.width, picture.height] = [canvas.width, canvas.height];
  picture.getContext("2d")!.drawImage(canvas, 0, 0);
  picture.setAttribute("aria-hidden", "true");
  Object.assign(picture.style, { position: "absolute", inset: "0", width: "100%", height: "100%", pointerEvents: "none" });
  canvas.after(picture);
  return picture;
}
