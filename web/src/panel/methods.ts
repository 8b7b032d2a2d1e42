// The algorithms that the server has: which are exact, and which one is chosen.

import type { AlgorithmCapability, GetCapabilitiesResponse } from "../../generated/geodesic/v1/capabilities_service_pb";
import type { Algorithm } from "../../generated/geodesic/v1/query_pb";
import { byId } from "./elements";

const SERVERS_CHOICE = 0;

export class Methods {
  private readonly algorithm = byId<HTMLSelectElement>("algorithm");
  private readonly compared = byId<HTMLSelectElement>("against");
  private exact: AlgorithmCapability[] = [];
  private approximate: AlgorithmCapability[] = [];

  constructor(chosen: (algorithm: Algorithm) => void) {
    this.algorithm.addEventListener("change", () => chosen(Number(this.algorithm.value)));
  }

  show({ algorithms, approximateAlgorithms }: GetCapabilitiesResponse): void {
    this.exact = algorithms;
    this.approximate = approximateAlgorithms;
    const chosen = this.algorithm.value;
    this.algorithm.replaceChildren(new Option("the server's choice", String(SERVERS_CHOICE)), ...algorithms.map(choice));
    if (chosen) this.algorithm.value = chosen;
    this.compared.replaceChildren(choices("exact", algorithms), choices("approximate", approximateAlgorithms));
    const interesting = approximateAlgorithms[0] ?? algorithms[1];
    if (interesting) this.compared.value = String(interesting.algorithm);
    byId("compare-row").hidden = algorithms.length + approximateAlgorithms.length < 2;
  }

  /** What a field is to be compared with. */
  get against(): Algorithm {
    return Number(this.compared.value);
  }

  isApproximate(algorithm: Algorithm): boolean {
    return this.approximate.some((offered) => offered.algorithm === algorithm);
  }

  /** As the command spells it. The server's choice is its default among the exact ones. */
  nameOf(algorithm: Algorithm): string {
    const all = [...this.exact, ...this.approximate];
    const isIt = (offered: AlgorithmCapability) => offered.algorithm === algorithm || (algorithm === SERVERS_CHOICE && offered.isDefault);
    return all.find(isIt)?.name ?? "the server's choice";
  }
}

function choices(label: string, offered: AlgorithmCapability[]): HTMLOptGroupElement {
  const group = document.createElement("optgroup");
  group.label = label;
  group.hidden = offered.length === 0;
  group.append(...offered.map(choice));
  return group;
}

function choice({ algorithm, name, summary }: AlgorithmCapability): HTMLOptionElement {
  const option = new Option(name, String(algorithm));
  option.title = summary;
  return option;
}
