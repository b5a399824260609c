import type { ProjectFile } from '../io/index.ts';

/** Where values are kept under keys until somebody takes them away: IndexedDB on the page. It may refuse any of this. */
export interface KeptStorage {
  get(key: string): Promise<unknown>;
  set(key: string, value: unknown): Promise<void>;
  delete(key: string): Promise<void>;
  keys(): Promise<readonly string[]>;
}

/** A project that was kept. */
export interface KeptProject {
  readonly id: string;
  /** Milliseconds since 1970. */
  readonly keptAt: number;
  /** The link that the work began with, '' for none. */
  readonly link: string;
  readonly file: ProjectFile;
}

/** What stands for a project in the storage: its texts, and the keys of its bytes. */
interface Entry {
  readonly version: 1;
  readonly keptAt: number;
  readonly link: string;
  readonly recipe?: string;
  readonly workspace?: string;
  /** The mesh, and then what lies beside it. */
  readonly files: readonly Part[];
  readonly assets: readonly Part[];
}

interface Part {
  readonly name: string;
  readonly key: string;
}

const entryPrefix = 'project ';
const bytesPrefix = 'bytes ';
/** Projects of windows that were closed; older ones go. */
const mostKept = 4;

/**
 * Projects in a storage, one an id. Bytes are stored once, under keys of their project's own: what one window takes away, no
 * other one has. The bytes are there before the entry that says so, and go after it: a window that is closed half way leaves the
 * entry before.
 */
export class KeptProjects {
  readonly #storage: KeptStorage;
  readonly #now: () => number;
  /** Where bytes are that were stored or read here. */
  #known = new Map<Uint8Array, string>();
  #count = 0;

  constructor(storage: KeptStorage, now: () => number = Date.now) {
    this.#storage = storage;
    this.#now = now;
  }

  /** The ids of all projects, the newest first. */
  async list(): Promise<readonly string[]> {
    const keys = (await this.#storage.keys()).filter((key) => key.startsWith(entryPrefix));
    const entries = await Promise.all(
      keys.map(async (key) => ({ id: key.slice(entryPrefix.length), entry: await this.#entry(key) })),
    );
    return entries
      .filter(({ entry }) => entry !== undefined)
      .sort((a, b) => b.entry!.keptAt - a.entry!.keptAt)
      .map(({ id }) => id);
  }

  /** Undefined where there is none, or not all of it. */
  async read(id: string): Promise<KeptProject | undefined> {
    const entry = await this.#entry(entryPrefix + id);
    if (!entry) return undefined;
    const { keptAt, link, recipe, workspace } = entry;
    const [mesh, ...beside] = await this.#files(entry.files);
    const assets = await this.#files(entry.assets);
    if (!mesh || [mesh, ...beside, ...assets].some(([, bytes]) => bytes === undefined)) return undefined;
    const file = {
      mesh: { name: mesh[0], bytes: mesh[1]! },
      beside: new Map(beside as [string, Uint8Array<ArrayBuffer>][]),
      assets: new Map(assets as [string, Uint8Array<ArrayBuffer>][]),
      ...(recipe === undefined ? {} : { recipe }),
      ...(workspace === undefined ? {} : { workspace }),
    };
    return { id, keptAt, link, file };
  }

  /** Keeps a project under an id, in the place of what was there. Rejects if the storage does not take it. */
  async write(id: string, file: ProjectFile, link: string): Promise<void> {
    const { mesh, beside, assets, recipe, workspace } = file;
    const known = new Map<Uint8Array, string>();
    const store = async ([name, bytes]: readonly [string, Uint8Array<ArrayBuffer>]): Promise<Part> => {
      const before = this.#known.get(bytes) ?? known.get(bytes);
      const isOwn = before?.startsWith(`${bytesPrefix}${id} `);
      const key = isOwn ? before! : `${bytesPrefix}${id} ${this.#now().toString(36)}-${++this.#count}`;
      if (!isOwn) await this.#storage.set(key, bytes);
      known.set(bytes, key);
      return { name, key };
    };
    const files: Part[] = [];
    for (const one of [[mesh.name, mesh.bytes] as const, ...beside]) files.push(await store(one));
    const parts: Part[] = [];
    for (const one of assets) parts.push(await store(one));
    const entry: Entry = {
      ...{ version: 1, keptAt: this.#now(), link, files, assets: parts },
      ...(recipe === undefined ? {} : { recipe }),
      ...(workspace === undefined ? {} : { workspace }),
    };
    await this.#storage.set(entryPrefix + id, entry);
    this.#known = known;
    await this.#sweep(id, new Set(known.values()));
  }

  async remove(id: string): Promise<void> {
    await this.#storage.delete(entryPrefix + id);
    this.#known.clear();
    await this.#sweep(id, new Set());
  }

  /** Removes the oldest. @param isOpen whether a window works on a project */
  async trim(isOpen: (id: string) => Promise<boolean>): Promise<void> {
    const closed: string[] = [];
    for (const id of await this.list()) if (!(await isOpen(id))) closed.push(id);
    for (const id of closed.slice(mostKept)) {
      await this.#storage.delete(entryPrefix + id);
      await this.#sweep(id, new Set());
    }
  }

  async #entry(key: string): Promise<Entry | undefined> {
    const entry = (await this.#storage.get(key)) as Entry | undefined;
    return entry?.version === 1 ? entry : undefined;
  }

  #files(parts: readonly Part[]): Promise<[string, Uint8Array<ArrayBuffer> | undefined][]> {
    return Promise.all(
      parts.map(async ({ name, key }) => {
        const bytes = (await this.#storage.get(key)) as Uint8Array<ArrayBuffer> | undefined;
        if (bytes) this.#known.set(bytes, key);
        return [name, bytes];
      }),
    );
  }

  /** Takes the bytes of a project away, but for those that it has. */
  async #sweep(id: string, used: ReadonlySet<string>): Promise<void> {
    for (const key of await this.#storage.keys())
      if (key.startsWith(`${bytesPrefix}${id} `) && !used.has(key)) await this.#storage.delete(key);
  }
}
