// Starts the page.
import init from "{{script}}";

// The dictionary is a module of its own, fetched when the page is alive.
globalThis.wheeloverDictionary = async () => {
  const dictionary = await import("{{dictionary_script}}");
  await dictionary.default({ module_or_path: "{{dictionary_wasm}}" });
  return dictionary;
};

await init({ module_or_path: "{{wasm}}" });
if ("serviceWorker" in navigator) {
  // The page lives without it: a certificate that was clicked through forbids it.
  navigator.serviceWorker.register("/sw.js").catch(() => {});
}
