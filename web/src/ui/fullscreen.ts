/** The scene alone, on the whole screen, with type that is read from the back row. */

export class FullScreen {
  constructor() {
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement) this.show(false);
    });
  }

  get on(): boolean {
    return document.documentElement.classList.contains("large");
  }

  /** Large type and the scene alone, on the whole screen where the browser lets a page have it. */
  toggle(): void {
    const on = !this.on;
    this.show(on);
    if (on) void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement) void document.exitFullscreen();
  }

  private show(on: boolean): void {
    document.documentElement.classList.toggle("large", on);
  }
}
