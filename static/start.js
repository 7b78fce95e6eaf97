// Starts the page.
import init from "{{script}}";

// The dictionary is a module of its own, fetched when the page is alive.
globalThis.wheeloverDictionary = async () => {
  const dictionary = await import("{{dictionary_script}}");
  await dictionary.default({ module_or_path: "{{dictionary_wasm}}" });
  return dictionary;
};

// The link is opened while the page is still being compiled. The page begins with what the server says first, so that
// what it shows first is live; it does not wait long for that, and not at all where there is no server.
const socket = new WebSocket(`${location.origin.replace("http", "ws")}/ws?lines=resumed`);
const link = { socket, frames: [], came: undefined };
const greeted = new Promise((done) => {
  socket.onmessage = (event) => {
    link.came ??= performance.now();
    link.frames.push(event.data);
    done();
  };
  socket.onerror = done;
  setTimeout(done, 500);
});
globalThis.wheeloverLink = link;

const [module] = await Promise.all([WebAssembly.compileStreaming(fetch("{{wasm}}")), greeted]);
await init({ module_or_path: module });
// The style of the views that are fetched later.
document.head.append(Object.assign(document.createElement("link"), { rel: "stylesheet", href: "{{talk}}" }));
if ("serviceWorker" in navigator) {
  // The page lives without it: a certificate that was clicked through forbids it.
  navigator.serviceWorker.register("/sw.js").catch(() => {});
}
