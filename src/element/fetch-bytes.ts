import { WhittleError } from '../mesh/failure.ts';

/** The last part of an address, which is the file's name. */
export function nameOf(address: string): string {
  const path = address.replace(/[?#].*$/, '');
  return decodeURIComponent(path.slice(path.lastIndexOf('/') + 1)) || 'mesh';
}

/**
 * Fetches a file.
 *
 * @param onShare told how much is there, from 0 to 1; NaN where the server does not say how long the file is
 * @throws WhittleError `unsupported-file` with the name and what to do
 */
export async function fetchBytes(
  url: URL,
  signal?: AbortSignal,
  onShare?: (share: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(url, signal ? { signal } : {}).catch((thrown) => {
    if (signal?.aborted) throw thrown;
    throw unreachable(url, 'the server cannot be reached, or does not share files with this page');
  });
  if (!response.ok) throw unreachable(url, `the server answered ${response.status}`);
  const reader = response.body?.getReader();
  if (!onShare || !reader) return new Uint8Array(await response.arrayBuffer());
  const whole = Number(response.headers.get('content-length') ?? Number.NaN);
  const parts: Uint8Array[] = [];
  let length = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    length += part.value.length;
    onShare(Math.min(1, length / whole));
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

function unreachable(url: URL, why: string): WhittleError {
  return new WhittleError(
    'unsupported-file',
    `${nameOf(url.href)} could not be fetched: ${why}; check the address ${url.href}.`,
  );
}
