/** Where the scene is looked at from: usual places that fit the field into the view, turning, coming nearer. */

import * as THREE from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LOOK } from "../core/view";
import { type Point, distanceFor, fitted, halfHeightFor } from "./fitted";
import { narrowness } from "./narrow";

export type Viewpoint = "oblique" | "top" | "side";

/** Angles (degrees) that the oblique view may take in from bottom to top. */
export const ANGLES = { least: 8, most: 70 };
const TILT = { oblique: 25, top: 90, side: 0 };
/** Degrees by which the oblique view is steeper in a view of no width, and in part in a narrow one, whose height it fills so. */
const STEEPER = 35;
const HEADING = 22;
/** Fields this much longer than wide are looked at across their long side. */
const LONG = 1.7;
const FAR = 1500;
/** Angles (radians) of a turn at which it is seen whether the field is in view. */
const SAMPLED = Math.PI / 60;
/** Where the plain ends in mist, of the half view above its middle. */
const SKYLINE = 0.66;
/** Milliseconds in which a drag's glide loses all but a third, and after which it has ended, however few pictures are drawn. */
const FADING = 80;
const GLIDE = 350;
/** Degrees a second of the slow turn, and seconds without a touch before it begins. */
const TURN = 1.6;
const IDLE = 12;

/** Where one looks from, in units of the scene. */
export interface Standpoint {
  viewpoint: Viewpoint;
  position: number[];
  target: number[];
  /** Magnification of the parallel views. */
  zoom: number;
}

export class Camera {
  readonly perspective = new THREE.PerspectiveCamera(LOOK.fieldOfView, 1, 0.05, FAR);
  readonly parallel = new THREE.OrthographicCamera(-1, 1, 1, -1, -FAR, FAR);
  readonly controls: OrbitControls;
  /** Called when the camera has moved. */
  onMoved: () => void = () => {};
  /** Whether the camera may turn slowly by itself. */
  mayTurn: () => boolean = () => false;
  private viewpoint: Viewpoint = "oblique";
  private box = new THREE.Box3(new THREE.Vector3(-5, 0, -5), new THREE.Vector3(5, 1, 5));
  private aspect = 1;
  private touched = false;
  /** Whether a button or finger is down on the scene, which alone moves nothing. */
  private held = false;
  private lastTouch = performance.now();
  /** When the last button or finger was lifted, and when the camera was moved on last. */
  private lifted = performance.now();
  private lastUpdate = performance.now();
  /** How far (radians) the slow turn has led from the usual place. */
  private turned = 0;

  constructor(canvas: HTMLCanvasElement) {
    this.controls = new OrbitControls(this.perspective, canvas);
    this.controls.enableDamping = true;
    this.controls.maxPolarAngle = Math.PI / 2 - 0.005;
    this.controls.minDistance = 1;
    this.controls.maxDistance = 120;
    this.controls.minZoom = 0.3;
    this.controls.maxZoom = 40;
    this.controls.addEventListener("change", () => {
      if (this.held) this.touch();
      this.onMoved();
    });
    this.controls.addEventListener("start", () => this.hold(true));
    this.controls.addEventListener("end", () => this.hold(false));
    canvas.addEventListener("pointermove", () => (this.lastTouch = performance.now()));
  }

  get active(): THREE.PerspectiveCamera | THREE.OrthographicCamera {
    return this.viewpoint === "oblique" ? this.perspective : this.parallel;
  }

  get isParallel(): boolean {
    return this.viewpoint !== "oblique";
  }

  /** Take in an angle (degrees) from bottom to top; the field stays as large in the view. */
  open(asked: number): void {
    const angle = Math.min(Math.max(asked, ANGLES.least), ANGLES.most);
    if (angle === this.perspective.fov) return;
    const nearer = Math.tan((this.perspective.fov * Math.PI) / 360) / Math.tan((angle * Math.PI) / 360);
    this.perspective.fov = angle;
    if (!this.touched) return this.fit();
    const offset = this.perspective.position.clone().sub(this.controls.target).multiplyScalar(nearer);
    this.perspective.position.copy(this.controls.target).add(offset);
    this.setAspect();
    this.controls.update();
    this.onMoved();
  }

  /** Look from one of the usual places, so that the whole field is in view. */
  look(from: Viewpoint): void {
    this.settle();
    this.viewpoint = from;
    this.touched = false;
    this.turned = 0;
    this.lastTouch = performance.now();
    this.fit();
  }

  /** Keep the whole field in view again, seen as it is seen now: obliquely, from above or from the side. */
  fitAgain(): void {
    this.look(this.viewpoint);
  }

  /** Whether the whole field is kept in view, as nobody has moved the camera. */
  get fits(): boolean {
    return !this.touched;
  }

  standpoint(): Standpoint {
    return { viewpoint: this.viewpoint, position: this.active.position.toArray(), target: this.controls.target.toArray(), zoom: this.parallel.zoom };
  }

  /** Look from where one has looked before; what is no such place counts as the usual view. */
  stand({ viewpoint, position = [], target = [], zoom = 1 }: Partial<Standpoint>): void {
    this.look(viewpoint !== undefined && viewpoint in TILT ? viewpoint : "oblique");
    if (![...position, ...target, zoom].every(Number.isFinite) || position.length + target.length !== 6) return;
    this.touched = true;
    this.active.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.parallel.zoom = zoom;
    this.setAspect();
    this.controls.update();
    this.onMoved();
  }

  /** Keep a box (of the scene) in a view of this aspect, as long as nobody has moved the camera. */
  frame(box: THREE.Box3, aspect: number): void {
    const changed = !box.equals(this.box) || aspect !== this.aspect;
    this.box = box.clone();
    this.aspect = aspect;
    if (changed && !this.touched) this.fit();
    else this.setAspect();
  }

  /** Turn and tilt by angles (radians), and come nearer by a factor. */
  turn(around: number, up: number, nearer = 1): void {
    this.touch();
    const offset = this.active.position.clone().sub(this.controls.target);
    const sphere = new THREE.Spherical().setFromVector3(offset);
    sphere.theta += around;
    sphere.phi = Math.min(Math.max(sphere.phi + up, 0.001), this.controls.maxPolarAngle);
    if (this.isParallel) this.parallel.zoom = Math.min(Math.max(this.parallel.zoom / nearer, this.controls.minZoom), this.controls.maxZoom);
    else sphere.radius = Math.min(Math.max(sphere.radius * nearer, this.controls.minDistance), this.controls.maxDistance);
    this.active.position.setFromSpherical(sphere).add(this.controls.target);
    this.active.updateProjectionMatrix();
    this.controls.update();
    this.onMoved();
  }

  /** Move away, where the whole field is in view or nobody has moved the camera, so that it stays so in pictures of an aspect while the camera turns around by an angle (radians). */
  keepWhole(around: number, aspect: number): void {
    const { target } = this.controls;
    const offset = this.active.position.clone().sub(target);
    const turned = (angle: number) => this.seen(offset.clone().normalize().applyAxisAngle(new THREE.Vector3(0, 1, 0), angle), target).points;
    const count = Math.ceil(Math.abs(around) / SAMPLED);
    const points = Array.from({ length: count + 1 }, (_, at) => turned((around * at) / Math.max(count, 1))).flat();
    const { fov } = this.perspective;
    const half = this.parallel.top / this.parallel.zoom;
    const seen = this.isParallel ? halfHeightFor(turned(0), this.aspect, 1) <= half : distanceFor(turned(0), this.aspect, fov, 1) <= offset.length();
    if (this.touched && !seen) return;
    this.touch();
    if (this.isParallel) this.parallel.zoom = this.parallel.top / Math.max(half, halfHeightFor(points, aspect));
    else this.active.position.copy(target).addScaledVector(offset.normalize(), Math.max(offset.length(), distanceFor(points, aspect, fov)));
    this.setAspect();
    this.controls.update();
    this.onMoved();
  }

  /** To be called before each picture. */
  update(): void {
    const now = performance.now();
    const idle = !this.isParallel && this.mayTurn() && now - this.lastTouch > 1000 * IDLE;
    const ended = !this.held && now - this.lifted > GLIDE;
    this.controls.dampingFactor = ended ? 1 : 1 - Math.exp((this.lastUpdate - now) / FADING);
    this.lastUpdate = now;
    this.controls.autoRotate = idle;
    this.controls.autoRotateSpeed = TURN / 6;
    const before = this.controls.getAzimuthalAngle();
    this.controls.update(idle ? 1 / 60 : null);
    if (idle) this.turned += this.controls.getAzimuthalAngle() - before;
  }

  /** Let a glide end at once, and the slow turn; that begins after a while. */
  settle(): void {
    this.lastTouch = performance.now();
    this.controls.autoRotate = false;
    this.controls.dampingFactor = 1;
    this.controls.update();
  }

  /** Units of the scene that a pixel covers where the camera looks, in a view of this height. */
  unitsPerPixel(height: number): number {
    if (this.isParallel) return (this.parallel.top - this.parallel.bottom) / this.parallel.zoom / height;
    const distance = this.perspective.position.distanceTo(this.controls.target);
    return (2 * distance * Math.tan((this.perspective.fov * Math.PI) / 360)) / height;
  }

  /** Direction the camera looks at, clockwise from north (radians). */
  heading(): number {
    const ahead = new THREE.Vector3();
    this.active.getWorldDirection(ahead);
    const up = new THREE.Vector3(0, 1, 0).applyQuaternion(this.active.quaternion);
    return Math.hypot(ahead.x, ahead.z) > 0.02 ? Math.atan2(ahead.x, -ahead.z) : Math.atan2(up.x, -up.z);
  }

  /**
   * Elevation (the height of a unit vector) at which the plain should meet the sky.
   *
   * That of the true horizon where it is in view; otherwise a little below the view's upper edge, so that there is air
   * above the field.
   */
  level(): number {
    if (this.isParallel) return 0;
    const ahead = this.perspective.getWorldDirection(new THREE.Vector3());
    const edge = Math.asin(ahead.y) + SKYLINE * (this.perspective.fov / 2) * (Math.PI / 180);
    return Math.sin(Math.min(edge, 0));
  }

  private hold(held: boolean): void {
    this.held = held;
    if (!held) this.lifted = performance.now();
    this.lastTouch = performance.now();
  }

  private touch(): void {
    this.touched = true;
    this.lastTouch = performance.now();
  }

  private fit(): void {
    const back = this.usualBack();
    const middle = this.box.getCenter(new THREE.Vector3());
    const { right, up, points } = this.seen(back, middle);
    if (this.isParallel) this.fitParallel(points);
    const place = this.isParallel ? { across: 0, up: 0, distance: 60 } : fitted(points, this.aspect, this.perspective.fov);
    const target = middle.addScaledVector(right, place.across).addScaledVector(up, place.up);
    this.controls.object = this.active;
    this.controls.target.copy(target);
    this.active.position.copy(target).addScaledVector(back, place.distance);
    this.active.up.set(0, 1, 0);
    this.setAspect();
    this.controls.update();
    this.onMoved();
  }

  /** Where the camera stands in one of the usual places, seen from what it looks at. */
  private usualBack(): THREE.Vector3 {
    const size = this.box.getSize(new THREE.Vector3());
    const across = this.viewpoint !== "top" && size.z > LONG * size.x ? 90 : 0;
    const heading = ((this.viewpoint === "oblique" ? HEADING : 0) + across) * (Math.PI / 180) - this.turned;
    const steeper = this.isParallel ? 0 : STEEPER * (1 - narrowness(this.aspect));
    const tilt = Math.min(((TILT[this.viewpoint] + steeper) * Math.PI) / 180, Math.PI / 2 - 1e-4);
    return new THREE.Vector3(-Math.sin(heading) * Math.cos(tilt), Math.sin(tilt), Math.cos(heading) * Math.cos(tilt));
  }

  /** The corners of the field as a camera behind a place sees them: to the right, up and ahead of that place. */
  private seen(back: THREE.Vector3, place: THREE.Vector3): { right: THREE.Vector3; up: THREE.Vector3; points: Point[] } {
    const right = new THREE.Vector3(0, 1, 0).cross(back).normalize();
    const up = back.clone().cross(right);
    const { min, max } = this.box;
    const corners = [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new THREE.Vector3(x, y, z).sub(place))));
    return { right, up, points: corners.map((corner) => [corner.dot(right), corner.dot(up), -corner.dot(back)] as const) };
  }

  private fitParallel(points: Point[]): void {
    const high = halfHeightFor(points, this.aspect);
    this.parallel.top = high;
    this.parallel.bottom = -high;
    this.parallel.zoom = 1;
  }

  private setAspect(): void {
    this.perspective.aspect = this.aspect;
    this.perspective.updateProjectionMatrix();
    this.parallel.right = this.parallel.top * this.aspect;
    this.parallel.left = -this.parallel.right;
    this.parallel.updateProjectionMatrix();
  }
}
