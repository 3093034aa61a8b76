/** Sun, sky and air of a scene: by the theme, and from the wind where nobody has set the sun. */

import * as THREE from "three";
import type { Look } from "../core/view";

export type LightUniforms = Record<"sun" | "sunLight" | "skyLight" | "horizon" | "zenith" | "level" | "haze" | "thin", THREE.IUniform>;

interface Mood {
  sun: [number, number, number];
  sky: [number, number, number];
  horizon: [number, number, number];
  zenith: [number, number, number];
}

/** Light in linear colours: late afternoon, and dusk for the dark theme. */
const DAY: Mood = { sun: [2.3, 1.70, 1.07], sky: [0.17, 0.24, 0.40], horizon: [1.16, 1.06, 0.92], zenith: [0.19, 0.44, 0.90] };
const DUSK: Mood = { sun: [1.75, 1.06, 0.52], sky: [0.12, 0.16, 0.29], horizon: [0.27, 0.17, 0.12], zenith: [0.010, 0.022, 0.055] };
/** Degrees between the wind's way and the sun's, and its height: it grazes the windward sides, slip faces are in shadow. */
const ASIDE = 38;
const HEIGHT = 24;
/** Where the usual camera stands, as an azimuth. */
const BEHIND = 200;

export function lightUniforms(): LightUniforms {
  const vector = () => ({ value: new THREE.Vector3(0, 1, 0) });
  return { sun: vector(), sunLight: vector(), skyLight: vector(), horizon: vector(), zenith: vector(), level: { value: 0 }, haze: { value: 1 }, thin: { value: 1 } };
}

/** The sun's azimuth and height (degrees): as chosen, or across the crests that this wind makes. */
export function sunOf(look: Pick<Look, "sunAzimuth" | "sunHeight">, wind: number): { azimuth: number; height: number } {
  const away = (azimuth: number) => Math.abs(((azimuth - BEHIND + 540) % 360) - 180);
  const [one, other] = [wind + ASIDE, wind - ASIDE];
  const across = (away(one) >= away(other) ? one : other + 360) % 360;
  return { azimuth: look.sunAzimuth ?? across, height: look.sunHeight ?? HEIGHT };
}

/** Whether a scene is at dusk: as chosen, or as dark as the part of the page that holds it. */
export function isDusk(look: Pick<Look, "light">, host: Element): boolean {
  return look.light === "theme" ? getComputedStyle(host).colorScheme === "dark" : look.light === "dusk";
}

export function shine(uniforms: LightUniforms, sun: { azimuth: number; height: number }, dark: boolean): void {
  const mood = dark ? DUSK : DAY;
  const a = (sun.azimuth * Math.PI) / 180;
  const h = (sun.height * Math.PI) / 180;
  uniforms.sun.value.set(Math.sin(a) * Math.cos(h), Math.sin(h), -Math.cos(a) * Math.cos(h));
  // The lower the sun, the longer its way through the air: redder and weaker.
  const air = Math.exp(-0.045 * (1 / Math.max(Math.sin(h), 0.09) - 2.2));
  const colour = mood.sun.map((part, at) => part * air ** [0.5, 1, 1.8][at]!) as [number, number, number];
  uniforms.sunLight.value.set(...colour);
  uniforms.skyLight.value.set(...mood.sky);
  uniforms.horizon.value.set(...mood.horizon);
  uniforms.zenith.value.set(...mood.zenith);
}
