/** One run's surface in the scene. */

import * as THREE from "three";
import type { App } from "../core/app";
import { ends } from "../core/profile";
import type { Description } from "../core/protocol";
import type { Run } from "../core/run";
import { grid, skirt } from "./block";
import { type Colouring, colouring } from "./colouring";
import { textureOf } from "./draped";
import { steepness, usualExaggeration } from "./exaggeration";
import type { LightUniforms } from "./light";
import { RIPPLE_CELL, TINTS, lookOf, smoothingOf } from "./looks";
import { PathLines } from "./paths";
import { Plants } from "./plants";
import { FULL, PLAIN, Relief } from "./relief";
import { SURFACE_FRAGMENT, SURFACE_VERTEX, WALL_FRAGMENT } from "./shaders/surface";
import { settled } from "./smooth";
import { FieldTextures, mapTexture } from "./textures";
import { terrainUniforms } from "./uniforms";

/** Longest side of a field in the scene. */
export const SIZE = 10;
/** Most cells of the mesh along a side, drawn fully and plainly. */
const FINEST = { full: 512, plain: 192 };
/** Thickness of the block below the ground, of the field's longer side. */
const FOOT = 0.03;

export class Terrain {
  readonly group = new THREE.Group();
  colouring: Colouring | null = null;
  /** The surface as it is drawn (m), smoothed where the look says so. */
  drawn: Float32Array = new Float32Array(0);
  base = 0;
  exaggeration = 1;
  scale = 1;
  extent: [number, number] = [1, 1];
  /** Direction of the wind (degrees) when the run began, by which the sun stands. */
  firstWind: number | null = null;
  readonly uniforms: Record<string, THREE.IUniform>;
  /** The exaggeration that suits the forms. */
  usual = Number.POSITIVE_INFINITY;
  /** The smoothing with which it is drawn, and for which `usual` was chosen. */
  private smoothing = -1;
  private lastStep = -1;
  /** The scenario (as a text) whose first wind was noted last, and its description. */
  private described: Description | null = null;
  private scenario = "";
  private readonly paths: PathLines;
  private readonly plants: Plants;
  private readonly relief: Relief;
  private readonly top: THREE.ShaderMaterial;
  private readonly side: THREE.ShaderMaterial;
  private textures: FieldTextures | null = null;
  /** The lattice that it is drawn of, and that with the fineness of the mesh. */
  private lattice = "";
  private mesh = "";
  private ground: Float32Array = new Float32Array(0);
  private groundKey: [Float32Array | null, number] = [null, 0];
  private map = "";

  constructor(
    private readonly app: App,
    light: LightUniforms,
    private readonly linear: boolean,
    host: Element,
    private readonly winds: Map<string, number>,
  ) {
    this.paths = new PathLines(host);
    this.uniforms = { ...terrainUniforms(), ...light };
    this.uniforms.tints!.value = TINTS.map((tint) => new THREE.Vector3(...tint));
    const { uniforms } = this;
    this.top = new THREE.ShaderMaterial({ vertexShader: SURFACE_VERTEX, fragmentShader: SURFACE_FRAGMENT, uniforms });
    this.side = new THREE.ShaderMaterial({ vertexShader: SURFACE_VERTEX, fragmentShader: WALL_FRAGMENT, uniforms, side: THREE.DoubleSide });
    this.plants = new Plants(uniforms);
    this.relief = new Relief(uniforms);
    uniforms.relief!.value = this.relief.target.texture;
  }

  /** Take the surface of a run as it is to be drawn, and which exaggeration suits it; to be called before `update`. */
  settle(run: Run, plain: boolean): void {
    this.reshape(run, plain);
    const smoothing = smoothingOf(run.material, this.app.view.look.smoothing);
    if (smoothing !== this.smoothing) this.usual = Number.POSITIVE_INFINITY;
    this.smoothing = smoothing;
    this.drawn = settled(run.surface, run.rows, run.columns, smoothing, run.description!.lattice.thickness, run.description!.lattice.periodic);
    if (!run.painted || !Number.isFinite(this.usual)) this.usual = this.usualExaggeration(run);
  }

  /** Whether it is drawn at another exaggeration than the one chosen, or else `usual`. */
  differsFrom(usual: number): boolean {
    return this.exaggeration !== (this.app.view.look.exaggeration ?? usual);
  }

  /** Show a run as it is now, `usual` times as steep unless that is chosen. */
  update(run: Run, renderer: THREE.WebGLRenderer, plain: boolean, usual: number): void {
    const { look } = this.app.view;
    this.exaggeration = look.exaggeration ?? usual;
    this.fillHeights(run);
    this.colouring = colouring(this.app, run);
    this.textures!.fillValues(this.colouring.values);
    const layers = this.textures!.fillOverlay(run, look.overlays);
    this.plants.mesh.visible = layers > 0 && this.colouring.natural;
    this.fillMap(this.colouring.map);
    this.set(run, plain);
    this.relief.render(renderer, run.columns, run.rows, plain ? PLAIN : FULL);
    this.paths.update(run, this, this.exaggeration);
  }

  /** Give back what the graphics card holds. */
  dispose(): void {
    this.textures?.dispose();
    this.relief.dispose();
    this.paths.dispose();
    this.uniforms.map!.value?.dispose();
    for (const part of [...this.group.children, this.plants.mesh]) if (part instanceof THREE.Mesh) part.geometry.dispose();
    for (const material of [this.top, this.side, this.plants.mesh.material]) material.dispose();
  }

  /** Height in the scene of a height of the run. */
  inScene(height: number): number {
    return (height - this.base) * this.exaggeration * this.scale;
  }

  /** Where in the scene a place (shares of the field) of the drawn surface is, `lift` above it. */
  at(x: number, y: number, rows: number, columns: number, lift = 0): [number, number, number] {
    const c = Math.min(Math.max(x * columns - 0.5, 0), columns - 1);
    const r = Math.min(Math.max(y * rows - 0.5, 0), rows - 1);
    const [c0, r0] = [Math.min(Math.floor(c), Math.max(columns - 2, 0)), Math.min(Math.floor(r), Math.max(rows - 2, 0))];
    const [c1, r1] = [Math.min(c0 + 1, columns - 1), Math.min(r0 + 1, rows - 1)];
    const value = (row: number) => this.drawn[row * columns + c0]! * (1 - c + c0) + this.drawn[row * columns + c1]! * (c - c0);
    const height = value(r0) * (1 - r + r0) + value(r1) * (r - r0);
    const [width, depth] = this.extent;
    return [(x - 0.5) * width * this.scale, this.inScene(height) + lift, (0.5 - y) * depth * this.scale];
  }

  /** The box that the block fills in the scene. */
  box(): THREE.Box3 {
    const [width, depth] = this.extent.map((length) => (length * this.scale) / 2) as [number, number];
    const high = this.drawn.length ? this.inScene(ends(this.drawn)[1]) : 0;
    return new THREE.Box3(new THREE.Vector3(-width, 0, -depth), new THREE.Vector3(width, high, depth));
  }

  /** Half the block's width and depth, and the mean height of its southern wall, in the scene. */
  block(columns: number): [number, number, number] {
    let sum = 0;
    for (let c = 0; c < columns; c++) sum += this.drawn[c] ?? 0;
    const [width, depth] = this.extent;
    return [(width * this.scale) / 2, (depth * this.scale) / 2, this.inScene(sum / Math.max(columns, 1))];
  }

  /** Note where the wind comes from when a run begins; to be called before `update`. */
  begin(run: Run): void {
    const { step, wind } = run.status!;
    if (step < this.lastStep) {
      this.forget();
      run.painted = false;
    }
    if (this.described !== run.description) {
      this.described = run.description;
      this.scenario = JSON.stringify(run.description!.scenario);
    }
    const one = `${this.app.runs.length} ${this.scenario}`; // a run that is compared is another one than that before it
    this.firstWind ??= (step > 0 ? this.winds.get(one) : undefined) ?? wind;
    this.winds.set(one, this.firstWind);
    this.lastStep = step;
  }

  /** Choose sun and exaggeration anew. */
  forget(): void {
    this.firstWind = null;
    this.usual = Number.POSITIVE_INFINITY;
  }

  private set(run: Run, plain: boolean): void {
    const { lattice, scenario } = run.description!;
    const look = this.app.view.look;
    const material = lookOf(run.material, look.sand);
    const { uniforms } = this;
    const steady = (scenario.wind as { kind?: string } | null)?.kind === "steady";
    const wind = ((steady ? run.status!.wind : this.firstWind!) * Math.PI) / 180;
    const numbers: Record<string, number> = {
      natural: Number(this.colouring!.natural),
      shaded: Number(look.shaded),
      bare: Number(look.bare && !this.colouring!.everywhere),
      thickness: lattice.thickness,
      contour: this.contour(),
      wire: Number(look.wireframe),
      shadows: Number(look.shadows),
      exaggeration: this.exaggeration,
      base: this.base,
      fine: Number(!plain),
      rounded: Number(this.smoothing > 0 && !plain),
      ripples: Number(material.ripples && lattice.cell_size >= RIPPLE_CELL),
      size: 0.85 * lattice.cell_size,
    };
    for (const [name, value] of Object.entries(numbers)) uniforms[name]!.value = value;
    const { image, opacity } = this.app.overlay;
    uniforms.opacity!.value = image && this.colouring!.natural ? opacity : 0; // it would cover what a field says
    uniforms.draped!.value = image && textureOf(image);
    uniforms.limits!.value.set(...this.colouring!.limits);
    uniforms.loose!.value.set(...material.light);
    uniforms.looseDark!.value.set(...material.dark);
    uniforms.blowing!.value.set(-Math.sin(wind), -Math.cos(wind));
  }

  private contour(): number {
    const { contours, interval, count } = this.app.view.look;
    if (contours === "off") return 0;
    if (contours === "interval") return Math.max(interval, 1e-6);
    const [low, high] = ends(this.drawn);
    return Math.max((high - low) / Math.max(count, 1), 1e-6);
  }

  private fillHeights(run: Run): void {
    const width = this.smoothing;
    const { periodic, thickness } = run.description!.lattice;
    if (this.groundKey[0] !== run.ground || this.groundKey[1] !== width) {
      this.ground = settled(run.ground, run.rows, run.columns, width, thickness, periodic);
      this.groundKey = [run.ground, width];
    }
    this.textures!.fillHeights(this.drawn, this.ground);
    this.cutFrom(ends(run.ground)[0], ends(this.drawn)[0]);
  }

  /** Never more than before as the forms grow, so that they are seen to grow. */
  private usualExaggeration(run: Run): number {
    const { cell_size, thickness } = run.description!.lattice;
    const [low, high] = ends(this.drawn);
    const steep = steepness(this.drawn, run.rows, run.columns, cell_size);
    return Math.min(this.usual, usualExaggeration(steep, high - low, thickness, Math.max(...this.extent)));
  }

  /** Where the block's foot is: below the ground, or within a deep layer, and as long there as it can be. */
  private cutFrom(ground: number, surface: number): void {
    const thick = Math.max(...this.extent) / this.exaggeration;
    const below = ground - FOOT * thick;
    const [least, most] = [surface - 2 * FOOT * thick, surface - 0.5 * FOOT * thick];
    if (below >= least) this.base = below;
    else if (!(this.base >= least && this.base <= most)) this.base = surface - 1.2 * FOOT * thick;
  }

  private fillMap(name: string): void {
    const colours = this.app.colours[name];
    if (!colours || (this.map === name && this.uniforms.map!.value)) return;
    this.map = name;
    this.uniforms.map!.value = mapTexture(colours);
  }

  private reshape(run: Run, plain: boolean): void {
    const { lattice } = run.description!;
    const shape = `${run.rows}x${run.columns}x${lattice.cell_size}`;
    if (`${shape}${plain}` === this.mesh) return;
    if (shape !== this.lattice) this.usual = Number.POSITIVE_INFINITY; // not for a picture that is drawn more finely than the page
    this.lattice = shape;
    this.mesh = `${shape}${plain}`;
    this.extent = [run.columns * lattice.cell_size, run.rows * lattice.cell_size];
    this.scale = SIZE / Math.max(...this.extent);
    this.textures?.dispose();
    this.textures = new FieldTextures(run.rows, run.columns, this.linear);
    const { uniforms } = this;
    uniforms.heights!.value = this.textures.heights;
    uniforms.values!.value = this.textures.values;
    uniforms.overlay!.value = this.textures.overlay;
    uniforms.cells!.value.set(run.columns, run.rows);
    uniforms.extent!.value.set(...this.extent);
    uniforms.scale!.value = this.scale;
    const finest = plain ? FINEST.plain : FINEST.full;
    const parts = (cells: number) => Math.min(plain ? cells - 1 : Math.max(cells - 1, Math.min(2 * cells, 256)), finest);
    const surface = new THREE.Mesh(grid(parts(run.columns), parts(run.rows)), this.top);
    const walls = new THREE.Mesh(skirt(parts(run.columns), parts(run.rows)), this.side);
    surface.frustumCulled = walls.frustumCulled = false;
    for (const old of this.group.children) if (old instanceof THREE.Mesh && old !== this.plants.mesh) old.geometry.dispose();
    this.group.clear();
    this.plants.sow(run.columns, run.rows);
    this.group.add(surface, walls, this.plants.mesh, this.paths.lines);
  }
}
