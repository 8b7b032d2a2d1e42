// Asks for the token that the server wants.

import { byId } from "./elements";

export class TokenDialog {
  private readonly dialog = byId<HTMLDialogElement>("token-dialog");
  private readonly input = byId<HTMLInputElement>("token");

  /** `entered` gets the token; a dialog that is closed asks again later. */
  constructor(entered: (token: string) => void) {
    this.dialog.addEventListener("close", () => {
      if (this.dialog.returnValue === "ok" && this.input.value) entered(this.input.value.trim());
    });
  }

  open(reason: string): void {
    byId("token-reason").textContent = reason;
    this.input.value = "";
    this.dialog.returnValue = "";
    if (!this.dialog.open) this.dialog.showModal();
  }
}
