import { activeStep, type Project } from '../../src/editor/project.ts';
import { plainStep, recipeOf } from '../../src/editor/saved-recipe.ts';
import { type FormatInfo, formatInfo } from '../../src/io/index.ts';
import { kebabCase } from '../../src/methods/kebab-case.ts';
import { findMethod } from '../../src/methods/registry.ts';
import { filesNamedBy, formatRecipe, type RecipeStep } from '../../src/recipe/index.ts';

/** The format a project goes home in: the one it came in. */
export function ownFormat({ source }: Project): FormatInfo {
  return formatInfo(source.format);
}

/** `rabbit.glb` shaped by `cubic` is `rabbit-cubic.glb`, and by several steps `rabbit-whittled.glb`. @param ending with its dot */
export function exportName(project: Project, ending: string): string {
  const { steps } = recipeOf(project);
  const how = steps.length > 1 ? 'whittled' : (steps[0] ?? activeStep(project)).method;
  return `${stem(project.source.name)}-${how}${ending}`;
}

/** `rabbit.glb` has the recipe `rabbit.whittle.json`. */
export function recipeName({ source }: Project): string {
  return `${stem(source.name)}.whittle.json`;
}

/** `rabbit.glb` is in the project `rabbit.whittle.zip`. */
export function projectName({ source }: Project): string {
  return `${stem(source.name)}.whittle.zip`;
}

/** More than this is no command that one pastes. */
const longest = 8000;

/** A command that makes a project's file without the page. */
export interface Command {
  readonly text: string;
  /** It works on the project file: there is more to it than a mesh and a few steps. */
  readonly needsProject: boolean;
}

/**
 * The command line that makes the same file: one step of plain values by its flags, others by a recipe that the command brings
 * along as a here-document, and what names files or is too long for that by the project file.
 */
export function command(project: Project): Command {
  const { source } = project;
  const { steps } = recipeOf(project);
  const out = `--out ${quoted(exportName(project, ownFormat(project).ending))}`;
  const mesh = quoted(source.name);
  const flags = steps.length === 1 ? flagsOf(steps[0]!) : undefined;
  const recipeText = formatRecipe({ steps });
  if (filesNamedBy(steps).length > 0 || recipeText.length > longest)
    return { text: `npx whittle run ${quoted(projectName(project))} ${out}`, needsProject: true };
  if (flags)
    return { text: ['npx whittle', steps[0]!.method, mesh, ...flags, out].join(' '), needsProject: false };
  return { text: `npx whittle run - ${mesh} ${out} <<'RECIPE'\n${recipeText}RECIPE\n`, needsProject: false };
}

/** Undefined where a value is none that can be typed. */
function flagsOf(step: RecipeStep): string[] | undefined {
  const { parameters } = plainStep(step);
  const flags: string[] = [];
  for (const { name, kind } of findMethod(step.method)?.parameters ?? []) {
    const value = parameters[name];
    // A style is always named: which it is is the point.
    const said = value ?? (kind === 'style' ? step.parameters[name] : undefined);
    if (typeof said === 'object') return undefined;
    if (said === undefined) continue;
    flags.push(
      kind === 'flag' ? `--${kebabCase(name)}=${said}` : `--${kebabCase(name)} ${quoted(String(said))}`,
    );
  }
  return flags;
}

function stem(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'mesh';
}

/** As a POSIX shell reads it. */
function quoted(name: string): string {
  return /^[\w./-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}
