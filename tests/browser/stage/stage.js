// A server on a stage: a WebSocket whose frames the test gives. It beats with the last snapshot, answers every command
// with a refusal, and keeps what the page sent.
(() => {
  const open = new Set();
  const stage = { sent: [], refusal: "refused", play: null, dark: false };
  let frame = 0;

  class Socket extends EventTarget {
    constructor(url) {
      super();
      this.url = url;
      this.readyState = 0;
      setTimeout(() => (stage.dark ? this.end() : this.begin()), 0);
    }
    begin() {
      this.readyState = 1;
      open.add(this);
      this.tell("open", new Event("open"));
      if (stage.play) this.greet();
    }
    greet() {
      const { hello, route, ports, lines } = stage.play;
      [hello, route, ports, lines].forEach((part) => this.say(part));
      this.beat();
    }
    beat() {
      this.say({ ...stage.play.snapshot, frame: (frame += 1) });
    }
    say(part) {
      this.tell("message", new MessageEvent("message", { data: JSON.stringify(part) }));
    }
    tell(name, event) {
      this.dispatchEvent(event);
      this[`on${name}`]?.(event);
    }
    end() {
      this.readyState = 3;
      open.delete(this);
      this.tell("close", new CloseEvent("close"));
    }
    send(text) {
      const up = JSON.parse(text);
      if (up.type !== "command") return;
      stage.sent.push(up.do);
      queueMicrotask(() => this.say({ type: "answer", id: up.id, ok: false, text: stage.refusal }));
    }
    close() {
      if (this.readyState < 2) this.end();
    }
  }
  Object.assign(Socket, { CONNECTING: 0, OPEN: 1, CLOSING: 2, CLOSED: 3 });
  window.WebSocket = Socket;
  window.stage = stage;

  setInterval(() => stage.play && open.forEach((socket) => socket.beat()), 300);

  // Puts a state on the page and waits until it is drawn.
  stage.show = async (state) => {
    stage.play = state;
    open.forEach((socket) => {
      socket.greet();
      const { refused } = state;
      socket.say({ type: "answer", id: 0, ok: !refused, text: refused || "done" });
    });
    await stage.drawn();
    for (const button of state.press || []) {
      document.querySelector(`[data-command="${button}"]`).click();
      await stage.drawn();
    }
  };
  // Two turns of the event loop: what was set is on the page.
  stage.drawn = async () => {
    for (let turn = 0; turn < 2; turn += 1) {
      await new Promise((done) => {
        const channel = new MessageChannel();
        channel.port1.onmessage = done;
        channel.port2.postMessage(0);
      });
    }
  };
  stage.silence = () => {
    stage.dark = true;
    [...open].forEach((socket) => socket.end());
  };
})();
