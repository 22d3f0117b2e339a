// Requests for solutions of the page: the latest request wins, answers arrive asynchronously.
import { ApiError, transport } from './client';
import { currentToken } from './http';
import { makeGate, type Asked, type Said } from './solverGate';
import type { StaticAnswer } from './types';

/** Sends requests to a worker, which waits for the program while the page draws. */
function startWorker(take: (said: Said) => void, fail: (error: unknown) => void): (asked: Asked) => void {
  const worker = new Worker(new URL('./solver.worker.ts', import.meta.url), { type: 'module' });
  worker.postMessage({ token: currentToken() });
  worker.onmessage = (event: MessageEvent<Said>) => take(event.data);
  worker.onerror = () => fail(new Error('The solver worker could not be started. Reload the page.'));
  return (asked) => worker.postMessage(asked);
}

/** A program within the page has workers of its own. */
function startGate(take: (said: Said) => void): (asked: Asked) => void {
  const gate = makeGate(take);
  return (asked) => gate.submit(asked);
}

export class Solver<Request extends { body: unknown }> {
  private readonly send: (asked: Asked) => void;
  private readonly asked = new Map<number, Request>();
  private last = 0;

  constructor(receive: (answer: StaticAnswer, request: Request) => void, fail: (error: unknown) => void) {
    const take = (said: Said): void => {
      const request = this.asked.get(said.id);
      // older requests were skipped in favour of it
      for (const id of [...this.asked.keys()]) if (id <= said.id) this.asked.delete(id);
      if (!request) return;
      if ('answer' in said) receive(said.answer, request);
      else fail(new ApiError(said.error.message, said.error.status, said.error.hint, null));
    };
    this.send = transport.local ? startGate(take) : startWorker(take, fail);
  }

  get inFlight(): boolean { return this.asked.size > 0; }

  submit(request: Request): void {
    const id = ++this.last;
    this.asked.set(id, request);
    this.send({ id, body: request.body });
  }
}
