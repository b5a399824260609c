import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import type { Readable } from 'node:stream';

export interface VirtualScreen {
  /** Its number, ':1'; empty where the system's own will do. */
  readonly display: string;
  close(): void;
}

/** A screen that nobody sees: without one Firefox has no WebGL. Other systems than Linux always have theirs. */
export async function openScreen(): Promise<VirtualScreen> {
  if (process.platform !== 'linux') return { display: '', close: () => undefined };
  const screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  return { display: `:${await numberOf(screen)}`, close: () => screen.kill() };
}

/** Xvfb takes the first number that is free and writes it once it is ready. */
async function numberOf(screen: ChildProcess): Promise<string> {
  const failed = once(screen, 'exit').then(([code]) => {
    throw new Error(`Xvfb ended with ${code} before it was ready.`);
  });
  const [number] = await Promise.race([once(screen.stdio[3] as Readable, 'data'), failed]);
  return String(number).trim();
}
