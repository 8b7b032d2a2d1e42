// Tells what happens and what went wrong, in one line over the picture.

import { byId } from "./elements";

export class Notice {
  private readonly element = byId("notice");
  private readonly text = byId("notice-text");
  private readonly bar = byId<HTMLProgressElement>("notice-progress");
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    byId("notice-close").addEventListener("click", () => this.clear());
  }

  /** `share` from 0 to 1 shows how far it is. */
  busy(text: string, share?: number): void {
    this.put(text, "busy");
    this.bar.hidden = share === undefined;
    if (share !== undefined) this.bar.value = share;
  }

  error(text: string): void {
    this.put(text, "error");
  }

  hint(text: string, milliseconds = 4000): void {
    this.put(text, "hint");
    this.timer = setTimeout(() => this.clear(), milliseconds);
  }

  clear(): void {
    this.element.hidden = true;
  }

  private put(text: string, kind: string): void {
    clearTimeout(this.timer);
    this.text.textContent = text;
    this.element.dataset.kind = kind;
    this.element.hidden = false;
    this.bar.hidden = true;
  }
}
