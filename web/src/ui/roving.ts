/** Arrow keys in a row of tabs: one of them takes part in the order of the Tab key, the arrows go on from it. */

const STEPS: Record<string, number> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/** Let the arrow keys, Home and End move between tabs; `moved` is called with the place of the tab that was reached. */
export function roving(list: HTMLElement, tabs: HTMLElement[], moved: (at: number) => void = () => {}): void {
  const enter = (at: number) => tabs.forEach((tab, number) => (tab.tabIndex = number === at ? 0 : -1));
  enter(0);
  list.addEventListener("focusin", (event) => {
    const at = tabs.indexOf(event.target as HTMLElement);
    if (at >= 0) enter(at);
  });
  list.addEventListener("keydown", (event) => {
    const at = tabs.indexOf(document.activeElement as HTMLElement);
    const ends: Record<string, number> = { Home: 0, End: tabs.length - 1 };
    const step = STEPS[event.key];
    const next = step === undefined ? ends[event.key] : (at + step + tabs.length) % tabs.length;
    if (at < 0 || next === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    tabs[next]!.focus();
    moved(next);
  });
}
