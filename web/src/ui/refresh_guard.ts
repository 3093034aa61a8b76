/** Keeps a panel from being drawn again while the mouse is down in it or a request is not answered yet. */

export class RefreshGuard {
  private down = false;
  private pending = 0;

  constructor(
    element: HTMLElement,
    private readonly refresh: () => void,
  ) {
    element.addEventListener("pointerdown", () => (this.down = true));
    for (const end of ["pointerup", "pointercancel"]) {
      document.addEventListener(end, () => {
        this.down = false;
        setTimeout(() => this.settle());
      });
    }
  }

  /** Whether the panel must not be drawn again now. */
  get busy(): boolean {
    return this.down || this.pending > 0;
  }

  /** Wait for an answer. */
  async during(answer: Promise<unknown>): Promise<void> {
    this.pending++;
    try {
      await answer;
    } finally {
      this.pending--;
      this.settle();
    }
  }

  private settle(): void {
    if (!this.busy) this.refresh();
  }
}
