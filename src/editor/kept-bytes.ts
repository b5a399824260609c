/**
 * How much memory a value keeps alive, in bytes: every buffer, list and text that can be reached from it, each once. Plain objects
 * count for nothing; they are small and few.
 */
export function keptBytes(...values: readonly unknown[]): number {
  const seen = new Set<unknown>();
  const waiting: unknown[] = [...values];
  let bytes = 0;
  while (waiting.length > 0) {
    const value = waiting.pop();
    if (typeof value === 'string') bytes += 2 * value.length;
    if (typeof value !== 'object' || value === null || seen.has(value)) continue;
    seen.add(value);
    if (ArrayBuffer.isView(value)) waiting.push(value.buffer);
    else if (value instanceof ArrayBuffer) bytes += value.byteLength;
    else if (isNumbers(value)) bytes += 8 * value.length;
    else if (value instanceof Map) waiting.push(...value.values());
    else for (const part of Object.values(value)) waiting.push(part);
  }
  return bytes;
}

/** Lists of numbers are long, and told by their first. */
function isNumbers(value: object): value is readonly number[] {
  return Array.isArray(value) && typeof value[0] === 'number';
}
