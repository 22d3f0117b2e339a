// Requests solutions in a worker, so that slow drawing does not delay the next request.
import { LatestGate } from '../logic/gate';
import { ApiError, post, setToken } from './client';
import type { StaticAnswer } from './types';

export interface Asked { id: number; body: unknown }
export type Said = { id: number } & ({ answer: StaticAnswer } | { error: { message: string; status: number; hint: string } });

const say = (said: Said): void => { (self as unknown as { postMessage: (m: Said) => void }).postMessage(said); };

const gate = new LatestGate<Asked, Said>(
  async ({ id, body }) => {
    try {
      return { id, answer: await post<StaticAnswer>('static', body) };
    } catch (error) {
      const known = error instanceof ApiError;
      return { id, error: { message: error instanceof Error ? error.message : String(error), status: known ? error.status : 0, hint: known ? error.hint : '' } };
    }
  },
  say,
  () => undefined,
);

self.onmessage = (event: MessageEvent<Asked | { token: string }>): void => {
  if ('token' in event.data) setToken(event.data.token);
  else gate.submit(event.data);
};
