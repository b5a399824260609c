import { WhittleError } from '../mesh/failure.ts';
import type { WasmModule } from './wasm-module.ts';

/** The only hands on wasm memory: claim, copy in, call, look again, copy out, release. */
export class WasmHeap {
  readonly #module: WasmModule;

  constructor(module: WasmModule) {
    this.#module = module;
  }

  /** The size of all the memory, used or not; it never shrinks. */
  get bytes(): number {
    return this.#module.HEAPU8.byteLength;
  }

  /** Runs `use` with the addresses of copies of the given arrays and frees them afterwards. */
  withCopies<Result>(arrays: readonly ArrayBufferView[], use: (...addresses: number[]) => Result): Result {
    const addresses: number[] = [];
    try {
      for (const array of arrays) {
        const address = this.#claim(array.byteLength);
        addresses.push(address);
        this.#module.HEAPU8.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), address);
      }
      return use(...addresses);
    } finally {
      for (const address of addresses) this.#module._free(address);
    }
  }

  /** Runs `use` with the address of a copy that ends with a zero, as C has it. */
  withString<Result>(text: string, use: (address: number) => Result): Result {
    return this.withCopies([new TextEncoder().encode(`${text}\0`)], use);
  }

  /** Lets `write` fill `into.length` numbers at an address and copies them out. */
  readNumbers(into: Float64Array, write: (address: number) => void): void {
    const address = this.#claim(into.byteLength);
    try {
      write(address);
      into.set(new Float64Array(this.#module.HEAPU8.buffer, address, into.length));
    } finally {
      this.#module._free(address);
    }
  }

  /** Copies out what stands before the next zero; the module keeps the string. */
  readString(address: number): string {
    const bytes = this.#module.HEAPU8;
    return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
  }

  #claim(bytes: number): number {
    const address = this.#module._malloc(Math.max(bytes, 8));
    if (address === 0)
      throw new WhittleError('out-of-memory', 'There is not enough memory for this mesh; try a smaller one.');
    return address;
  }
}
