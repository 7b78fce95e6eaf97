// Eyes for what stands on the screen: what is cut, covered, too small, out of reach or moved.
(() => {
  const SCROLLS = ".view, .alert-list, .right, .why";
  const BOXES = "button, a, .badge, .strip > div, .cell, .why, section, .alerts, .top";
  const near = 1.5;
  const seen = (element) => element.checkVisibility({ visibilityProperty: true });
  const name = (element) =>
    element.dataset.command || element.dataset.value || element.className || element.tagName;
  const text = (node) => node.textContent.trim().replace(/\s+/g, " ").slice(0, 40);
  const inside = (a, b, slack = near) =>
    a.left >= b.left - slack && a.right <= b.right + slack && a.top >= b.top - slack && a.bottom <= b.bottom + slack;
  const cut = (a, b) => ({
    left: Math.max(a.left, b.left), right: Math.min(a.right, b.right),
    top: Math.max(a.top, b.top), bottom: Math.min(a.bottom, b.bottom),
  });
  const overlap = (a, b, slack = near) => {
    const both = cut(a, b);
    return both.right - both.left > slack && both.bottom - both.top > slack;
  };
  const screen = () => ({ left: 0, top: 0, right: innerWidth, bottom: innerHeight });

  // Texts of the page with the rectangles of their lines; the plan's own drawing is another matter.
  function texts() {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const found = [];
    while (walker.nextNode()) {
      const node = walker.currentNode;
      const element = node.parentElement;
      if (!node.textContent.trim() || element.closest("svg, script, style, noscript") || !seen(element)) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      // Of a line's box only what its letters fill.
      const tall = parseFloat(getComputedStyle(element).fontSize) * 0.38;
      const boxes = [...range.getClientRects()].filter((box) => box.width > 0.5).map(({ left, right, top, bottom }) =>
        ({ left, right, top: (top + bottom) / 2 - tall, bottom: (top + bottom) / 2 + tall }));
      if (boxes.length) found.push({ node, element, boxes });
    }
    return found;
  }

  // What is left of a box in everything that scrolls around it.
  function shown(element, box) {
    for (let at = element; at; at = at.parentElement) {
      if (at.matches(SCROLLS) && at !== element) box = cut(box, at.getBoundingClientRect());
    }
    return cut(box, screen());
  }
  const empty = (box) => box.right - box.left < 1 || box.bottom - box.top < 1;

  function faults() {
    const all = [];
    const root = document.documentElement;
    if (root.scrollWidth > innerWidth || root.scrollHeight > innerHeight) all.push("the page itself scrolls");
    for (const element of document.querySelectorAll(".bridge *, .top *, .alerts *, .bridge, .top, .alerts")) {
      if (!seen(element) || element.closest("svg")) continue;
      const style = getComputedStyle(element);
      if (style.display.startsWith("inline") || style.overflowX === "visible") continue;
      if (element.scrollWidth > element.clientWidth + 1) all.push(`${name(element)} is cut: ${text(element)}`);
      if (!element.matches(".view, .alert-list") && element.scrollHeight > element.clientHeight + 1)
        all.push(`${name(element)} is cut below: ${text(element)}`);
    }
    const words = texts();
    for (const { node, element, boxes } of words) {
      const box = element.closest(BOXES)?.getBoundingClientRect();
      for (const line of boxes) {
        if (box && !inside(line, box)) all.push(`"${text(node)}" leaves ${name(element.closest(BOXES))}`);
        if (line.left < -near || line.right > innerWidth + near) all.push(`"${text(node)}" leaves the screen`);
      }
    }
    const lines = words.flatMap(({ node, element, boxes }) =>
      boxes.map((box) => ({ node, element, box: shown(element, box) })).filter(({ box }) => !empty(box)));
    lines.forEach((one, index) => {
      for (const other of lines.slice(index + 1)) {
        const apart = one.element.closest(".alert-list, .veil") !== other.element.closest(".alert-list, .veil");
        if (!apart && overlap(one.box, other.box)) all.push(`"${text(one.node)}" and "${text(other.node)}" overlap`);
      }
    });
    const pieces = [...document.querySelectorAll(
      ".top, .alerts, .plan, .control, .voyage, .right > section, .strip > div, button, .top > *, .veil b")].filter(seen);
    const boxes = pieces.map((piece) => ({ piece, box: shown(piece, piece.getBoundingClientRect()) }));
    boxes.forEach(({ piece, box }, index) => {
      for (const { piece: other, box: second } of boxes.slice(index + 1)) {
        const nested = piece.contains(other) || other.contains(piece);
        const banner = [piece, other].some((e) => e.closest(".veil")) && [piece, other].some((e) => e.closest(".view"));
        if (!nested && !banner && !empty(box) && !empty(second) && overlap(box, second))
          all.push(`${name(piece)} and ${name(other)} overlap`);
      }
    });
    for (const button of document.querySelectorAll("button, .tabs a")) {
      if (!seen(button)) continue;
      const box = button.getBoundingClientRect();
      if (Math.min(box.width, box.height) < 43.5) all.push(`${name(button)} is smaller than a finger: ${box.width}x${box.height}`);
      const part = shown(button, box);
      if (empty(part)) continue;
      const top = document.elementFromPoint((part.left + part.right) / 2, (part.top + part.bottom) / 2);
      if (!button.contains(top)) all.push(`${name(button)} is covered by ${name(top)}`);
    }
    // AP-25, DSP-5: these stand on the screen before anything is scrolled.
    for (const first of ['[data-value="mode"]', ".alerts", '[data-command="standby"]', '[data-command="confirm"]', ".why"]) {
      const element = document.querySelector(first);
      if (!inside(element.getBoundingClientRect(), screen(), 0.5)) all.push(`${first} is not on the first screen`);
    }
    const say = document.querySelector("button.alert-text .say");
    if (say && say.getBoundingClientRect().width < 120) all.push("the alarm's text has no width");
    return all;
  }

  const places = () =>
    Object.fromEntries([...document.querySelectorAll(".control [data-command], .alerts > [data-command]")].map((b) => {
      const box = b.getBoundingClientRect();
      return [b.dataset.command, [box.x, box.y, box.width, box.height].map((v) => Math.round(v * 2) / 2).join(" ")];
    }));

  const STEERS = (action) =>
    "set_heading" in action || "adjust_heading" in action ||
    ("mode" in action && !["standby", "cancel"].includes(action.mode));

  // Taps three times at each of five points of every button, with or without an order that waits for CONFIRM; what then
  // left the page that moves the rudder. CONFIRM itself sends one order for three taps, and none where none waits.
  async function taps(font, armed) {
    const all = [];
    const buttons = [...document.querySelectorAll("button")].filter((b) => seen(b) && !b.matches(".tabs *"));
    for (const command of buttons.map((button) => button.dataset.command).filter(Boolean)) {
      const found = () => document.querySelector(`[data-command="${command}"]`);
      found().scrollIntoView({ block: "nearest" });
      const box = found().getBoundingClientRect();
      const points = [[0.5, 0.5], [0.1, 0.2], [0.9, 0.2], [0.1, 0.8], [0.9, 0.8]];
      for (const [across, down] of found().closest(".control") ? points : points.slice(0, 1)) {
        const [x, y] = [box.left + box.width * across, box.top + box.height * down];
        stage.sent.length = 0;
        if (armed) document.querySelector('[data-command="adjust+1"]').click();
        await stage.drawn();
        for (let tap = 0; tap < 3; tap += 1) {
          document.elementFromPoint(x, y)?.closest("button")?.click();
          await stage.drawn();
        }
        const orders = stage.sent.filter(STEERS);
        if (orders.length !== (armed && command === "confirm" ? 1 : 0)) all.push(`${font}: three taps on ${command} sent ${JSON.stringify(orders)}`);
        const taken = stage.sent.filter((action) => "acknowledge" in action);
        if (taken.length > 1) all.push(`${font}: three taps on ${command} took ${taken.length} alerts`);
        const cancel = document.querySelector('[data-command="cancel"]');
        if (!cancel.disabled) cancel.click();
        await stage.drawn();
      }
    }
    return all;
  }

  const wear = (font) => document.body.style.setProperty("font-family", `"${font}"`, "important");

  // Every state in every font: what is wrong, and what moved from one state to the next.
  window.eyes = {
    faults, places, taps, wear,
    look: async (states, fonts) => {
      const all = new Set();
      for (const font of fonts) {
        wear(font);
        let before = null;
        for (const state of states) {
          await stage.show(state);
          faults().forEach((fault) => all.add(`${font}, ${state.name}: ${fault}`));
          const now = places();
          for (const [command, place] of Object.entries(before || {}))
            if (now[command] !== place) all.add(`${font}, ${state.name}: ${command} moved from ${place} to ${now[command]}`);
          before = now;
          const cancel = document.querySelector('[data-command="cancel"]');
          if (state.press && !cancel.disabled) cancel.click();
        }
      }
      return [...all];
    },
    tap: async (state, fonts) => {
      const all = [];
      for (const font of fonts) {
        wear(font);
        await stage.show(state);
        all.push(...(await taps(font, false)), ...(await taps(font, true)));
      }
      return all;
    },
  };
})();
