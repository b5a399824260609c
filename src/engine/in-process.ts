import type { ClientPort, ServerPort } from './port.ts';
import { serve } from './server.ts';
import type { Services } from './services.ts';

/** A worker that is none: a server in this very thread, at the other end of a message channel. */
export function spawnInProcess(services: Services): ClientPort {
  const { port1, port2 } = new MessageChannel();
  serve(port2 as ServerPort, services);
  const terminate = () => port1.close();
  return Object.assign(port1, { terminate, onerror: null }) as ClientPort;
}
