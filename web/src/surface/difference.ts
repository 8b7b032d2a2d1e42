// How far two fields of the same sources are from each other.

export interface Difference {
  /** |b - a| of each vertex as a share of the largest; NaN where one of them alone is known. */
  shares: Float32Array;
  largest: number;
  /** Between these b - a is. */
  range: [number, number];
  /** The mean of |b - a| / a over the vertices where both are known. */
  meanRelative: number;
  /** How many vertices have a distance in one of the fields only. */
  oneSided: number;
}

export function differenceOf(a: Float64Array, b: Float64Array): Difference {
  const shares = new Float32Array(a.length);
  const range: [number, number] = [0, 0];
  let sum = 0;
  let count = 0;
  let oneSided = 0;
  for (let v = 0; v < a.length; v++) {
    const difference = b[v] - a[v];
    if (!Number.isFinite(difference)) {
      if (a[v] === b[v]) continue; // Neither is known.
      oneSided++;
      shares[v] = NaN;
      continue;
    }
    shares[v] = Math.abs(difference);
    range[0] = Math.min(range[0], difference);
    range[1] = Math.max(range[1], difference);
    if (a[v] > 0) {
      sum += shares[v] / a[v];
      count++;
    }
  }
  const largest = Math.max(-range[0], range[1]);
  if (largest > 0) for (let v = 0; v < shares.length; v++) shares[v] /= largest;
  return { shares, largest, range, meanRelative: sum / Math.max(count, 1), oneSided };
}
