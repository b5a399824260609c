import { type ChildProcess, spawn } from 'node:child_process';
import { once } from 'node:events';
import type { Readable } from 'node:stream';
import type { TestProject } from 'vitest/node';

declare module 'vitest' {
  interface ProvidedContext {
    /** Number of a virtual screen, ':1'; empty where the system's own will do. */
    display: string;
  }
}

/**
 * A screen that nobody sees, for as long as the tests of a project run: without one Firefox has no WebGL. Other systems than
 * Linux always have theirs.
 */
export default async function setup(project: TestProject): Promise<(() => void) | undefined> {
  if (process.platform !== 'linux') {
    project.provide('display', '');
    return undefined;
  }
  const screen = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  project.provide('display', `:${await numberOf(screen)}`);
  return () => {
    screen.kill();
  };
}

/** Xvfb takes the first number that is free and writes it once it is ready. */
async function numberOf(screen: ChildProcess): Promise<string> {
  const failed = once(screen, 'exit').then(([code]) => {
    throw new Error(`Xvfb ended with ${code} before it was ready.`);
  });
  const [number] = await Promise.race([once(screen.stdio[3] as Readable, 'data'), failed]);
  return String(number).trim();
}
