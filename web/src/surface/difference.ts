// How far two fields of the same sources are from each other.

export interface Difference {
  /** Of each vertex, as a share of the largest; 0 where either is infinite. */
  shares: Float32Array;
  largest: number;
  /** The mean of |a - b| / a over the vertices where both are known. */
  meanRelative: number;
}

export function differenceOf(a: Float64Array, b: Float64Array): Difference {
  const shares = new Float32Array(a.length);
  let largest = 0;
  let sum = 0;
  let count = 0;
  for (let v = 0; v < a.length; v++) {
    const difference = Math.abs(a[v] - b[v]);
    if (!Number.isFinite(difference)) continue;
    shares[v] = difference;
    largest = Math.max(largest, difference);
    if (a[v] > 0) {
      sum += difference / a[v];
      count++;
    }
  }
  if (largest > 0) for (let v = 0; v < shares.length; v++) shares[v] /= largest;
  return { shares, largest, meanRelative: sum / Math.max(count, 1) };
}
