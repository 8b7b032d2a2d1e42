// Maps distance to colour as the pictures of the command `geodesic` do
// (client/picture/colormap.h): a path through OKLab whose lightness only rises,
// at constant speed, so that equal steps look equally large and keep their order
// in grey and for colour-blind eyes.

const WAYPOINTS = [
  // Lightness, chroma, hue in degrees.
  [0.36, 0.15, 298],
  [0.5, 0.125, 258],
  [0.65, 0.105, 200],
  [0.8, 0.165, 146],
  [0.94, 0.175, 106],
];

export const COLORMAP_SIZE = 256;

/** 256 colours, red green blue alpha, in sRGB bytes. */
export const COLORMAP = buildColormap();

// Colours of cells and differences: Okabe and Ito's, made to be told apart by
// colour-blind eyes, without black.
export const CELL_COLORS = [
  [230, 159, 0],
  [86, 180, 233],
  [0, 158, 115],
  [240, 228, 66],
  [0, 114, 178],
  [213, 94, 0],
  [204, 121, 167],
];

/** As CSS writes it; `share` is from 0 to 1. */
export function cssColor(share: number): string {
  const entry = 4 * Math.round(Math.min(Math.max(share, 0), 1) * (COLORMAP_SIZE - 1));
  return `rgb(${COLORMAP[entry]}, ${COLORMAP[entry + 1]}, ${COLORMAP[entry + 2]})`;
}

function buildColormap(): Uint8Array {
  const steps = 2048;
  const path = Array.from({ length: steps + 1 }, (_, i) => pathAt(i / steps));
  const walked = [0];
  for (let i = 1; i <= steps; i++) {
    walked.push(walked[i - 1] + Math.hypot(...path[i].map((value, k) => value - path[i - 1][k])));
  }
  const colors = new Uint8Array(4 * COLORMAP_SIZE);
  let step = 0;
  for (let entry = 0; entry < COLORMAP_SIZE; entry++) {
    const wanted = (walked[steps] * entry) / (COLORMAP_SIZE - 1);
    while (step < steps && walked[step] < wanted) step++;
    colors.set([...srgbFromOkLab(path[step]), 255], 4 * entry);
  }
  return colors;
}

// In OKLab.
function pathAt(t: number): number[] {
  const last = WAYPOINTS.length - 1;
  const segment = Math.min(Math.floor(t * last), last - 1);
  const s = t * last - segment;
  const at = (i: number) => WAYPOINTS[Math.min(Math.max(i, 0), last)];
  const [p0, p1, p2, p3] = [at(segment - 1), at(segment), at(segment + 1), at(segment + 2)];
  const [lightness, chroma, degrees] = p1.map((_, k) => spline(p0[k], p1[k], p2[k], p3[k], s));
  const hue = (degrees * Math.PI) / 180;
  return [lightness, chroma * Math.cos(hue), chroma * Math.sin(hue)];
}

// Catmull-Rom through p1 and p2.
function spline(p0: number, p1: number, p2: number, p3: number, t: number): number {
  return p1 + 0.5 * t * (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
}

function srgbFromOkLab([lightness, a, b]: number[]): number[] {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((linear) => {
    const x = Math.min(Math.max(linear, 0), 1);
    return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  });
}
