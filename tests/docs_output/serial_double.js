// A serial port of the browser with a device after it that answers each request in two pieces; `window.plug` is the test's.
(() => {
  let controller;
  const plug = { answers: [], sent: [], opened: null };
  const deliver = (bytes) => controller.enqueue(Uint8Array.from(bytes));
  const readable = () => new ReadableStream({ start: (own) => { controller = own; } });
  const port = {
    readable: null,
    writable: null,
    async open(settings) {
      plug.opened = settings;
      port.readable = readable();
      port.writable = new WritableStream({
        write(bytes) {
          plug.sent.push(Array.from(bytes));
          const answer = plug.answers.shift() ?? [];
          if (answer.length) setTimeout(() => deliver(answer.slice(0, 3)), 5);
          if (answer.length) setTimeout(() => deliver(answer.slice(3)), 15);
        },
      });
    },
    async close() { port.readable = port.writable = null; plug.closed = true; },
  };
  plug.disturb = () => {
    const old = controller;
    port.readable = readable();
    old.error(new DOMException("a parity error", "ParityError"));
  };
  plug.remove = () => {
    const old = controller;
    port.readable = port.writable = null;
    old.error(new DOMException("the device has been lost", "NetworkError"));
  };
  plug.stray = deliver;
  window.plug = plug;
  Object.defineProperty(navigator, "serial", { value: { requestPort: async () => port } });
})();
