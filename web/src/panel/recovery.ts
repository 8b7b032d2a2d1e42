// What is done when the server refuses or does not answer: says so, asks for a
// token, or waits until the server is back or less busy; and then asks the
// question again.

import type { Connection } from "../service/connection";
import { explain, kindOf, retryAfter } from "../service/errors";
import type { Notice } from "./notice";
import { TokenDialog } from "./token_dialog";

const FIRST_PAUSE_MS = 500;
const LONGEST_PAUSE_MS = 5000;
/** A server that is full is asked again after what it says, and no sooner than this. */
const FULL_PAUSE_MS = 250;
/** Nobody waits longer for that without being told the reason. */
const LONGEST_FULL_MS = 10_000;

/** The server's words are for programs. */
const NO_TOKEN = "Whoever runs this server gives tokens to those who may ask it.";

export class Recovery {
  /** What is asked again when the server is back, or knows the token. */
  private readonly questions = new Set<() => void>();
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

  /**
   * Does the work, again and again if something can be done about its errors.
   * What is refused is told of `name`, the file that it is about.
   */
  async attempt(work: () => Promise<void>, name?: string): Promise<void> {
    try {
      await work();
    } catch (error) {
      const kind = kindOf(error);
      const about = name ? `${name}: ` : "";
      // Who is told that a file has no room knows when to send it again.
      if (kind === "full" || kind === "refused") this.notice.error(about + explain(error));
      else this.handle(error, () => void this.attempt(work, name));
    }
  }

  /** The same function `again` is called once, for however many errors. */
  handle(error: unknown, again: () => void): void {
    switch (kindOf(error)) {
      case "cancelled":
        return;
      case "token":
        this.questions.add(again);
        this.askForToken(this.connection.token ? explain(error) : NO_TOKEN);
        return;
      case "gone":
        this.questions.add(again);
        void this.waitForServer();
        return;
      case "forgotten":
        this.notice.error(`${explain(error)} Drop its file here again.`);
        return;
      case "full":
        this.waitForRoom(error, again);
        return;
      default:
        this.notice.error(explain(error));
    }
  }

  // By itself once only: who gave none is shown where to give one.
  private askForToken(reason: string): void {
    const open = () => this.dialog.open(reason);
    this.notice.error(reason, { label: "Enter a token", run: open });
    if (!this.dialog.wasDeclined) open();
  }

  private waitForRoom(error: unknown, again: () => void): void {
    const pause = Math.max(retryAfter(error) ?? 0, FULL_PAUSE_MS);
    if (pause > LONGEST_FULL_MS) {
      this.notice.error(explain(error));
      return;
    }
    this.notice.hint("The server has much to do. This page asks again.", 2 * pause);
    setTimeout(again, pause);
  }

  private async waitForServer(): Promise<void> {
    // Said again of what is asked meanwhile, such as a file that was dropped.
    this.notice.error("The server does not answer. This page goes on when it is back.");
    if (this.waiting) return;
    this.waiting = true;
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
    const questions = [...this.questions];
    this.questions.clear();
    this.notice.clear();
    for (const again of questions) again();
  }
}
