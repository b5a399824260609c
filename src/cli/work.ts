import { dirname, isAbsolute, join } from 'node:path';
import { isProjectFile, type ProjectFile, unpackProject } from '../io/index.ts';
import { WhittleError } from '../mesh/failure.ts';
import { parseRecipe, type RecipeStep } from '../recipe/index.ts';
import type { Command } from './command.ts';
import { readBeside, readBytes, readStream } from './files.ts';
import { readParameters } from './parameters.ts';
import { FileError } from './problems.ts';

export type RunCommand = Extract<Command, { kind: 'recipe' | 'method' }>;

/** A mesh file, and what finds the files that it refers to, by their paths from its folder. */
export interface MeshFile {
  /** For messages, which begin with it. */
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly read: (path: string) => Promise<Uint8Array<ArrayBuffer> | undefined>;
}

/** What is to be done, to what, and where the files are that it names. */
export interface Work {
  readonly steps: readonly RecipeStep[];
  readonly readFile: (name: string) => Promise<Uint8Array<ArrayBuffer>>;
  /** Absent where it lies on the disk. */
  readonly mesh?: MeshFile;
}

/** @throws UsageError, FileError, WhittleError */
export async function workOf(command: RunCommand, stdin?: AsyncIterable<Uint8Array>): Promise<Work> {
  if (command.kind === 'method') {
    const { method, values } = command;
    const parameters = await readParameters(method, values);
    return { steps: [{ method: method.id, parameters }], readFile: readBytes };
  }
  const { recipe, files } = command;
  const isStdin = recipe === '-';
  const bytes = isStdin ? await readStream(stdin ?? nothing()) : await readBytes(recipe);
  if (isProjectFile(bytes)) return workOfProject(unpackProject(bytes, recipe), recipe, files.input);
  const { steps } = parseRecipe(new TextDecoder().decode(bytes), isStdin ? 'stdin' : recipe);
  return { steps, readFile: (name) => readBytes(isStdin ? name : besideRecipe(name, recipe)) };
}

/** A mesh on the disk. @throws FileError */
export async function meshOf(path: string): Promise<MeshFile> {
  return { name: path, bytes: await readBytes(path), read: (beside) => readBeside(path, beside) };
}

/** The steps of a project, on its own mesh unless another one is named. */
function workOfProject({ recipe, assets, mesh, beside }: ProjectFile, file: string, input: string): Work {
  if (recipe === undefined)
    throw new WhittleError(
      'bad-recipe',
      `${file}: every step in it is switched off; switch one on and save it again.`,
    );
  const readFile = async (name: string) => {
    const bytes = assets.get(name);
    if (!bytes) throw new FileError(`${file}/${name}: it is not in the project; save the project again.`);
    return bytes;
  };
  const { steps } = parseRecipe(recipe, `${file}/recipe.json`);
  if (input !== file) return { steps, readFile };
  const own = {
    name: `${file}/mesh/${mesh.name}`,
    bytes: mesh.bytes,
    read: async (path: string) => beside.get(path),
  };
  return { steps, readFile, mesh: own };
}

/** Where a file lies that a recipe names: in the recipe's folder. */
function besideRecipe(name: string, recipe: string): string {
  return isAbsolute(name) ? name : join(dirname(recipe), name);
}

async function* nothing(): AsyncGenerator<Uint8Array> {}
