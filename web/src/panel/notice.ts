// Tells what happens and what went wrong, in one line over the picture.

import { byId } from "./elements";

/** What can be done about an error. */
export interface Action {
  label: string;
  run(): void;
}

/** For so long nothing that goes on takes an error away. */
const ERROR_STAYS_MS = 6000;

export class Notice {
  private readonly element = byId("notice");
  private readonly text = byId("notice-text");
  private readonly bar = byId<HTMLProgressElement>("notice-progress");
  private readonly button = byId<HTMLButtonElement>("notice-action");
  private errorStaysUntil = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    byId("notice-close").addEventListener("click", () => this.clear());
  }

  /** `share` from 0 to 1 shows how far it is. */
  busy(text: string, share?: number): void {
    if (performance.now() < this.errorStaysUntil) return;
    this.put(text, "busy");
    this.bar.hidden = share === undefined;
    if (share !== undefined) this.bar.value = share;
  }

  /** What was busy has ended. */
  done(): void {
    if (this.element.dataset.kind === "busy") this.clear();
  }

  error(text: string, action?: Action): void {
    this.errorStaysUntil = performance.now() + ERROR_STAYS_MS;
    this.put(text, "error");
    if (!action) return;
    this.button.textContent = action.label;
    this.button.onclick = () => action.run();
    this.button.hidden = false;
  }

  hint(text: string, milliseconds = 4000): void {
    this.put(text, "hint");
    this.timer = setTimeout(() => this.clear(), milliseconds);
  }

  clear(): void {
    this.errorStaysUntil = 0;
    this.element.hidden = true;
  }

  private put(text: string, kind: string): void {
    clearTimeout(this.timer);
    this.text.textContent = text;
    this.element.dataset.kind = kind;
    this.element.hidden = false;
    this.bar.hidden = true;
    this.button.hidden = true;
  }
}
