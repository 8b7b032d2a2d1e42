// Keeps one request in flight. What is wanted meanwhile waits, and only the
// newest of it; a request that is slow is stopped when something newer waits.

type Work = (signal: AbortSignal) => Promise<void>;

export class NewestOnly {
  private running: { abort: AbortController; since: number } | undefined;
  private waiting: Work | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** A running request that is older than this gives way to a newer one. */
  constructor(private readonly patienceMs: number) {}

  ask(work: Work): void {
    this.waiting = work;
    if (!this.running) {
      void this.run();
      return;
    }
    const age = performance.now() - this.running.since;
    this.timer ??= setTimeout(() => this.running?.abort.abort(), Math.max(this.patienceMs - age, 0));
  }

  /** Stops what runs and forgets what waits. */
  stop(): void {
    this.waiting = undefined;
    this.running?.abort.abort();
  }

  private async run(): Promise<void> {
    while (this.waiting) {
      const work = this.waiting;
      this.waiting = undefined;
      this.running = { abort: new AbortController(), since: performance.now() };
      await work(this.running.abort.signal);
      clearTimeout(this.timer);
      this.timer = undefined;
      this.running = undefined;
    }
  }
}
