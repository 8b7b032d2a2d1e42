// Draws the surface: colours and isolines from the distances at the vertices.
//
// Inside a face, d * d - |x - r|^2 is interpolated, r any fixed point, instead of
// d. Along an edge both agree between neighbours, and where one straight line
// leads from a source to all of a face, as near sources, that is the exact
// distance: isolines are then circles, however large the faces are. With r at a
// source nothing cancels near it. Near curves distances are linear, and there
// `quadratic` is off.

import { DataTexture, DoubleSide, LinearFilter, RGBAFormat, ShaderMaterial, Vector3, Color } from "three";
import { COLORMAP, COLORMAP_SIZE } from "./colormap";

const VERTEX = /* glsl */ `
attribute float geodesic;  // Below 0 where it is not known or no path leads.
attribute vec3 paint;
uniform vec3 reference;
uniform float setBack;
varying vec3 vPoint;
varying vec3 vView;
varying vec3 vNormal;
varying vec3 vPaint;
varying float vDistance;
varying float vSquare;
varying float vReached;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  float d = max(geodesic, 0.0);
  vPoint = position - reference;
  vView = view.xyz;
  vNormal = normalMatrix * normal;
  vPaint = paint;
  vDistance = d;
  vSquare = d * d - dot(vPoint, vPoint);
  vReached = geodesic < 0.0 ? 0.0 : 1.0;
  gl_Position = projectionMatrix * view;
  // Depths are those of a surface a little farther away.
  vec4 back = projectionMatrix * (view - vec4(0.0, 0.0, setBack, 0.0));
  gl_Position.z = back.z / back.w * gl_Position.w;
}`;

const FRAGMENT = /* glsl */ `
uniform sampler2D colors;
uniform bool quadratic;
uniform bool painted;
uniform float shade;
uniform bool showLines;
uniform float largest;
uniform float lineStep;
uniform float linesPerLabel;
uniform float lineWidth;
uniform float front;
uniform float glow;
uniform float radius;
uniform vec3 bare;
varying vec3 vPoint;
varying vec3 vView;
varying vec3 vNormal;
varying vec3 vPaint;
varying float vDistance;
varying float vSquare;
varying float vReached;

// Coverage by the lines at multiples of a step; t is the distance in steps.
float lines(float t, float perPixel, float width) {
  float off = abs(t - max(round(t), 1.0)) / perPixel;
  float inside = clamp(0.5 * width - off + 0.5, 0.0, 1.0);
  return inside * smoothstep(2.0 * width, 4.0 * width, 1.0 / perPixel);
}

void main() {
  vec3 flatNormal = normalize(cross(dFdx(vView), dFdy(vView)));
  vec3 smoothNormal = normalize(vNormal + 1e-6 * flatNormal);
  // Faces may be turned either way: what is seen is lit.
  if (dot(smoothNormal, flatNormal) < 0.0) smoothNormal = -smoothNormal;
  vec3 n = normalize(mix(flatNormal, smoothNormal,
                         smoothstep(0.75, 0.9, dot(smoothNormal, flatNormal))));
  float light = 0.58 + 0.42 * max(dot(n, normalize(vec3(-0.35, 0.5, 0.8))), 0.0)
      + 0.08 * max(dot(n, vec3(0.0, 0.0, 1.0)), 0.0);

  float d = vDistance;
  if (quadratic) d = sqrt(max(vSquare + dot(vPoint, vPoint), 0.0));
  float perPixel = max(fwidth(d), 1e-9);
  bool reached = vReached > 0.9999;
  vec3 color = bare;
  if (reached && d <= front && d <= radius) {
    float share = clamp(d / largest, 0.0, 1.0);
    color = texture2D(colors, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb;
    if (painted) color = vPaint * (1.0 - shade * share);
    if (showLines && lineStep > 0.0) {
      float t = d / lineStep;
      float coverage = max(0.7 * lines(t, perPixel / lineStep, lineWidth),
          lines(t / linesPerLabel, perPixel / (lineStep * linesPerLabel), 1.6 * lineWidth));
      float luminance = dot(color, vec3(0.299, 0.587, 0.114));
      vec3 ink = luminance > 0.36 ? color * 0.22 : mix(color, vec3(1.0), 0.62);
      color = mix(color, ink, coverage);
    }
    color = mix(color, vec3(1.0), glow * exp((d - front) / (0.025 * largest)));
  }
  if (reached && radius < 1e9 && abs(d - radius) < 1.2 * lineWidth * perPixel) color *= 0.35;
  gl_FragColor = vec4(color * light, 1.0);
}`;

/** Where no distance is known yet, beyond the radius, and where no path leads. */
const BARE = { light: new Color(0.74, 0.75, 0.77), dark: new Color(0.5, 0.51, 0.54) };

/** Distances are on the screen's scale. */
export class SurfaceMaterial extends ShaderMaterial {
  constructor() {
    const colors = new DataTexture(COLORMAP, COLORMAP_SIZE, 1, RGBAFormat);
    colors.minFilter = colors.magFilter = LinearFilter;
    colors.needsUpdate = true;
    super({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      // Lines lie on the surface, and must not sink into it.
      polygonOffset: true,
      polygonOffsetFactor: 1.5,
      polygonOffsetUnits: 8,
      uniforms: {
        colors: { value: colors },
        reference: { value: new Vector3() },
        setBack: { value: 0 },
        quadratic: { value: true },
        painted: { value: false },
        shade: { value: 0 },
        showLines: { value: true },
        largest: { value: 1 },
        lineStep: { value: 0 },
        linesPerLabel: { value: 5 },
        lineWidth: { value: 1 },
        front: { value: Infinity },
        glow: { value: 0 },
        radius: { value: 1e10 },
        bare: { value: BARE.light },
      },
    });
  }

  setDark(dark: boolean): void {
    this.uniforms.bare.value = dark ? BARE.dark : BARE.light;
  }
}
