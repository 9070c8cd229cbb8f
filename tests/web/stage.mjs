// What the tests of the browser edition stand on: a server, a browser, scripts played on a page, and pictures compared.

import { createServer } from "node:http";
import { readFile, mkdtemp, rm, writeFile } from "node:fs/promises";
import { execFile } from "node:child_process";
import { createRequire } from "node:module";
import { extname, join, resolve } from "node:path";
import { tmpdir } from "node:os";

const require = createRequire(resolve(process.env.NODE_MODULES, "x.js"));
const { chromium } = require("playwright-core");
export const { PNG } = require("pngjs");

const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".webmanifest": "application/manifest+json",
};

/** A static server of a folder, as any other. */
export async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = new URL(request.url, "http://x").pathname;
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    try {
      const content = await readFile(file);
      response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream" });
      response.end(content);
    } catch {
      response.writeHead(404);
      response.end();
    }
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  return { address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close() };
}

const FLAGS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync",
];

/** A browser with a profile of its own, which is deleted at the end. */
export async function profile(options = {}) {
  const folder = await mkdtemp(join(tmpdir(), "grafika-web-"));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: FLAGS,
    viewport: { width: 660, height: 560 },
    locale: "en-US",
    acceptDownloads: true,
    ...options,
  });
  const shut = async () => {
    await context.close();
    await rm(folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  };
  return { context, shut };
}

/** Runs a test in a browser of its own. */
export const alone =
  (test, options = {}) =>
  async (given) => {
    const { context, shut } = await profile(options);
    try {
      return await test({ ...given, context });
    } finally {
      await shut();
    }
  };

/** A page with a program on it. */
export async function visit(context, address, hash = "") {
  const page = await context.newPage();
  page.on("pageerror", (error) => console.error("  page:", error.message));
  page.on("console", (message) => message.type() === "error" && console.error("  console:", message.text()));
  await page.goto(`${address}${hash}`);
  await ready(page, hash.includes("program="));
  return page;
}

export async function ready(page, program = true) {
  await page.waitForFunction(() => document.documentElement.dataset.ready === "yes");
  if (program) await page.waitForFunction(() => globalThis.grafika.running());
  await settled(page);
}

/** Begins a program anew on a page. */
export async function start(page, address, hash) {
  await page.goto("about:blank");
  await page.goto(`${address}${hash}`);
  await ready(page);
}

/** Waits until what has happened is painted. */
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 0)))));

/** The picture as the canvas shows it; it must stand there pixel by pixel. */
export async function picture(page) {
  const shown = await page.evaluate(() => {
    const canvas = document.getElementById("canvas");
    const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let text = "";
    for (let at = 0; at < data.length; at += 32768) text += String.fromCharCode(...data.subarray(at, at + 32768));
    return { width, height, data: btoa(text) };
  });
  if (shown.width !== 640 || shown.height !== 480) throw new Error(`the canvas is ${shown.width}x${shown.height}`);
  return Buffer.from(shown.data, "base64");
}

/** How many pixels differ; `pointer` is where the mouse pointer stands that only one of them shows. */
export function differing(one, other, pointer) {
  let count = 0;
  for (let at = 0; at < one.length; at += 4) {
    const [x, y] = [(at / 4) % 640, Math.floor(at / 4 / 640)];
    if (pointer && Math.abs(x - pointer[0]) <= 16 && Math.abs(y - pointer[1]) <= 24) continue;
    if (one.readUInt32BE(at) !== other.readUInt32BE(at)) count++;
  }
  return count;
}

export async function keepPicture(rgba, file) {
  const png = new PNG({ width: 640, height: 480 });
  rgba.copy(png.data);
  await writeFile(file, PNG.sync.write(png));
}

export const readPng = async (file) => PNG.sync.read(await readFile(file)).data;

/** Plays a script with the native program in a folder; `shot` and `dump` write there. */
export function native(name, script, folder, more = []) {
  const line = [name, ...more, "--script", "-"];
  return new Promise((done, failed) => {
    const child = execFile(resolve(process.env.GRAFIKA), line, { cwd: folder }, (error, _, stderr) =>
      error ? failed(new Error(`${line.join(" ")}: ${stderr || error.message}`)) : done(),
    );
    child.stdin.end(script);
  });
}

const NAMES = { Esc: "Escape", Up: "ArrowUp", Down: "ArrowDown", Left: "ArrowLeft", Right: "ArrowRight", Space: " " };

async function press(page, name) {
  const ctrl = name.startsWith("Ctrl+");
  const bare = ctrl ? name.slice(5) : name;
  if (ctrl) await page.keyboard.down("Control");
  await page.keyboard.press(NAMES[bare] ?? (bare.length === 1 && ctrl ? bare.toLowerCase() : bare));
  if (ctrl) await page.keyboard.up("Control");
}

/** Where a pixel of the picture is on the page. */
export async function at(page, x, y) {
  const box = await page.locator("#canvas").boundingBox();
  return [box.x + ((x + 0.5) * box.width) / 640, box.y + ((y + 0.5) * box.height) / 480];
}

/** Plays a script on the page as a user would. Returns where the mouse has got to. */
export async function play(page, script) {
  let mouse = [320, 240];
  const move = async (x, y) => {
    mouse = [Number(x), Number(y)];
    await page.mouse.move(...(await at(page, ...mouse)));
  };
  for (const line of script.split("\n").map((line) => line.trim())) {
    const [word, ...rest] = line.split(/\s+/);
    if (!word || word.startsWith("#") || ["lang", "manner", "shot", "dump", "pointer"].includes(word)) continue;
    if (word === "key") await press(page, rest[0]);
    else if (word === "type") await page.keyboard.type(line.slice(5));
    else if (word === "move") await move(...rest);
    else if (word === "press" || word === "release") {
      const held = { shift: "Shift", ctrl: "Control" }[rest[0]];
      const down = word === "press";
      if (held) await page.keyboard[down ? "down" : "up"](held);
      else await page.mouse[down ? "down" : "up"]({ button: rest[0] });
    } else if (word === "click" || word === "drag") {
      const button = rest[word === "click" ? 2 : 4] ?? "left";
      await move(rest[0], rest[1]);
      await page.mouse.down({ button });
      if (word === "drag") await move(rest[2], rest[3]);
      await page.mouse.up({ button });
    } else if (word === "wheel") await page.mouse.wheel(0, -100 * Number(rest[0]));
    else if (word === "wait") await page.waitForTimeout(Math.min(Number(rest[0]), 4000));
    else throw new Error(`the page cannot play: ${line}`);
    await settled(page);
  }
  return mouse;
}

/** One text after the other, as the user reads them. */
export const texts = (page) => page.evaluate(() => globalThis.grafika.app.texts());

export async function waitForText(page, text, patience = 10000) {
  await page.waitForFunction((text) => globalThis.grafika.app.texts().includes(text), text, { timeout: patience });
}
