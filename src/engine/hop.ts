/** Lets what waits in the event queue happen, then goes on. */
export type Hop = () => Promise<void>;

/**
 * A promise microtask would not let messages in, a timer costs 4 ms in browsers: hence `setImmediate` in Node and a
 * message to ourselves in browsers.
 */
export function createHop(): Hop {
  const { setImmediate } = globalThis as { setImmediate?: (callback: () => void) => void };
  if (setImmediate) return () => new Promise((resolve) => setImmediate(resolve));

  const waiting: (() => void)[] = [];
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => waiting.shift()?.();
  return () =>
    new Promise((resolve) => {
      waiting.push(resolve);
      port2.postMessage(null);
    });
}
