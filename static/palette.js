// Sets the kept palette before anything is painted, so that a reload at night is not white.
(() => {
  let palette = "day";
  try {
    palette = localStorage.getItem("wheelover.palette") ?? "day";
  } catch {
    // No storage (a file opened from disk): day.
  }
  document.documentElement.dataset.palette = palette;
})();
