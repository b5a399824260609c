/** The file's name, with a number before its ending if another has it already: recipes go by names. */
export function freeName(file: string, isTaken: (name: string) => boolean): string {
  const dot = file.lastIndexOf('.');
  const [stem, ending] = dot > 0 ? [file.slice(0, dot), file.slice(dot)] : [file, ''];
  let name = file;
  for (let n = 2; isTaken(name); n++) name = `${stem}-${n}${ending}`;
  return name;
}
