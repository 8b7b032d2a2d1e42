// The picture: the surface, drawn when it or the view changes, and over it the
// lines and dots, drawn as often as they change.
//
// The surface goes into a buffer of colours and depths. While a line follows
// the cursor, that buffer is copied and only the line is drawn anew: so it keeps
// up on meshes of any size and on machines without a graphics processor.

import {
  AlwaysDepth,
  Camera,
  Color,
  ColorManagement,
  DepthTexture,
  LinearSRGBColorSpace,
  Mesh,
  OrthographicCamera,
  PerspectiveCamera,
  PlaneGeometry,
  Scene as Graph,
  ShaderMaterial,
  UnsignedIntType,
  Vector2,
  Vector3,
  WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { SurfaceMesh } from "../surface/mesh";
import { Detail, isSavedWhole } from "./detail";
import { SurfaceMaterial } from "./surface_material";
import { firstView, type View } from "./view";

const COPY_VERTEX = /* glsl */ `
varying vec2 vUv;
void main() { vUv = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }`;

const COPY_FRAGMENT = /* glsl */ `
uniform sampler2D colors;
uniform sampler2D depths;
varying vec2 vUv;
void main() {
  gl_FragColor = vec4(texture2D(colors, vUv).rgb, 1.0);
  gl_FragDepth = texture2D(depths, vUv).r;
}`;

const FIELD_OF_VIEW_DEGREES = 32;
/** Of each pixel, where edges are smooth. */
const SAMPLES = 4;
/** Lines that are so far inside coarse faces are seen all the same. */
const COARSE_ERROR = 0.004;
/** Pictures that take longer are slow; after more time it was not the picture. */
const SLOW_FRAME_MS = 50;
const LONGEST_FRAME_MS = 2000;
/** For so many times as long as a slow picture took nothing is drawn, but no longer than this. */
const WAITING_SHARE = 3;
const LONGEST_PAUSE_MS = 600;
/** Said where no picture can be made. */
export const NO_WEBGL =
  "This browser cannot draw meshes: it has no WebGL 2. Turn its hardware acceleration on, or take another browser.";
/** Room around the mesh. */
const MARGIN = 1.08;

export class Scene {
  readonly material = new SurfaceMaterial();
  /** What is drawn over the surface: lines and dots. */
  readonly overlay = new Graph();
  readonly resolution = new Vector2(1, 1);
  /** Pixels of the picture in one of CSS, for shaders. */
  readonly pixelRatio = { value: 1 };
  /** The depth of the surface at each pixel, for shaders. */
  readonly depths: { value: DepthTexture | null } = { value: null };
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW_DEGREES);
  /** Called before a frame; returns whether the surface changes, and goes on. */
  onFrame: (milliseconds: number) => boolean = () => false;
  /** Whether the surface is about to change, even if it has not for a while. */
  isBusy: () => boolean = () => false;
  /** The surface was drawn, perhaps from elsewhere. */
  onSurface: () => void = () => undefined;
  /** What draws is gone, until it is restored. */
  onLost: () => void = () => undefined;
  onRestored: () => void = () => undefined;
  /** Whether somebody else, on the same machine perhaps, works on what comes next. */
  isWaiting: () => boolean = () => false;

  private readonly renderer: WebGLRenderer;
  private readonly background = new Color();
  private readonly controls: OrbitControls;
  private readonly surface = new Graph();
  private readonly copy = new Graph();
  private readonly copyMaterial: ShaderMaterial;
  private readonly screen: Camera = new OrthographicCamera();
  private fine: WebGLRenderTarget;
  private draft: WebGLRenderTarget;
  /** The one of these that the surface was drawn into. */
  private target: WebGLRenderTarget;
  private home: View | undefined;
  private mesh: SurfaceMesh | undefined;
  private drawn: Mesh | undefined;
  private readonly detail: Detail;
  private surfaceIsStale = true;
  private frame = 0;
  private lastFrame = 0;
  private pause: ReturnType<typeof setTimeout> | undefined;

  /** Throws if the browser has no WebGL 2. */
  constructor(private readonly canvas: HTMLCanvasElement) {
    // All colours here are those of the screen already.
    ColorManagement.enabled = false;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.detail = new Detail(rendererName(this.renderer.getContext()), () => {
      this.surfaceIsStale = true;
      this.redraw();
    });
    this.fine = this.target = newTarget(1, 1, SAMPLES);
    this.draft = newTarget(1, 1, 0);
    this.copyMaterial = new ShaderMaterial({
      vertexShader: COPY_VERTEX,
      fragmentShader: COPY_FRAGMENT,
      depthFunc: AlwaysDepth,
      uniforms: { colors: { value: null }, depths: { value: null } },
    });
    const sheet = new Mesh(new PlaneGeometry(2, 2), this.copyMaterial);
    sheet.frustumCulled = false;
    this.copy.add(sheet);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 12;
    this.controls.addEventListener("change", () => this.redrawSurface());
    canvas.addEventListener("webglcontextlost", () => this.onLost());
    // A graphics processor that was away comes back empty.
    canvas.addEventListener("webglcontextrestored", () => {
      this.renderer.setClearColor(this.background);
      this.redrawSurface();
      this.onRestored();
    });
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  /** How many faces the coarse list of a large mesh should have. */
  get coarseFaces(): number {
    return this.detail.coarseFaces;
  }

  /** Whether all faces are drawn when the picture is still. */
  mayBeWhole(mesh: SurfaceMesh): boolean {
    return this.detail.mayBeWhole(mesh);
  }

  show(mesh: SurfaceMesh): void {
    this.surface.clear();
    this.mesh = mesh;
    this.drawn = new Mesh(mesh.geometry, this.material);
    this.drawn.frustumCulled = false;
    this.surface.add(this.drawn);
    this.home = firstView(mesh.framed);
    this.camera.up.copy(this.home.up);
    this.lookAtAll();
  }

  /** Looks at the whole mesh, as at first. */
  lookAtAll(): void {
    if (!this.home) return;
    this.controls.target.set(0, 0, 0);
    const { direction, halfSize } = this.home;
    const half = Math.max(halfSize.x / this.camera.aspect, halfSize.y);
    // What is nearer looks larger: a third of the ball is a fair guess.
    const distance = (MARGIN * half) / Math.tan((FIELD_OF_VIEW_DEGREES * Math.PI) / 360) + 0.3;
    this.camera.position.copy(direction).multiplyScalar(distance);
    this.controls.update();
    this.redrawSurface();
  }

  /** Turns the view, in radians, or zooms it. */
  turn(right: number, up: number, zoom: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, right);
    const side = offset.clone().cross(this.camera.up).normalize();
    const raised = offset.clone().applyAxisAngle(side, up);
    if (Math.abs(raised.clone().normalize().dot(this.camera.up)) < 0.995) offset.copy(raised);
    this.camera.position.copy(this.controls.target).addScaledVector(offset, zoom);
    this.controls.update();
    this.redrawSurface();
  }

  setTurning(enabled: boolean): void {
    this.controls.enabled = enabled;
  }

  setBackground(color: string, dark: boolean): void {
    this.renderer.setClearColor(this.background.set(color));
    this.material.setDark(dark);
    this.redrawSurface();
  }

  /** From the pixels of a pointer event to what a ray is cast through. */
  pointerAt(clientX: number, clientY: number): Vector2 {
    const box = this.canvas.getBoundingClientRect();
    return new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
  }

  /** The pixel, from the left and top of the canvas, at which a point is drawn. */
  pixelOf(point: Vector3): Vector2 {
    const p = point.clone().project(this.camera);
    return new Vector2(((p.x + 1) / 2) * this.canvas.clientWidth, ((1 - p.y) / 2) * this.canvas.clientHeight);
  }

  redrawSurface(): void {
    this.detail.change();
    this.surfaceIsStale = true;
    this.redraw();
  }

  redraw(): void {
    if (this.pause && !this.isWaiting()) {
      clearTimeout(this.pause);
      this.pause = undefined;
    }
    if (this.frame || this.pause) return;
    this.frame = requestAnimationFrame((now) => {
      const took = now - this.lastFrame;
      this.frame = 0;
      this.lastFrame = now;
      // A browser without a graphics processor draws on those that also compute
      // what is waited for: more slow pictures would only keep that back.
      if (this.isWaiting() && took > SLOW_FRAME_MS && took < LONGEST_FRAME_MS) {
        this.pause = setTimeout(() => {
          this.pause = undefined;
          this.lastFrame = performance.now();
          this.redraw();
        }, Math.min(WAITING_SHARE * took, LONGEST_PAUSE_MS));
      }
      if (this.onFrame(now)) this.redrawSurface();
      this.draw();
    });
  }

  /** Draws at once. What changed since is then on the screen's next picture. */
  draw(): void {
    if (this.surfaceIsStale) this.drawSurface();
    this.copyMaterial.uniforms.colors.value = this.target.texture;
    this.copyMaterial.uniforms.depths.value = this.target.depthTexture;
    this.renderer.setRenderTarget(null);
    this.renderer.render(this.copy, this.screen);
    this.depths.value = this.target.depthTexture;
    this.renderer.render(this.overlay, this.camera);
  }

  /** A copy of what is drawn, as finely as can be. */
  takePicture(): HTMLCanvasElement {
    const copy = document.createElement("canvas");
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    this.detail.settle();
    // It stays on the screen until something changes.
    if (this.mesh) this.drawSurface(isSavedWhole(this.mesh));
    // The canvas keeps its content only until the screen has shown it.
    this.draw();
    copy.getContext("2d")?.drawImage(this.canvas, 0, 0);
    return copy;
  }

  private drawSurface(whole = false): void {
    const distance = this.camera.position.length();
    this.camera.near = Math.max(distance - 1.1, 0.004);
    this.camera.far = distance + 1.1;
    this.camera.updateProjectionMatrix();
    const coarse = this.mesh && !whole && this.detail.isCoarse(this.mesh) ? this.mesh.coarse : undefined;
    if (this.mesh && this.drawn) this.drawn.geometry = coarse ?? this.mesh.geometry;
    this.material.uniforms.setBack.value = coarse ? COARSE_ERROR : 0;
    this.target = this.detail.isDraft && !whole ? this.draft : this.fine;
    this.renderer.setRenderTarget(this.target);
    this.renderer.clear();
    this.renderer.render(this.surface, this.camera);
    this.surfaceIsStale = false;
    if (this.mesh) this.detail.drawn(this.mesh, this.isBusy());
    document.documentElement.dataset.detail = this.mesh ? this.detail.name(this.mesh) : "";
    this.onSurface();
  }

  private resize(): void {
    const width = Math.max(this.canvas.clientWidth, 1);
    const height = Math.max(this.canvas.clientHeight, 1);
    const ratio = Math.min(devicePixelRatio, 2);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.resolution.set(width, height);
    this.material.uniforms.lineWidth.value = ratio;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const target of [this.fine, this.draft]) {
      target.dispose();
      target.depthTexture?.dispose();
    }
    this.fine = this.target = newTarget(Math.round(width * ratio), Math.round(height * ratio), SAMPLES);
    this.draft = newTarget(this.fine.width, this.fine.height, 0);
    this.pixelRatio.value = ratio;
    this.surfaceIsStale = true;
    // Resizing has emptied the canvas.
    this.draw();
  }
}

function newTarget(width: number, height: number, samples: number): WebGLRenderTarget {
  return new WebGLRenderTarget(width, height, {
    samples,
    depthTexture: new DepthTexture(width, height, UnsignedIntType),
  });
}

// Of what draws, perhaps a program that stands in for a graphics processor.
function rendererName(context: WebGL2RenderingContext | WebGLRenderingContext): string {
  const names = context.getExtension("WEBGL_debug_renderer_info");
  return String(context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER));
}
