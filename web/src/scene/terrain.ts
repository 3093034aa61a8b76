/** One run's surface in the scene. */

import * as THREE from "three";
import type { App } from "../core/app";
import { ends } from "../core/profile";
import type { Run } from "../core/run";
import { type Colouring, colouring } from "./colouring";
import { FRAGMENT, VERTEX } from "./shaders";
import { grid, skirt } from "./block";
import { PathLines } from "./paths";
import { smoothed } from "./smooth";

/** Longest side of a field in the scene. */
export const SIZE = 10;
const FINEST = 512;
/** Thickness of the block below the ground, of the field's longer side. */
const FOOT = 0.03;
/** Relief, as it is drawn, that heights are not exaggerated beyond unless one asks for it. */
const MOST_RELIEF = 0.2;
const TINTS = ["#4c8a3a", "#8aa83c", "#2f6b4f", "#7d7a2c"];
/** Own colours of materials; any other one is nearly white. */
const MATERIALS: Record<string, string> = { sand: "#dcb981" };
const OTHER = "#e8ebee";
const GROUND = new THREE.Color("#8f8a84");

export class Terrain {
  readonly group = new THREE.Group();
  colouring: Colouring | null = null;
  /** The surface as it is drawn (m), smoothed where the look says so. */
  drawn: Float32Array = new Float32Array(0);
  base = 0;
  exaggeration = 1;
  private usual = Number.POSITIVE_INFINITY;
  scale = 1;
  extent: [number, number] = [1, 1];
  private readonly paths = new PathLines();
  private readonly top: THREE.ShaderMaterial;
  private readonly side: THREE.ShaderMaterial;
  private heights: THREE.DataTexture | null = null;
  private values: THREE.DataTexture | null = null;
  private overlay: THREE.DataTexture | null = null;
  private shape = "";
  private ground: Float32Array = new Float32Array(0);
  private groundOf: Float32Array | null = null;
  private groundWidth = 0;
  private map = "";

  constructor(
    private readonly app: App,
    private readonly linear: boolean,
  ) {
    const uniforms = {
      heights: { value: null },
      values: { value: null },
      map: { value: null },
      overlay: { value: null },
      cells: { value: new THREE.Vector2(1, 1) },
      extent: { value: new THREE.Vector2(1, 1) },
      scale: { value: 1 },
      exaggeration: { value: 1 },
      base: { value: 0 },
      limits: { value: new THREE.Vector2(0, 1) },
      natural: { value: 1 },
      sun: { value: new THREE.Vector3(0, 1, 0) },
      shadows: { value: 1 },
      bare: { value: 1 },
      thickness: { value: 1 },
      contour: { value: 0 },
      wire: { value: 0 },
      tints: { value: TINTS.map((tint) => new THREE.Color(tint)) },
      section: { value: new THREE.Vector4(-2, 0, 0, 0) },
      brush: { value: new THREE.Vector3(0, 0, 0) },
      materialColour: { value: new THREE.Color(OTHER) },
      groundColour: { value: GROUND },
    };
    const material = (isWall: number) =>
      new THREE.ShaderMaterial({
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: { ...uniforms, isWall: { value: isWall } },
        side: isWall ? THREE.DoubleSide : THREE.FrontSide,
      });
    this.top = material(0);
    this.side = material(1);
  }

  get uniforms(): Record<string, THREE.IUniform> {
    return this.top.uniforms;
  }

  /** Show a run as it is now. */
  update(run: Run): void {
    const { lattice } = run.description!;
    const look = this.app.view.look;
    this.reshape(run);
    this.drawn = smoothed(run.surface, run.rows, run.columns, look.smoothing, lattice.periodic);
    this.exaggeration = look.exaggeration ?? this.usualExaggeration(run);
    this.fillHeights(run);
    this.colouring = colouring(this.app, run, this.drawn);
    (this.values!.image.data as Float32Array).set(this.colouring.values);
    this.values!.needsUpdate = true;
    this.fillOverlay(run);
    this.fillMap(this.colouring.map);
    const { uniforms } = this;
    uniforms.limits!.value.set(...this.colouring.limits);
    uniforms.materialColour!.value.set(MATERIALS[run.material] ?? OTHER);
    uniforms.natural!.value = this.colouring.natural ? 1 : 0;
    uniforms.bare!.value = look.bare && look.side === "surface" ? 1 : 0;
    uniforms.thickness!.value = lattice.thickness;
    uniforms.contour!.value = this.contour();
    uniforms.wire!.value = look.wireframe ? 1 : 0;
    uniforms.shadows!.value = look.shadows ? 1 : 0;
    uniforms.exaggeration!.value = this.exaggeration;
    uniforms.base!.value = this.base;
    uniforms.sun!.value.copy(sunAt(look.sunAzimuth, look.sunHeight));
    this.paths.update(run, this, this.exaggeration);
  }

  /** Height in the scene of a height of the run. */
  inScene(height: number): number {
    return (height - this.base) * this.exaggeration * this.scale;
  }

  private contour(): number {
    const { contours, interval, count } = this.app.view.look;
    if (contours === "off") return 0;
    if (contours === "interval") return Math.max(interval, 1e-6);
    const [low, high] = ends(this.drawn);
    return Math.max((high - low) / Math.max(count, 1), 1e-6);
  }

  private fillHeights(run: Run): void {
    const data = this.heights!.image.data as Float32Array;
    const width = this.app.view.look.smoothing;
    if (this.groundOf !== run.ground || this.groundWidth !== width) {
      const joined = run.description!.lattice.periodic;
      this.ground = smoothed(run.ground, run.rows, run.columns, width, joined);
      [this.groundOf, this.groundWidth] = [run.ground, width];
    }
    let lowest = Number.POSITIVE_INFINITY;
    let low = Number.POSITIVE_INFINITY;
    for (let i = 0; i < this.drawn.length; i++) {
      const height = this.drawn[i]!;
      data[2 * i] = height;
      data[2 * i + 1] = this.ground[i]!;
      if (height < low) low = height;
      if (run.ground[i]! < lowest) lowest = run.ground[i]!;
    }
    this.cutFrom(lowest, low);
    this.heights!.needsUpdate = true;
  }

  /** Slabs a third as high as wide are drawn a little steeper than they are, flat ones more, high relief less. */
  private usualExaggeration(run: Run): number {
    const { thickness, cell_size } = run.description!.lattice;
    if (run.status!.step === 0) this.usual = Number.POSITIVE_INFINITY;
    const [low, high] = ends(this.drawn);
    const fits = (MOST_RELIEF * Math.max(...this.extent)) / (high - low || 1);
    const wanted = Math.min(1.5 * Math.sqrt(cell_size / thickness / 3), fits, 20);
    this.usual = Math.min(this.usual, Math.max(Math.round(2 * wanted) / 2, 1.5));
    return this.usual;
  }

  /** Where the block's foot is: below the ground, or within a deep layer, and as long there as it can be. */
  private cutFrom(ground: number, surface: number): void {
    const thick = Math.max(...this.extent) / this.exaggeration;
    const below = ground - FOOT * thick;
    const [least, most] = [surface - 2 * FOOT * thick, surface - 0.5 * FOOT * thick];
    if (below >= least) this.base = below;
    else if (!(this.base >= least && this.base <= most)) this.base = surface - 1.2 * FOOT * thick;
  }

  private fillOverlay(run: Run): void {
    const shown = this.app.view.look.overlays.filter((name) => run.fields.has(name)).slice(0, 4);
    const data = this.overlay!.image.data as Uint8Array;
    data.fill(0);
    shown.forEach((name, layer) => {
      const field = run.fields.get(name)!;
      for (let i = 0; i < field.length; i++) data[4 * i + layer] = 255 * Math.min(Math.max(field[i]!, 0), 1);
    });
    this.overlay!.needsUpdate = true;
  }

  private fillMap(name: string): void {
    const colours = this.app.colours[name];
    if (!colours || (this.map === name && this.uniforms.map!.value)) return;
    this.map = name;
    const data = new Uint8Array(colours.flatMap((colour) => [...colour, 255]));
    const texture = new THREE.DataTexture(data, colours.length, 1);
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    this.uniforms.map!.value = texture;
  }

  private reshape(run: Run): void {
    const { lattice } = run.description!;
    const shape = `${run.rows}x${run.columns}x${lattice.cell_size}`;
    if (shape === this.shape) return;
    this.shape = shape;
    this.usual = Number.POSITIVE_INFINITY;
    this.extent = [run.columns * lattice.cell_size, run.rows * lattice.cell_size];
    this.scale = SIZE / Math.max(...this.extent);
    const filter = this.linear ? THREE.LinearFilter : THREE.NearestFilter;
    for (const old of [this.heights, this.values, this.overlay]) old?.dispose();
    const count = run.rows * run.columns;
    const make = (data: Float32Array | Uint8Array, format: THREE.PixelFormat, type: THREE.TextureDataType) => {
      const texture = new THREE.DataTexture(data as never, run.columns, run.rows, format, type);
      texture.minFilter = texture.magFilter = type === THREE.UnsignedByteType ? THREE.LinearFilter : filter;
      return texture;
    };
    this.heights = make(new Float32Array(2 * count), THREE.RGFormat, THREE.FloatType);
    this.values = make(new Float32Array(count), THREE.RedFormat, THREE.FloatType);
    this.overlay = make(new Uint8Array(4 * count), THREE.RGBAFormat, THREE.UnsignedByteType);
    const { uniforms } = this;
    uniforms.heights!.value = this.heights;
    uniforms.values!.value = this.values;
    uniforms.overlay!.value = this.overlay;
    uniforms.cells!.value.set(run.columns, run.rows);
    uniforms.extent!.value.set(...this.extent);
    uniforms.scale!.value = this.scale;
    this.group.clear();
    const across = Math.min(run.columns - 1, FINEST);
    const along = Math.min(run.rows - 1, FINEST);
    const surface = new THREE.Mesh(grid(across, along), this.top);
    const walls = new THREE.Mesh(skirt(across, along), this.side);
    surface.frustumCulled = walls.frustumCulled = false;
    this.group.add(surface, walls, this.paths.lines);
  }
}

function sunAt(azimuth: number, height: number): THREE.Vector3 {
  const a = (azimuth * Math.PI) / 180;
  const h = (height * Math.PI) / 180;
  return new THREE.Vector3(Math.sin(a) * Math.cos(h), Math.sin(h), -Math.cos(a) * Math.cos(h));
}
