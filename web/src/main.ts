/** Puts the page together. */

import "./style.css";
import "./layout.css";
import "./messages.css";
import "./first_minute.css";
import "./sharing.css";
import { App } from "./core/app";
import { SocketConnection } from "./core/socket";
import { takeAccess } from "./core/token";
import { View } from "./core/view";
import { sceneIn } from "./scene/scene_view";
import type { Stage } from "./scene/stage";
import { Bar } from "./ui/bar";
import { ChangeLog } from "./ui/change_log";
import { Compare } from "./ui/compare";
import { Dock, type DockView } from "./ui/dock";
import { button, h } from "./ui/dom";
import { EqualTimes } from "./ui/equal_times";
import { Files } from "./ui/files";
import { FullScreen } from "./ui/fullscreen";
import { gallery } from "./ui/gallery";
import { type Shortcut, control, help, key, listen } from "./ui/help";
import { Hud } from "./ui/hud";
import { icon } from "./ui/icons";
import { mayEnd } from "./ui/may_end";
import { Moments } from "./ui/moments";
import { Paint } from "./ui/paint";
import { Panel } from "./ui/panel";
import { Pointer } from "./ui/pointer";
import { Recorder } from "./ui/recorder";
import { Ruler } from "./ui/ruler";
import { ArrivingLinks } from "./ui/scenario_links";
import { Side } from "./ui/side";
import { StateNotice } from "./ui/state_notice";
import { Tabs } from "./ui/tabs";
import { Toasts, leadTo } from "./ui/toasts";
import { Tour } from "./ui/tour";
import { Unfinished } from "./ui/unfinished";
import { Timeline } from "./ui/timeline";
import { ViewPanel } from "./ui/viewpanel";
import { readOnly, watcherCount } from "./ui/watching";
import { WindPanel } from "./ui/wind";
import { LogView } from "./views/log";
import { SectionView } from "./views/section";
import { SeriesView } from "./views/series";
import { SpaceTimeView } from "./views/spacetime";

const opensGallery = location.hash === "#gallery";
const access = takeAccess();
const app = new App(new SocketConnection(access), new View(), access.watching);

function themed(): void {
  const { theme } = app.view.look;
  const dark = theme === "dark" || (theme === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
  const name = dark ? "dark" : "light";
  if (document.documentElement.dataset.theme === name) return;
  document.documentElement.dataset.theme = name;
  app.changed.send(); // views that draw in colours of the theme draw again
}
themed();
app.view.changed.watch(themed);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", themed);

const scene = h("div", { className: "scene" });
const stage = sceneIn(scene, app);
const hud = new Hud(app, stage);
scene.append(hud.element);

const recorder = new Recorder(app, stage);
scene.append(recorder.element);
const files = new Files(app, stage, recorder);
if (!app.watching) files.accept(scene);
const paint = new Paint(app);
const section = new SectionView(app, stage, () => pointer.drawLine());
const ruler = new Ruler(app, stage);
const pointer = new Pointer(stage, hud, paint, section, ruler);
const log = new LogView(app);
new ChangeLog(app);
if (!app.watching) new EqualTimes(app);
const series = new SeriesView(app);
const views: DockView[] = [section, series, ...(app.watching ? [] : [new SpaceTimeView(app, section)]), log];
const dock = new Dock(views);
const moments = new Moments(app, stage);
const timeline = new Timeline(app, () => void moments.mark());
const scenario = new Panel(app, () => void files.askForGround()).element;
if (app.watching) readOnly(scenario);
const changing = (): [string, HTMLElement][] => [
  ["Wind", new WindPanel(app, () => void files.askForWind()).element],
  ["Paint", paint.element],
  ["View", new ViewPanel(app, stage).element],
  ["Moments", moments.element],
];
const tabs = new Tabs([["Scenario", scenario], ...(app.watching ? [] : changing())]);
const side = new Side(tabs.elements);
const full = new FullScreen();
const commands = [watcherCount(app), button("Presets (G)", "Presets", () => showGallery()), files.menu, new Compare(app).element];
const bar = new Bar(app, [
  ...(app.watching ? [] : commands),
  button("Ruler: measure between two places (M)", icon("ruler"), () => ruler.toggle()),
  button("Keys and mouse (?)", "?", () => help(shortcuts)),
  button("Full screen (F)", icon("full"), () => full.toggle()),
  side.button,
]);

const toasts = new Toasts(app, (key) => {
  side.unfold();
  tabs.choose(key === "wind" || key.startsWith("wind.") ? 1 : 0);
  leadTo(key);
});
const unfinished = new Unfinished(app);
app.wayBack.allowed = mayEnd;
const messages = h("div", { className: "messages" }, new StateNotice(app).element, unfinished.overScene(), toasts.element);

app.notices.logged.watch((entry) => entry.level !== "info" && dock.mark(log));

const openWind = () => {
  side.unfold();
  tabs.choose(1);
};
const tour = new Tour(app, openWind, stage.painted);
const showGallery = () => void gallery(app, () => tour.begin(), unfinished).catch((error) => app.refused(error));

const turn = Math.PI / 36;
/** Keys that command the run, which a window that watches does without. */
const commanding: Shortcut[] = [
  key(" ", "run or pause", () => bar.toggle(), "Space"),
  key(".", "one step", () => bar.step(1)),
  key("r", "restart with the same seed", () => bar.restart(), "R"),
  key("g", "presets", () => showGallery(), "G"),
  key("b", "brush on or off", () => paint.activate(!paint.active), "B"),
  key("[", "smaller brush", () => paint.grow(1 / 1.25)),
  key("]", "larger brush", () => paint.grow(1.25)),
  control("z", false, "undo painting", () => app.send({ command: "undo" })),
  control("z", true, "redo painting", () => app.send({ command: "redo" })),
  key("PageUp", "look back", () => timeline.nudge(-1), "Page up"),
  key("PageDown", "look on", () => timeline.nudge(1), "Page down"),
  key("End", "return to now", () => timeline.live()),
  key("k", "mark this moment", () => void moments.mark(), "K"),
  key("w", "wireframe", () => app.view.set({ wireframe: !app.view.look.wireframe }), "W"),
];
const looking: Shortcut[] = [
  key("l", "draw the line of the section", () => pointer.drawLine(), "L"),
  key("m", "ruler: measure between two places", () => ruler.toggle(), "M"),
  ...views.map((view, at) => key(String(at + 1), view.title.toLowerCase(), () => dock.toggle(at))),
  key("Backspace", "dismiss all refusals", () => app.notices.dismissAll()),
  key("o", "oblique view", () => stage.look("oblique"), "O"),
  key("t", "view from above", () => stage.look("top"), "T"),
  key("s", "view from the side", () => stage.look("side"), "S"),
  key("ArrowLeft", "turn the view", () => stage.turn(turn, 0), "← → ↑ ↓"),
  key("+", "come nearer", () => stage.turn(0, 0, 0.9)),
  key("-", "go back", () => stage.turn(0, 0, 1.1)),
  key("f", "full screen with large type, and back", () => full.toggle(), "F"),
  key("p", "save a picture", () => void files.savePicture(), "P"),
  key("v", "record the scene, and end that", () => recorder.toggle(), "V"),
  key("Escape", "end a recording and save it", () => recorder.finish(), "Esc"),
  key("n", "panel: fold or draw out", () => side.toggle(), "N"),
  key("?", "this list", () => help(shortcuts)),
];
const shortcuts = app.watching ? looking : [...commanding, ...looking];
const quiet: Shortcut[] = [
  key("ArrowRight", "", () => stage.turn(-turn, 0)),
  key("ArrowUp", "", () => stage.turn(0, -turn)),
  key("ArrowDown", "", () => stage.turn(0, turn)),
  key("=", "", () => stage.turn(0, 0, 0.9)),
];
listen([...shortcuts, ...quiet]);

const page = document.getElementById("app")!;
page.classList.add("waiting");
page.classList.toggle("watching", app.watching);
app.framed.watch(() => {
  if (!app.current?.ready || !page.classList.contains("waiting")) return;
  page.classList.remove("waiting");
  links.open();
});
let gallerySeen = !opensGallery || app.watching;
app.connection.state.watch((state) => {
  if (state !== "open" || gallerySeen) return;
  gallerySeen = true; // before the first frame: the first model may still be compiled
  history.replaceState(null, "", location.pathname + location.search);
  showGallery();
});
page.append(
  bar.element,
  h("main", {}, h("div", { className: "stage-column" }, h("div", { className: "scene-and-messages" }, scene, ruler.element, messages), tour.element, timeline.element, dock.element), side.element),
);

const links = new ArrivingLinks(app, files);
app.start();

/** For tests and measurements. */
declare global {
  interface Window {
    barchan: { app: App; stage: Stage; series: SeriesView; tour: Tour; files: Files };
  }
}
window.barchan = { app, stage, series, tour, files };
