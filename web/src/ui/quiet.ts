/** Holds a panel still while one is at it: while the mouse is down in it, and until what was asked is answered. */

export class Quiet {
  private down = false;
  private asked = 0;

  constructor(
    element: HTMLElement,
    private readonly quiet: () => void,
  ) {
    element.addEventListener("pointerdown", () => (this.down = true));
    for (const end of ["pointerup", "pointercancel"]) {
      document.addEventListener(end, () => {
        this.down = false;
        setTimeout(() => this.settle());
      });
    }
  }

  /** Whether the panel must not be drawn anew now. */
  get busy(): boolean {
    return this.down || this.asked > 0;
  }

  /** Wait for an answer. */
  async during(answer: Promise<unknown>): Promise<void> {
    this.asked++;
    try {
      await answer;
    } finally {
      this.asked--;
      this.settle();
    }
  }

  private settle(): void {
    if (!this.busy) this.quiet();
  }
}
