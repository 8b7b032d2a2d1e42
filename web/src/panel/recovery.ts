// What is done when the server refuses or does not answer: says so, asks for a
// token, waits until the server is back, or uploads the mesh again; and then
// asks the question again.

import type { Connection } from "../service/connection";
import { explain, kindOf } from "../service/errors";
import type { Notice } from "./notice";
import { TokenDialog } from "./token_dialog";

const FIRST_PAUSE_MS = 500;
const LONGEST_PAUSE_MS = 5000;

export class Recovery {
  private again: (() => void) | undefined;
  private waiting = false;
  private readonly dialog: TokenDialog;

  constructor(
    private readonly connection: Connection,
    private readonly notice: Notice,
    keepToken: (token: string) => void,
  ) {
    this.dialog = new TokenDialog((token) => {
      keepToken(token);
      this.goOnWith(token);
    });
  }

  /** Shows this token from now on, and asks again what was refused without it. */
  goOnWith(token: string): void {
    this.connection.token = token;
    this.dialog.close();
    this.resume();
  }

  /** Does the work, again and again if something can be done about its errors. */
  async attempt(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.handle(error, () => void this.attempt(work));
    }
  }

  /** `upload` brings back a mesh that the server has forgotten. */
  handle(error: unknown, again: () => void, upload?: () => Promise<void>): void {
    switch (kindOf(error)) {
      case "cancelled":
        return;
      case "token":
        this.again = again;
        this.notice.error(explain(error));
        this.dialog.open(explain(error));
        return;
      case "gone":
        this.again = again;
        void this.waitForServer();
        return;
      case "forgotten":
        if (upload) {
          void this.attempt(() => upload().then(again));
          return;
        }
        this.notice.error(`${explain(error)} Open its file again.`);
        return;
      default:
        this.notice.error(explain(error));
    }
  }

  private async waitForServer(): Promise<void> {
    if (this.waiting) return;
    this.waiting = true;
    this.notice.error("The server does not answer. This page goes on when it is back.");
    for (let pause = FIRST_PAUSE_MS; ; pause = Math.min(2 * pause, LONGEST_PAUSE_MS)) {
      await new Promise((resolve) => setTimeout(resolve, pause));
      try {
        await this.connection.capabilities.getCapabilities({});
        break;
      } catch (error) {
        if (kindOf(error) !== "gone") break;
      }
    }
    this.waiting = false;
    this.notice.hint("The server is back.", 2000);
    this.resume();
  }

  private resume(): void {
    const again = this.again;
    this.again = undefined;
    this.notice.clear();
    again?.();
  }
}
