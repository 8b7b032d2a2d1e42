// The list of the lines that were kept: shortest paths and those that run straight on.

import { isStraight, type SurfaceLine } from "../service/lines";
import { placeWords } from "../surface/place_words";
import { byId, term } from "./elements";
import { formatNumber } from "./format";

export class PathList {
  private readonly list = byId("paths");

  constructor(private readonly remove: (path: SurfaceLine) => void) {}

  show(paths: readonly SurfaceLine[]): void {
    byId("paths-section").hidden = paths.length === 0;
    this.list.replaceChildren(...paths.map((path) => this.item(path)));
  }

  private item(path: SurfaceLine): HTMLElement {
    const item = term("li", formatNumber(path.length, 10));
    const remove = document.createElement("button");
    remove.textContent = "×";
    remove.setAttribute("aria-label", `Remove this ${isStraight(path) ? "line" : "path"}`);
    remove.addEventListener("click", () => this.remove(path));
    item.append(remove, term("small", words(path)));
    return item;
  }
}

function words({ question, ended }: SurfaceLine): string {
  const from = `from ${placeWords(question.from)}`;
  if ("target" in question) return `${from} to ${placeWords(question.target)}`;
  switch (ended) {
    case "boundary":
      return `${from} straight on, up to the boundary`;
    case "singular":
      return `${from} straight on, up to where there is no straight on`;
    default:
      return `${from} straight on`;
  }
}
