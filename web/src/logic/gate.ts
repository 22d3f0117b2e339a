// "Latest only": while one request is on its way, later ones wait, and of those that wait only the newest is sent.
// A slider can so be dragged as fast as one likes; the program is never asked for a picture nobody will see.

export class LatestGate<Request, Answer> {
  private waiting: { request: Request } | null = null;
  private busy = false;
  sent = 0;
  skipped = 0;

  constructor(
    private readonly ask: (request: Request) => Promise<Answer>,
    private readonly receive: (answer: Answer, request: Request) => void,
    private readonly fail: (error: unknown) => void,
  ) {}

  get inFlight(): boolean { return this.busy; }

  submit(request: Request): void {
    if (this.waiting) ++this.skipped;
    this.waiting = { request };
    if (!this.busy) void this.drain();
  }

  private async drain(): Promise<void> {
    this.busy = true;
    while (this.waiting) {
      const { request } = this.waiting;
      this.waiting = null;
      ++this.sent;
      try {
        this.receive(await this.ask(request), request);
      } catch (error) {
        this.fail(error);
      }
    }
    this.busy = false;
  }
}
