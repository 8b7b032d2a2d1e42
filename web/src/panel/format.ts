/** A number with `digits` digits, without the exponent where it can be read. */
export function formatNumber(value: number, digits = 6): string {
  if (value === Infinity) return "∞";
  const rounded = Number(value.toPrecision(digits));
  const size = Math.abs(rounded);
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return rounded.toExponential();
  return String(rounded);
}

export function formatCount(value: number): string {
  return value.toLocaleString("en");
}

/** "1 face", "2,000 faces", "no face". */
export function countText(count: number, noun: string): string {
  return count === 0 ? `no ${noun}` : count === 1 ? `1 ${noun}` : `${formatCount(count)} ${noun}s`;
}
