/** Values that others may watch. */

export class Signal<T> {
  private readonly watchers = new Set<(value: T) => void>();

  /** Call a function with every value from now on. */
  watch(watcher: (value: T) => void): void {
    this.watchers.add(watcher);
  }

  /** Call it no more. */
  leave(watcher: (value: T) => void): void {
    this.watchers.delete(watcher);
  }

  send(value: T): void {
    for (const watcher of [...this.watchers]) watcher(value);
  }
}
