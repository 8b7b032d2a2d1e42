// States that were left, to be gone back to, and those that were gone back from.

export class History<State> {
  private readonly past: State[] = [];
  private readonly future: State[] = [];
  private gesture: unknown;

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** `state` is left for a new one. Of changes in a row by one gesture the first counts. */
  record(state: State, gesture?: unknown): void {
    this.future.length = 0;
    if (gesture === undefined || gesture !== this.gesture) this.past.push(state);
    this.gesture = gesture;
  }

  /** Where to go back to from `now`; nothing if there is nothing before. */
  undo(now: State): State | undefined {
    return this.go(this.past, this.future, now);
  }

  redo(now: State): State | undefined {
    return this.go(this.future, this.past, now);
  }

  /** Where a gesture that made the last changes began; there never was one. */
  cancel(gesture: unknown): State | undefined {
    if (gesture === undefined || gesture !== this.gesture) return undefined;
    this.gesture = undefined;
    return this.past.pop();
  }

  clear(): void {
    this.past.length = this.future.length = 0;
    this.gesture = undefined;
  }

  private go(from: State[], to: State[], now: State): State | undefined {
    this.gesture = undefined;
    const state = from.pop();
    if (state !== undefined) to.push(now);
    return state;
  }
}
