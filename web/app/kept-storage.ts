import type { KeptStorage } from '../../src/editor/kept-projects.ts';

const database = 'whittle';
const table = 'kept';

/** Keys and values in this browser's IndexedDB. Opened when first asked for; whatever it refuses rejects. */
export class BrowserStorage implements KeptStorage {
  #opened: Promise<IDBDatabase> | null = null;

  get(key: string): Promise<unknown> {
    return this.#do('readonly', (store) => store.get(key));
  }

  async set(key: string, value: unknown): Promise<void> {
    await this.#do('readwrite', (store) => store.put(value, key));
  }

  async delete(key: string): Promise<void> {
    await this.#do('readwrite', (store) => store.delete(key));
  }

  keys(): Promise<readonly string[]> {
    return this.#do('readonly', (store) => store.getAllKeys() as IDBRequest<string[]>);
  }

  /** Done when the transaction is: a full disk is found out only then. */
  async #do<T>(mode: IDBTransactionMode, ask: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
    this.#opened ??= open();
    const opened = await this.#opened.catch((thrown) => {
      this.#opened = null;
      throw thrown;
    });
    return new Promise((resolve, reject) => {
      const transaction = opened.transaction(table, mode);
      const request = ask(transaction.objectStore(table));
      transaction.oncomplete = () => resolve(request.result);
      transaction.onerror = transaction.onabort = () => reject(transaction.error ?? request.error);
    });
  }
}

function open(): Promise<IDBDatabase> {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(database, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(table);
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error('The database is held by an older page.'));
    request.onsuccess = () => {
      const opened = request.result;
      // A newer page may want another version of it.
      opened.onversionchange = () => opened.close();
      resolve(opened);
    };
  });
}
