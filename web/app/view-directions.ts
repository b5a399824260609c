import { Quaternion, Vector3 } from 'three';
import type { Vec3 } from '../../src/mesh/vectors.ts';

/** How one looks at the file's axes. */
export interface ViewTurn {
  readonly orientation: Quaternion;
  readonly zUp: boolean;
}

const lying = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -Math.PI / 2);

/** A direction of the file as it is seen: right, up, towards the eye. */
export function toSeen(direction: Vec3, { orientation, zUp }: ViewTurn): Vec3 {
  const seen = new Vector3(...direction);
  if (zUp) seen.applyQuaternion(lying);
  return seen.applyQuaternion(orientation.clone().invert()).toArray() as Vec3;
}

export function toFile(seen: Vec3, { orientation, zUp }: ViewTurn): Vec3 {
  const direction = new Vector3(...seen).applyQuaternion(orientation);
  if (zUp) direction.applyQuaternion(lying.clone().invert());
  return direction.toArray() as Vec3;
}

/**
 * The direction under a finger on a ball of radius 1, as it is seen. Beyond the rim it goes on round to the far side, which is
 * reached at twice the radius.
 */
export function pointed(x: number, y: number): Vec3 {
  const radius = Math.hypot(x, y);
  if (radius <= 1) return [x, y, Math.sqrt(1 - radius * radius)];
  const past = ((Math.min(2, radius) - 1) * Math.PI) / 2;
  return [(x / radius) * Math.cos(past), (y / radius) * Math.cos(past), -Math.sin(past)];
}

/** Turned by angles about the seen vertical and the seen horizontal axis. */
export function nudged(seen: Vec3, right: number, up: number): Vec3 {
  return new Vector3(...seen)
    .applyAxisAngle(new Vector3(0, 1, 0), right)
    .applyAxisAngle(new Vector3(1, 0, 0), -up)
    .normalize()
    .toArray() as Vec3;
}

/** For ears: "right and up", "towards you". */
export function inWords([x, y, z]: Vec3): string {
  const words = [
    x > 0.35 ? 'right' : x < -0.35 ? 'left' : '',
    y > 0.35 ? 'up' : y < -0.35 ? 'down' : '',
    z > 0.35 ? 'towards you' : z < -0.35 ? 'away from you' : '',
  ].filter((word) => word !== '');
  return words.join(', ');
}
