// The page: starts the module, gives it what happens, shows the start page or a program as the address says.

import init, { App } from "./glue/grafika_web.js";
import { Files, Work, recall, remember } from "./store.js";
import { Shelf, download } from "./files.js";
import { Strip } from "./touch.js";
import { note, button } from "./notes.js";
import { say, speak, spoken } from "./words.js";
import * as start from "./start.js";

const $ = (id) => document.getElementById(id);
const [stage, canvas, said, standing] = [$("stage"), $("canvas"), $("said"), $("screen")];

let app;
let catalog;
/** How the program that runs was begun; null on the start page. */
let running = null;
/** What is begun when it has closed. */
let pending = null;
let frame = 0;
let timer = 0;

const coarse = () => matchMedia("(pointer: coarse)").matches;

/** What is measured for tests: the longest time that the module took at once, and the number of pictures. */
const measured = { longest: 0, pictures: 0, spent: 0 };

/** Calls the module. What it throws as a text is for the user; anything else has broken it. */
function call(work) {
  const before = performance.now();
  try {
    return work(before);
  } catch (error) {
    if (typeof error === "string") throw error;
    broken(error);
    throw error;
  } finally {
    const took = performance.now() - before;
    measured.spent += took;
    measured.longest = Math.max(measured.longest, took);
  }
}

function broken(error) {
  running = null;
  console.error(error);
  note(say("failed") + (error.message ?? error), { wrong: true, stay: 0, parts: [button("↻", () => location.reload())] });
}

// --- Files and work ------------------------------------------------------------------------------------------------------

const whole = (error) => error?.message ?? String(error);
let toldTrouble = false;

const files = new Files({
  arrived: (name, content) => {
    app.setFile(name, content);
    shelf?.refresh();
  },
  gone: (name) => {
    app.removeFile(name);
    shelf?.refresh();
  },
  conflict: (name) => note(say("conflict") + name, { stay: 0 }),
  trouble: (error) => {
    if (!toldTrouble) note(say("notKept").replace("{why}", whole(error)), { wrong: true, stay: 0 });
    toldTrouble = true;
  },
});
const work = new Work((error) => app?.workTrouble(whole(error)));
let shelf;
let strip;

/** What the module asks of the page. It is in the middle of something then, and must not be called. */
const host = {
  recall,
  remember,
  saved(name, content) {
    const copy = content.slice();
    queueMicrotask(async () => {
      const kept = await files.save(name, copy);
      shelf.refresh();
      note(say("saved") + name, { parts: [button(say("download"), () => download(name, copy))] });
      if (kept) navigator.storage?.persist?.();
    });
  },
  keepWork: (program, file, content) => work.keep(program, file, content),
  forgetWork: () => work.forget(),
  settleWork(id, verdict) {
    const lost = running?.left.find((left) => left.id === id);
    work.settle(id, verdict);
    if (verdict === "broken" && lost) {
      const name = `lost-${lost.program}-${Date.now()}.txt`;
      const content = new TextEncoder().encode(lost.content);
      queueMicrotask(() => {
        app.setFile(name, content);
        files.save(name, content);
      });
    }
  },
};

// --- The program ---------------------------------------------------------------------------------------------------------

/** Comes back in time for the next picture. */
function soon() {
  if (!frame) frame = requestAnimationFrame(step);
}

function step() {
  frame = 0;
  clearTimeout(timer);
  if (!running) return;
  let due;
  try {
    due = call((now) => app.step(now));
  } catch (error) {
    if (typeof error === "string") note(error, { wrong: true });
    due = running ? -2 : -3;
  }
  measured.pictures++;
  if (due === -2) return ended();
  if (due === -3) return;
  // Whoever answers that the program stays, stays.
  if (pending && !app.asked()) pending = null;
  const wait = due - performance.now();
  if (due >= 0) {
    if (wait <= 18) soon();
    else timer = setTimeout(soon, wait - 8);
  }
  later();
}

/** What may come a little later than the picture: title, language, keys, and the texts for those who listen. */
let laterTimer = 0;
function later() {
  if (!laterTimer) laterTimer = setTimeout(tell, 150);
}

let lines = [];
function tell() {
  laterTimer = 0;
  if (!running) return;
  const title = app.title();
  if ($("title").textContent !== title) {
    $("title").textContent = title;
    document.title = `${title} – grafika`;
    canvas.setAttribute("aria-label", title);
  }
  if (app.language() !== spoken()) {
    speak(app.language());
    start.show(catalog);
  }
  strip.draw();
  const texts = app.texts();
  if (standing.textContent === texts) return;
  standing.textContent = texts;
  const before = new Set(lines);
  lines = texts.split("\n").filter(Boolean);
  const fresh = lines.filter((line) => !before.has(line)).slice(0, 40);
  if (!fresh.length) return;
  const entry = document.createElement("p");
  entry.textContent = fresh.join("\n");
  said.append(entry);
  while (said.children.length > 8) said.firstChild.remove();
}

function ended() {
  running = null;
  clearTimeout(timer);
  work.releaseAll();
  const next = pending;
  pending = null;
  if (next) begin(next);
  else {
    history.replaceState(null, "", location.pathname + location.search);
    showStart();
  }
}

function parse(hash) {
  const given = Object.fromEntries(new URLSearchParams(hash.replace(/^#/, "")));
  return given.program ? given : null;
}

const written = (parts) => `#${new URLSearchParams(parts)}`;

/** Begins what the address says. */
async function begin(parts) {
  const { program, open, doc, puzzle, manner, lang: language, seed } = parts;
  const wanted = { program: program.toLowerCase(), open, doc, puzzle, manner, language };
  wanted.seed = Number.isSafeInteger(Number(seed)) && seed !== undefined ? Number(seed) : Date.now() % 1000000;
  wanted.left = await work.lost(wanted.program === "grafika" ? "" : wanted.program).catch(() => []);
  if (running) return;
  try {
    resize();
    call((now) => app.start(JSON.stringify(wanted), now));
  } catch (error) {
    work.releaseAll();
    if (typeof error !== "string") return;
    note(say("wrongAddress") + error, { wrong: true, stay: 20000 });
    history.replaceState(null, "", location.pathname + location.search);
    showStart();
    return;
  }
  running = { parts, left: wanted.left };
  lines = [];
  history.replaceState(null, "", written(parts));
  $("start").hidden = true;
  $("program").hidden = false;
  strip.draw(true);
  resize();
  canvas.focus({ preventScroll: true });
  step();
}

function showStart() {
  $("program").hidden = true;
  $("start").hidden = false;
  document.title = "grafika";
  const language = app.language();
  speak(language);
  $("language").textContent = say("other");
  start.show(catalog);
  // On a phone that would bring up its keyboard.
  if (!coarse()) $("search").focus({ preventScroll: true });
}

/** Another address: the program that runs is asked to close first. */
function route() {
  const wanted = parse(location.hash);
  if (!running) {
    if (wanted) begin(wanted);
    else showStart();
    return;
  }
  if (wanted && written(wanted) === written(running.parts)) return;
  history.replaceState(null, "", written(running.parts));
  leave(wanted);
}

function leave(next) {
  pending = next;
  call((now) => app.close(now));
  step();
}

/** Opens something from the page itself. */
function open(parts) {
  if (running) leave(parts);
  else begin(parts);
}

// --- What happens --------------------------------------------------------------------------------------------------------

function resize() {
  const { width, height } = stage.getBoundingClientRect();
  if (width && height) app.resize(width, height, devicePixelRatio);
  soon();
}

function listen() {
  const guarded = (work) => {
    if (!running) return undefined;
    const result = call(work);
    soon();
    return result;
  };
  const held = (event) => guarded((now) => app.hold(event.shiftKey, event.ctrlKey, now));

  addEventListener("keydown", (event) => {
    if (!running || document.querySelector("dialog[open]")) return;
    if (event.key === "F11") {
      event.preventDefault();
      if (!event.repeat && !event.ctrlKey) return fullScreen();
    }
    // Buttons of the page are worked by keys too; F-keys are always the program's.
    const own = document.activeElement !== canvas && document.activeElement !== document.body;
    if (own && !/^F\d+$/.test(event.key)) return;
    if (event.key === "Tab" && event.shiftKey) return;
    held(event);
    const third = event.getModifierState("AltGraph");
    const taken = guarded((now) => app.key(event.key, event.code, event.ctrlKey, event.altKey, event.metaKey, third, now));
    if (taken) event.preventDefault();
  });
  addEventListener("keyup", held);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  stage.addEventListener("contextmenu", (event) => event.preventDefault());

  const place = (event) => {
    const { left, top } = stage.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  };
  const pointer = (phase) => (event) => {
    if (event.pointerType === "touch") {
      const [x, y] = place(event);
      guarded((now) => app.finger(event.pointerId, phase, x, y, now));
    } else {
      if (phase === "down") held(event);
      for (const one of phase === "move" ? (event.getCoalescedEvents?.().slice(-1) ?? [event]) : [event]) {
        const [x, y] = place(one);
        guarded((now) => app.mouse(x, y, phase === "cancel" ? 0 : event.buttons, now));
      }
    }
    if (phase === "down") {
      canvas.focus({ preventScroll: true });
      stage.setPointerCapture(event.pointerId);
      event.preventDefault();
    }
  };
  stage.addEventListener("pointerdown", pointer("down"));
  stage.addEventListener("pointermove", pointer("move"));
  stage.addEventListener("pointerup", pointer("up"));
  stage.addEventListener("pointercancel", pointer("cancel"));
  stage.addEventListener(
    "wheel",
    (event) => {
      if (event.ctrlKey && event.deltaMode === 0 && Math.abs(event.deltaY) < 50) {
        // Two fingers on a touchpad, as browsers tell them.
        guarded((now) => app.wheel(event.deltaY * 8, now));
      } else {
        guarded((now) => app.wheel(event.deltaY * [1, 33.4, 400][event.deltaMode], now));
      }
      event.preventDefault();
    },
    { passive: false },
  );
  addEventListener("blur", () => guarded((now) => app.letGo(now)));
  new ResizeObserver(resize).observe(stage);
  addEventListener("resize", resize);
  addEventListener("hashchange", route);

  $("back").onclick = () => leave(null);
  $("share").onclick = share;
  $("full").onclick = fullScreen;
  $("files-too").onclick = $("show-files").onclick = () => shelf.show();
  $("files").addEventListener("close", () => running && canvas.focus({ preventScroll: true }));
  $("language").onclick = () => {
    app.setLanguage(spoken() === "hu" ? "en" : "hu");
    showStart();
  };
}

function fullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => {});
  canvas.focus({ preventScroll: true });
}

async function share() {
  const hash = app.share();
  if (!hash) return note(say("noShare"));
  const address = `${location.origin}${location.pathname}#${hash}`;
  const field = document.createElement("input");
  field.readOnly = true;
  field.value = address;
  field.setAttribute("aria-label", say("share"));
  field.onfocus = () => field.select();
  let copied = false;
  try {
    await navigator.clipboard.writeText(address);
    copied = true;
  } catch {
    // The field is there to be copied from.
  }
  note(say(copied ? "copied" : "copy"), { parts: [field], stay: 30000 });
  if (address.length > 8000) note(say("longAddress").replace("{n}", address.length));
  canvas.focus({ preventScroll: true });
}

// --- Here it begins ------------------------------------------------------------------------------------------------------

async function main() {
  const usual = navigator.languages?.some((code) => code.toLowerCase().startsWith("hu")) ? "hu" : "en";
  speak(usual);
  await init({ module_or_path: new URL("glue/grafika_web_bg.wasm", import.meta.url) });
  // On small screens whole pixels would leave much of the place empty.
  if (coarse() && !recall("settings")) remember("settings", JSON.stringify({ look: "fill" }));
  app = new App(host, canvas, usual);
  catalog = JSON.parse(app.catalog());
  shelf = new Shelf(app, files, open);
  strip = new Strip(app, (name) => {
    if (!running) return;
    call((now) => app.press(name, now));
    soon();
  });
  start.listen(catalog);
  listen();
  // A browser that keeps nothing still runs the programs.
  await Promise.all([files.load(), work.load()]).catch((error) => files.told.trouble(error));
  route();
  globalThis.grafika = { app, files, work, measured, running: () => running };
  document.documentElement.dataset.ready = "yes";
  if (navigator.serviceWorker && location.protocol.startsWith("http")) {
    const known = Boolean(navigator.serviceWorker.controller);
    const registered = await navigator.serviceWorker.register("sw.js").catch(() => null);
    registered?.addEventListener("updatefound", () => known && note(say("newer")));
  }
}

main().catch((error) => {
  console.error(error);
  note(say("noWasm") + whole(error), { wrong: true, stay: 0 });
});
