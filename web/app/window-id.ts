const key = 'whittle-window';

/** The id of this window's work as it was before a reload; null in a new window. */
export function formerId(): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

/** An id that no window has, for this window from now on. */
export function newId(): string {
  const [a, b] = crypto.getRandomValues(new Uint32Array(2));
  return `${a!.toString(36)}${b!.toString(36)}`;
}

/**
 * Makes an id this window's own until it is closed or reloaded. False if another window has it: a tab that was duplicated has its
 * twin's. Where the browser has no locks, an id is only ever taken again by the window that had it.
 */
export async function takeId(id: string): Promise<boolean> {
  const isFree = (await lock(id)) ?? id === formerId();
  if (isFree) remember(id);
  return isFree;
}

/** Whether a window has this id now. */
export async function isOpen(id: string): Promise<boolean> {
  const { held = [] } = (await navigator.locks?.query()) ?? {};
  return held.some(({ name }) => name === lockName(id));
}

/** Undefined where there are no locks. */
function lock(id: string): Promise<boolean> | undefined {
  return (
    navigator.locks &&
    new Promise((resolve) => {
      void navigator.locks.request(lockName(id), { ifAvailable: true }, (held) => {
        resolve(held !== null);
        // The window's end lets go of it.
        return held && new Promise<void>(() => {});
      });
    })
  );
}

function remember(id: string): void {
  try {
    sessionStorage.setItem(key, id);
  } catch {}
}

function lockName(id: string): string {
  return `${key} ${id}`;
}
