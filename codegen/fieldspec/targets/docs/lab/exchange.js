// A request and what comes as its answer, over one carrier.

const QUIET = 30;  // milliseconds without a byte after which a valid answer is whole

class Exchange {
  constructor() {
    this.carrier = null;
    this.waiting = null;
    this.stray = 0;
  }

  // Bytes that nobody has asked for are counted, and no answer.
  received(bytes) {
    if (!this.waiting) {
      this.stray += bytes.length;
      return;
    }
    this.waiting.data = Uint8Array.from([...this.waiting.data, ...bytes]);
    clearTimeout(this.waiting.quiet);
    if (this.waiting.isWhole(this.waiting.data)) this.waiting.quiet = setTimeout(() => this.finish(), QUIET);
  }

  finish(lost = "") {
    const { waiting } = this;
    if (!waiting) return;
    clearTimeout(waiting.quiet);
    clearTimeout(waiting.patience);
    this.waiting = null;
    waiting.resolve({ data: waiting.data, milliseconds: performance.now() - waiting.start, lost });
  }

  // Sends a request and returns the bytes that answer it: when they are a valid answer, else after the time-out.
  async ask(request, isWhole, milliseconds) {
    this.stray = 0;
    const answer = new Promise((resolve) => {
      this.waiting = { data: new Uint8Array(), isWhole, resolve, start: performance.now(), quiet: 0 };
    });
    this.waiting.patience = setTimeout(() => this.finish(), milliseconds);
    try {
      await this.carrier.send(request);
    } catch (error) {
      this.finish(error.message);
    }
    return answer;
  }
}
