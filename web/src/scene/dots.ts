// Round marks of constant size on the surface: sources, samples, ends of paths.
// Those that something hides are faint rings.

import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";
import type { Scene } from "./scene";

// A dot is seen if its middle is, and then all of it.
const VERTEX = /* glsl */ `
attribute vec3 fill;
uniform sampler2D depths;
uniform float size;
uniform float pixelRatio;
varying vec3 vFill;
varying float vSeen;
const float kDepthError = 2e-3;
void main() {
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec3 screen = 0.5 * gl_Position.xyz / gl_Position.w + 0.5;
  vSeen = screen.z <= texture2D(depths, screen.xy).r + kDepthError ? 1.0 : 0.0;
  vFill = fill;
  gl_PointSize = size * pixelRatio;
}`;

const FRAGMENT = /* glsl */ `
uniform float size;
uniform float pixelRatio;
varying vec3 vFill;
varying float vSeen;
void main() {
  float r = length(2.0 * gl_PointCoord - 1.0);
  float soft = 2.5 / (size * pixelRatio);
  float disk = 1.0 - smoothstep(1.0 - soft, 1.0, r);
  float inner = 1.0 - smoothstep(0.66 - soft, 0.66, r);
  bool seen = vSeen > 0.5;
  float alpha = seen ? disk : 0.45 * (disk - inner);
  if (alpha < 0.02) discard;
  gl_FragColor = vec4(seen ? mix(vec3(0.06, 0.06, 0.09), vFill, inner) : vFill, alpha);
}`;

export interface Dot {
  point: ArrayLike<number>;
  /** Red, green and blue from 0 to 1. */
  fill: readonly number[];
}

export class Dots extends Points<BufferGeometry, ShaderMaterial> {
  /** `size` is the diameter in CSS pixels. */
  constructor(size: number, scene: Scene) {
    super(
      new BufferGeometry(),
      new ShaderMaterial({
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        transparent: true,
        depthTest: false,
        depthWrite: false,
        uniforms: { size: { value: size }, depths: scene.depths, pixelRatio: scene.pixelRatio },
      }),
    );
    this.frustumCulled = false;
    this.renderOrder = 20;
    this.visible = false;
  }

  setDots(dots: readonly Dot[]): void {
    this.geometry.dispose();
    this.geometry = new BufferGeometry();
    const points = new Float32Array(dots.flatMap((dot) => Array.from(dot.point)));
    const fills = new Float32Array(dots.flatMap((dot) => [...dot.fill]));
    this.geometry.setAttribute("position", new BufferAttribute(points, 3));
    this.geometry.setAttribute("fill", new BufferAttribute(fills, 3));
    this.visible = dots.length > 0;
  }
}
