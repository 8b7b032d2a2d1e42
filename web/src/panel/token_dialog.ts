// Asks for the token that the server wants.

import { byId } from "./elements";

export class TokenDialog {
  private readonly dialog = byId<HTMLDialogElement>("token-dialog");
  private readonly input = byId<HTMLInputElement>("token");
  private declined = false;

  /** `entered` gets the token. */
  constructor(entered: (token: string) => void) {
    // Not when the dialog has closed, which browsers tell some time after: until
    // then work that begins would still show the old token.
    this.dialog.addEventListener("submit", (event) => {
      const isGiven = (event.submitter as HTMLButtonElement | null)?.value === "ok";
      if (isGiven && this.input.value) entered(this.input.value.trim());
      else this.declined = true;
    });
    this.dialog.addEventListener("cancel", () => (this.declined = true));
  }

  /** Whether it was closed without a token. */
  get wasDeclined(): boolean {
    return this.declined;
  }

  close(): void {
    this.declined = false;
    this.dialog.close();
  }

  open(reason: string): void {
    this.declined = false;
    byId("token-reason").textContent = reason;
    this.input.value = "";
    if (!this.dialog.open) this.dialog.showModal();
  }
}
