// Page side of the worker that requests solutions: the latest request wins, answers arrive asynchronously.
import { ApiError, currentToken } from './client';
import type { Said } from './solver.worker';
import type { StaticAnswer } from './types';

export class Solver<Request extends { body: unknown }> {
  private readonly worker = new Worker(new URL('./solver.worker.ts', import.meta.url), { type: 'module' });
  private readonly asked = new Map<number, Request>();
  private last = 0;

  constructor(receive: (answer: StaticAnswer, request: Request) => void, fail: (error: unknown) => void) {
    this.worker.postMessage({ token: currentToken() });
    this.worker.onmessage = (event: MessageEvent<Said>) => {
      const said = event.data;
      const request = this.asked.get(said.id);
      // older requests were skipped in favour of it
      for (const id of [...this.asked.keys()]) if (id <= said.id) this.asked.delete(id);
      if (!request) return;
      if ('answer' in said) receive(said.answer, request);
      else fail(new ApiError(said.error.message, said.error.status, said.error.hint, null));
    };
    this.worker.onerror = () => fail(new Error('The solver worker could not be started. Reload the page.'));
  }

  get inFlight(): boolean { return this.asked.size > 0; }

  submit(request: Request): void {
    const id = ++this.last;
    this.asked.set(id, request);
    this.worker.postMessage({ id, body: request.body });
  }
}
