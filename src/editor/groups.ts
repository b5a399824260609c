import type { Group } from '../recipe/index.ts';

/** Changes of a project's named groups, each a new list. */

/** A list with one more group, or with other vertices in the one of that name. */
export function withGroup(groups: readonly Group[], group: Group): readonly Group[] {
  const at = groups.findIndex(({ name }) => name === group.name);
  return at < 0 ? [...groups, group] : groups.with(at, group);
}

export function withoutGroup(groups: readonly Group[], name: string): readonly Group[] {
  return groups.filter((group) => group.name !== name);
}

/** A group under another name; one that another group has gets a number. An empty name changes nothing. */
export function renamedGroup(groups: readonly Group[], from: string, to: string): readonly Group[] {
  const wanted = to.trim();
  const at = groups.findIndex(({ name }) => name === from);
  if (at < 0 || wanted === '' || wanted === from) return groups;
  return groups.with(at, { ...groups[at]!, name: freeGroupName(groups, wanted) });
}

/** The name, or with a number after it if a group has it already: "ear", "ear 2", "ear 3". */
export function freeGroupName(groups: readonly Group[], wanted: string): string {
  const isTaken = (name: string) => groups.some((group) => group.name === name);
  let name = wanted;
  for (let n = 2; isTaken(name); n++) name = `${wanted} ${n}`;
  return name;
}
