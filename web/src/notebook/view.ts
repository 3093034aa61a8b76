/** A view of a simulation in the cell of a notebook: the studio's scene, without its server. */

import { App } from "../core/app";
import type { Entry } from "../core/notices";
import { View } from "../core/view";
import layout from "../layout.css?inline";
import { sceneIn } from "../scene/scene_view";
import style from "../style.css?inline";
import { h } from "../ui/dom";
import { Hud } from "../ui/hud";
import { Timeline } from "../ui/timeline";
import { Controls } from "./controls";
import type { WidgetModel } from "./model";
import { ModelConnection } from "./model_connection";
import own from "./view.css?inline";

interface Place {
  model: WidgetModel;
  el: HTMLElement;
}

/** Draw a view into an element; returns what ends it and gives everything back. */
function render({ model, el }: Place): () => void {
  const host = h("div", { className: "barchan-view" });
  const root = host.attachShadow({ mode: "open" });
  root.append(h("style", {}, scoped(style), scoped(layout), own));
  el.append(host);

  const connection = new ModelConnection(model);
  const app = new App(connection, new View({ turning: false, field: String(model.get("field")) }));
  const scene = h("div", { className: "scene" });
  const says = h("p", { className: "says", role: "status", hidden: true });
  const looksOnly = !model.get("continues");
  const controls = new Controls(app, (field) => choose(model, field), looksOnly);
  const timeline = new Timeline(app);
  root.append(h("div", { className: "notebook" }, controls.element, scene, timeline.element, says));

  const size = () => scene.style.setProperty("height", `${Number(model.get("height"))}px`);
  const field = () => app.view.set({ field: String(model.get("field")) });
  const theme = themed(host, () => app.changed.send());
  size();
  const stage = sceneIn(scene, app);
  const hud = new Hud(app, stage);
  scene.append(hud.element);
  stage.canvas.addEventListener("pointermove", (event) => hud.pointAt(event));
  stage.canvas.addEventListener("pointerleave", () => hud.pointAt(null));
  app.notices.logged.watch((entry) => say(says, entry));
  app.framed.watch(() => app.running && (says.hidden = true));
  model.on("change:field", field);
  model.on("change:height", size);
  app.start();

  return () => {
    model.off("change:field", field);
    model.off("change:height", size);
    theme.disconnect();
    timeline.stop();
    connection.close();
    stage.dispose();
    host.remove();
  };
}

/** The page's styles for a part of another page: what they say of the page they say of the part. */
function scoped(css: string): string {
  return css.replace(/:root(\[[^\]]*\])?/g, (_, state?: string) => (state ? `:host(${state})` : ":host"));
}

function choose(model: WidgetModel, field: string): void {
  model.set("field", field);
  model.save_changes();
}

function say(place: HTMLElement, { level, text }: Entry): void {
  place.textContent = text;
  place.dataset.level = level;
  place.hidden = false;
}

/** Let a view be as dark as its notebook, now and whenever that changes; returns what watches it. */
function themed(host: HTMLElement, changed: () => void): MutationObserver {
  const set = () => {
    const theme = isDark() ? "dark" : "light";
    if (host.dataset.theme === theme) return;
    host.dataset.theme = theme;
    changed();
  };
  const observer = new MutationObserver(set);
  for (const element of [document.body, document.documentElement]) observer.observe(element, { attributes: true });
  set();
  return observer;
}

/** Whether the notebook is dark, as JupyterLab, VS Code or else the system says. */
function isDark(): boolean {
  const { body, documentElement } = document;
  const jupyter = body.dataset.jpThemeLight;
  if (jupyter !== undefined) return jupyter === "false";
  if (body.dataset.vscodeThemeKind) return body.dataset.vscodeThemeKind !== "vscode-light";
  const { theme } = documentElement.dataset;
  return theme ? theme === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

export default { render };
