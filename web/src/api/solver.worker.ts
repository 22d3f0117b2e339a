// Requests solutions in a worker, so that slow drawing does not delay the next request.
import { setToken } from './http';
import { makeGate, type Asked, type Said } from './solverGate';

const gate = makeGate((said: Said): void => { (self as unknown as { postMessage: (m: Said) => void }).postMessage(said); });

self.onmessage = (event: MessageEvent<Asked | { token: string }>): void => {
  if ('token' in event.data) setToken(event.data.token);
  else gate.submit(event.data);
};
