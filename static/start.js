// Starts the page.
import init from "{{script}}";
await init({ module_or_path: "{{wasm}}" });
if ("serviceWorker" in navigator) {
  // The page lives without it: a certificate that was clicked through forbids it.
  navigator.serviceWorker.register("/sw.js").catch(() => {});
}
