// Which isolines are drawn: every `step`, and thicker where the scale has a
// label. The same choice as in the pictures of the command `geodesic`.

export interface IsolineScale {
  step: number;
  /** Every how many lines have a label. */
  perLabel: number;
}

export function chooseIsolines(largest: number): IsolineScale {
  if (!(largest > 0) || !Number.isFinite(largest)) return { step: 0, perLabel: 1 };
  const power = 10 ** Math.floor(Math.log10(largest));
  const leading = largest / power;
  if (leading < 2) return { step: power / 20, perLabel: 4 };
  if (leading < 4.5) return { step: power / 10, perLabel: 5 };
  return { step: power / 5, perLabel: 5 };
}

/** The labelled distances up to `largest`, as numbers and as text. */
export function scaleLabels(largest: number): { at: number; text: string }[] {
  const labels: { at: number; text: string }[] = [];
  const scale = chooseIsolines(largest);
  const step = scale.step * scale.perLabel;
  if (!(step > 0)) return labels;
  for (let i = 0; i * step <= largest * (1 + 1e-12); i++) {
    // Six digits are enough, and hide that 3 * 0.1 is not 0.3.
    labels.push({ at: i * step, text: String(Number((i * step).toPrecision(6))) });
  }
  return labels;
}
