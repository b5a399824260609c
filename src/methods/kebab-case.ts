/** `lambdaPerVertex` → `lambda-per-vertex`: how flags of the command line write a parameter's name. */
export function kebabCase(name: string): string {
  return name.replaceAll(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}
