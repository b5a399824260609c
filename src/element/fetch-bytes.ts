import { WhittleError } from '../mesh/failure.ts';

/** The last part of an address, which is the file's name; “mesh” where the file itself is the address. */
export function nameOf(address: string): string {
  if (/^(data|blob):/i.test(address)) return 'mesh';
  const path = address.replace(/[?#].*$/, '');
  const name = path.slice(path.lastIndexOf('/') + 1) || 'mesh';
  try {
    return decodeURIComponent(name);
  } catch {
    // A stray % is no reason to refuse a file.
    return name;
  }
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
  try {
    const response = await fetch(url, signal ? { signal } : {});
    if (!response.ok) throw unreachable(url, `the server answered ${response.status}`);
    return await (onShare ? readShares(response, onShare) : wholeOf(response));
  } catch (thrown) {
    if (thrown instanceof WhittleError || signal?.aborted) throw thrown;
    throw unreachable(
      url,
      'the server cannot be reached, breaks off, or does not share files with this page',
    );
  }
}

async function wholeOf(response: Response): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await response.arrayBuffer());
}

async function readShares(
  response: Response,
  onShare: (share: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = response.body?.getReader();
  if (!reader) return wholeOf(response);
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
