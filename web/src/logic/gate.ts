// "Latest only": while one request is pending, later ones wait, and of those only the newest is sent.
// A slider can so be dragged at any speed; no outdated picture is requested.

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

  private send(): { request: Request; answer: Promise<Answer> } | null {
    if (!this.waiting) return null;
    const { request } = this.waiting;
    this.waiting = null;
    ++this.sent;
    return { request, answer: this.ask(request) };
  }

  private async drain(): Promise<void> {
    this.busy = true;
    let sent = this.send();
    while (sent) {
      const { request, answer } = sent;
      const got = await answer.then((value) => ({ value }), (error: unknown) => ({ error }));
      // the next request is pending while the page processes the answer
      sent = this.send();
      try {
        if ('value' in got) this.receive(got.value, request); else this.fail(got.error);
      } catch (error) {
        this.fail(error);
      }
      sent ??= this.send();
    }
    this.busy = false;
  }
}
