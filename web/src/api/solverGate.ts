// Requests for solutions, one at a time: of those that wait, the latest replaces the others.
import { LatestGate } from '../logic/gate';
import { ApiError, post } from './client';
import type { StaticAnswer } from './types';

export interface Asked { id: number; body: unknown }
export type Said = { id: number } & ({ answer: StaticAnswer } | { error: { message: string; status: number; hint: string } });

async function solve({ id, body }: Asked): Promise<Said> {
  try {
    return { id, answer: await post<StaticAnswer>('static', body) };
  } catch (error) {
    const known = error instanceof ApiError;
    return { id, error: { message: error instanceof Error ? error.message : String(error), status: known ? error.status : 0, hint: known ? error.hint : '' } };
  }
}

export const makeGate = (say: (said: Said) => void): LatestGate<Asked, Said> => new LatestGate<Asked, Said>(solve, say, () => undefined);
