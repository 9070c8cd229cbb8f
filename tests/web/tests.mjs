// What is tested, as a user would try it.

import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import assert from "node:assert/strict";
import {
  alone, at, differing, keepPicture, native, picture, play, profile, readPng, ready, settled, start, texts, visit, waitForText,
} from "./stage.mjs";

/** Scripts whose pictures depend on the very moment: balls roll, a point flies, a net learns, a solution is played. */
const MOVING = ["biliard", "csango_k", "gyongy_k", "som_fel", "csav_gy", "vjs"];

/** The same pixels, or both pictures are kept to be looked at. */
async function assertSame(ours, theirs, folder, name, pointer) {
  const count = differing(ours, theirs, pointer);
  if (!count) return;
  await keepPicture(ours, join(folder, `${name}-web.png`));
  await keepPicture(theirs, join(folder, `${name}-native.png`));
  assert.fail(`${name}: ${count} pixels differ; both pictures are in ${folder}`);
}

async function collected(names, check) {
  const problems = [];
  for (const name of names) {
    try {
      await check(name);
    } catch (error) {
      problems.push(`${name}: ${error.message}`);
    }
  }
  assert.deepEqual(problems, []);
}

const leave = (page) => page.evaluate(() => {
  location.hash = "";
});

const names = (page) =>
  page.evaluate(() => JSON.parse(globalThis.grafika.app.catalog()).flatMap(({ programs }) => programs.map(({ name }) => name)));

export const tests = {
  "every program starts with the pixels of its native script": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address);
    const programs = await names(page);
    assert.ok(programs.length >= 36, `${programs.length} programs`);
    for (const language of ["en", "hu"]) {
      await collected(programs, async (name) => {
        await start(page, address, `#program=${name}&lang=${language}&manner=today&seed=1`);
        const shot = `${name}-${language}.png`;
        await native(name, `lang ${language}\nmanner today\npointer on\nwait 50\nshot ${shot}\n`, folder);
        await assertSame(await picture(page), await readPng(join(folder, shot)), folder, `${name}-${language}`);
      });
    }
  }),

  "every sample opens with the pixels of its native script": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address);
    const pairs = await page.evaluate(() =>
      JSON.parse(globalThis.grafika.app.catalog()).flatMap(({ programs }) =>
        programs.flatMap(({ name, samples }) => samples.map((sample) => `${name} ${sample}`)),
      ),
    );
    await collected(pairs, async (pair) => {
      const [name, sample] = pair.split(" ");
      await start(page, address, `#program=${name}&open=${sample}&lang=en&manner=today&seed=1`);
      const shot = `${name}-${sample}.png`;
      await native(name, `lang en\nmanner today\npointer on\nwait 50\nshot ${shot}\n`, folder, [sample]);
      await assertSame(await picture(page), await readPng(join(folder, shot)), folder, `${name}-${sample}`);
    });
  }),

  "first steps lead to the pictures of the documentation": alone(async ({ context, address, folder, root }) => {
    const steps = join(root, "docs/first_steps");
    const scripts = (await readdir(steps)).filter((file) => file.endsWith(".script"));
    const page = await visit(context, address);
    await collected(scripts, async (file) => {
      const name = file.replace(".script", "");
      const script = await readFile(join(steps, file), "utf8");
      const [, program, sample] = script.split("\n")[0].split(/\s+/).filter((word) => word !== "#");
      const language = /^lang (\w+)$/m.exec(script)?.[1] ?? "hu";
      const manner = /^manner (\w+)$/m.exec(script)?.[1] ?? "1997";
      const open = sample ? `&open=${sample}` : "";
      await start(page, address, `#program=${program}${open}&lang=${language}&manner=${manner}&seed=1`);
      const mouse = await play(page, script);
      await page.waitForTimeout(60);
      if (MOVING.includes(name)) return;
      await assertSame(await picture(page), await readPng(join(steps, `${name}.png`)), folder, name, mouse);
    });
  }),

  "points are dragged, a spline is drawn, saved, found after loading again": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address, "#program=gb_2d_ip&lang=en&manner=today&seed=1");
    const model = () => page.evaluate(() => globalThis.grafika.app.model());
    await play(page, "key U\nclick 121 380\nclick 201 160\nclick 341 140\nclick 421 330\nclick 541 250");
    const before = await model();
    await play(page, "drag 341 140 321 220");
    assert.notEqual(await model(), before, "the point has moved");
    await play(page, "key 3");
    await play(page, "key Ctrl+S\ntype GORBE\nkey Enter");
    await page.waitForTimeout(200);
    // What the DOS file cannot hold goes into a JSON file beside it.
    if ((await texts(page)).includes("JSON")) await play(page, "key Enter");
    await page.waitForFunction(() => globalThis.grafika.files.has("gorbe.ip2"));
    await page.evaluate(() => globalThis.grafika.files.line);
    await play(page, "move 320 470");
    const ours = await picture(page);
    await page.reload();
    await ready(page);
    await start(page, address, "#program=gb_2d_ip&open=GORBE.IP2&lang=en&manner=today&seed=1");
    await play(page, "move 320 470\nwait 3000");
    assert.equal(await page.evaluate(() => globalThis.grafika.app.title()), "GB_2D_IP - GORBE.IP2");
    await assertSame(await picture(page), ours, folder, "reopened");
    await leave(page);
    await page.click("#show-files");
    await page.getByText("GORBE.IP2", { exact: true }).waitFor();
    const [load] = await Promise.all([page.waitForEvent("download"), page.click("#all")]);
    const zip = await readFile(await load.path());
    assert.equal(zip.readUInt32LE(0), 0x04034b50, "a ZIP file");
    assert.ok(zip.includes("GORBE.IP2"));
  }),

  "unsaved work is there again after loading again and after a crash": alone(async ({ context, address }) => {
    const hash = "#program=gb_2d_ip&lang=en&manner=today&seed=1";
    let page = await visit(context, address, hash);
    await play(page, "key U\nclick 121 380\nclick 201 160\nclick 341 140\nclick 421 330");
    await page.evaluate(() => globalThis.grafika.work.line);
    await page.reload();
    await ready(page);
    await waitForText(page, "ended unexpectedly");
    await play(page, "key Enter");
    const model = JSON.parse(await page.evaluate(() => globalThis.grafika.app.model()));
    assert.equal(countPoints(model), 4, JSON.stringify(model));
    // It is still unsaved: another page is not offered what this one works on.
    const other = await visit(context, address, hash);
    assert.ok(!(await texts(other)).includes("ended unexpectedly"));
    await other.close();
    await page.evaluate(() => globalThis.grafika.work.line);
    // The page is gone without a word.
    const session = await context.newCDPSession(page);
    session.send("Page.crash").catch(() => {});
    await new Promise((done) => page.once("crash", done));
    page = await visit(context, address, hash);
    await waitForText(page, "ended unexpectedly");
  }),

  "two pages do not lose each other's files": alone(async ({ context, address }) => {
    const one = await visit(context, address, "#program=gb_2d_ip&open=O.IP2&lang=en&manner=today");
    const other = await visit(context, address, "#program=gb_2d_ip&open=X.IP2&lang=en&manner=today");
    await one.bringToFront();
    await play(one, "key Ctrl+S\nkey Ctrl+S");
    await saveAs(one, "KOZOS");
    await other.waitForFunction(() => globalThis.grafika.app.file("KOZOS.IP2"));
    await other.bringToFront();
    await play(other, "key Ctrl+S");
    await other.waitForTimeout(150);
    await retype(other, "KOZOS");
    // The second page is asked before it replaces the first one's file.
    await waitForText(other, "KOZOS.IP2");
    await play(other, "key Esc");
    // Both at the same moment: nothing is replaced unseen.
    const content = [await one.evaluate(() => globalThis.grafika.app.file("KOZOS.IP2"))];
    await Promise.all(
      [one, other].map((page, at) =>
        page.evaluate((at) => {
          const { files } = globalThis.grafika;
          files.others = null;
          return files.save("EGYSZERRE.IP2", new Uint8Array([at, at]));
        }, at),
      ),
    );
    const kept = await one.evaluate(async () => {
      await globalThis.grafika.files.lookAtAll();
      return globalThis.grafika.files.list().map(({ name }) => name);
    });
    assert.deepEqual(kept.sort(), ["EGYSZERRE-2.IP2", "EGYSZERRE.IP2", "KOZOS.IP2"]);
    assert.ok(content[0]);
  }),

  "a dropped file is kept and opened": alone(async ({ context, address, root }) => {
    const page = await visit(context, address);
    const content = [...(await readFile(join(root, "data/X.IP2")))];
    await page.evaluate((content) => {
      const dropped = new DataTransfer();
      dropped.items.add(new File([new Uint8Array(content)], "SAJAT.IP2"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: dropped, bubbles: true, cancelable: true }));
    }, content);
    await page.waitForFunction(() => globalThis.grafika.running());
    await settled(page);
    const title = await page.evaluate(() => globalThis.grafika.app.title());
    assert.match(title, /SAJAT\.IP2/);
    const kept = await page.evaluate(() => [...globalThis.grafika.app.file("sajat.ip2")]);
    assert.deepEqual(kept, content);
  }),

  "a downloaded SVG is the native one": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address, "#program=gb_2d_ip&open=O.IP2&lang=en&manner=today&seed=1");
    const saved = () => page.evaluate(() => globalThis.grafika.files.list().map(({ name }) => name));
    let script = "key F10";
    await play(page, script);
    for (let more = 0; more < 12 && !(await saved()).length; more++) {
      await play(page, "key Enter");
      script += "\nkey Enter";
      await page.waitForTimeout(100);
    }
    const svg = await saved();
    assert.equal(svg.length, 1, `saved: ${svg}; on the screen: ${await texts(page)}`);
    const [load] = await Promise.all([page.waitForEvent("download"), page.click("#notes button")]);
    await native("gb_2d_ip", `lang en\nmanner today\n${script}\n`, folder, ["O.IP2"]);
    assert.equal(load.suggestedFilename(), svg[0]);
    const made = await readdir(folder);
    assert.ok(made.includes(svg[0]), `${svg[0]} among ${made}`);
    assert.deepEqual(await readFile(await load.path()), await readFile(join(folder, svg[0])));
  }),

  "a wheel four moves away is solved by touch": alone(
    async ({ context, address }) => {
      const page = await visit(context, address, "#program=gyongy_k&puzzle=4:1&lang=en&manner=today");
      const model = async () => JSON.parse(await page.evaluate(() => globalThis.grafika.app.model()));
      assert.equal((await model()).solved, false);
      // The keys of the strip are those of the program.
      const strip = page.locator("#strip");
      await strip.getByRole("button", { name: /^H: / }).waitFor();
      for (let move = 0; move < 4; move++) {
        await strip.getByRole("button", { name: /^H: / }).tap();
        await page.waitForFunction(() => JSON.parse(globalThis.grafika.app.model()).hint);
        const { hint } = await model();
        await tapMove(page, hint);
      }
      await page.waitForFunction(() => JSON.parse(globalThis.grafika.app.model()).solved);
      assert.equal((await model()).game.moves, 4);
    },
    { hasTouch: true, isMobile: true, viewport: { width: 400, height: 780 }, deviceScaleFactor: 2 },
  ),

  "fingers turn, zoom and press long": alone(
    async ({ context, address }) => {
      const page = await visit(context, address, "#program=zm_hspl&open=K1.ZMS&lang=en&manner=today");
      const model = () => page.evaluate(() => globalThis.grafika.app.model());
      const before = await model();
      const session = await context.newCDPSession(page);
      const touch = async (type, ...points) => {
        await session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
        await settled(page);
      };
      const [x, y] = await at(page, 320, 300);
      await touch("touchStart", [x - 40, y]);
      await touch("touchStart", [x - 40, y], [x + 40, y]);
      await touch("touchMove", [x - 80, y], [x + 80, y]);
      await touch("touchEnd");
      const zoomed = await model();
      assert.notEqual(zoomed, before, "two fingers zoom");
      await touch("touchStart", [x - 40, y]);
      await touch("touchStart", [x - 40, y], [x + 40, y]);
      for (const by of [15, 30, 45]) await touch("touchMove", [x - 40 + by, y], [x + 40 + by, y]);
      await touch("touchEnd");
      assert.notEqual(await model(), zoomed, "two fingers turn");
      const turned = await model();
      await touch("touchStart", [x, y]);
      await page.waitForTimeout(650);
      await touch("touchMove", [x + 50, y + 10]);
      await touch("touchEnd");
      assert.notEqual(await model(), turned, "a long press is the right button");
    },
    { hasTouch: true, isMobile: true, viewport: { width: 780, height: 600 }, deviceScaleFactor: 1 },
  ),

  "a shared address opens the same in a fresh profile": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address, "#program=gb_2d_ip&lang=en&manner=today&seed=1");
    await play(page, "key U\nclick 121 380\nclick 201 160\nclick 341 140\nclick 421 330\nkey 3\nmove 320 470");
    await page.click("#share");
    const link = await page.locator("#notes input").inputValue();
    assert.match(link, /#program=gb_2d_ip&doc=[\w-]+$/);
    const points = (page) => page.evaluate(() => globalThis.grafika.app.share());
    const ours = await points(page);
    const fresh = await profile();
    try {
      const other = await visit(fresh.context, "", link);
      assert.equal(await points(other), ours);
      const model = JSON.parse(await other.evaluate(() => globalThis.grafika.app.model()));
      assert.equal(countPoints(model), 4);
      await keepPicture(await picture(other), join(folder, "shared.png"));
      // A damaged address says so.
      await other.goto("about:blank");
      await other.goto(link.slice(0, -20));
      await other.locator("#notes .wrong").getByText("The address is not understood").waitFor();
      assert.equal(await other.evaluate(() => globalThis.grafika.running()), null);
    } finally {
      await fresh.shut();
    }
  }),

  "without a network it works after the first visit": alone(async ({ context, address, folder }) => {
    const page = await visit(context, address);
    await page.evaluate(() => navigator.serviceWorker.ready);
    await page.waitForFunction(async () => {
      const [name] = await caches.keys();
      return name && (await (await caches.open(name)).keys()).length > 40;
    });
    await context.setOffline(true);
    const away = address.replace(/\d+\/$/, (port) => port);
    await page.goto(`${away}#program=zm_hspl&open=K1.ZMS&lang=en&manner=today&seed=1`);
    await page.reload();
    await ready(page);
    await keepPicture(await picture(page), join(folder, "offline.png"));
    await leave(page);
    await page.waitForFunction(() => [...document.images].slice(0, 4).every((image) => image.complete && image.naturalWidth));
  }),

  "the keyboard alone opens, finds and leaves": alone(async ({ context, address }) => {
    const page = await visit(context, address);
    await page.focus("#search");
    await page.keyboard.type("bead wheel");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => globalThis.grafika.running());
    await settled(page);
    await page.evaluate(() => {
      globalThis.left = [];
      addEventListener("keydown", (event) => event.defaultPrevented || globalThis.left.push(event.key));
    });
    for (const key of ["F3", "F5", "F12", "F6"]) await page.keyboard.press(key);
    assert.deepEqual(await page.evaluate(() => globalThis.left), [], "no F-key is left to the browser");
    await page.keyboard.press("F1");
    await page.waitForFunction(() => document.getElementById("said").textContent.includes("beads of one colour"));
    await page.keyboard.press("Escape");
    await page.keyboard.press("F2");
    await page.waitForFunction(() => document.documentElement.lang === "hu");
    await page.keyboard.press("Shift+Tab");
    const focused = await page.evaluate(() => document.activeElement.id);
    assert.notEqual(focused, "canvas");
    await page.focus("#back");
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => !globalThis.grafika.running());
    assert.equal(await page.evaluate(() => document.activeElement.id), "search");
  }),

  "the settings are those that mean something": alone(async ({ context, address }) => {
    const page = await visit(context, address, "#program=gb_2d_ip&lang=en&manner=today");
    await play(page, "key F9");
    const standing = await texts(page);
    for (const there of ["Language", "Window look", "Colours", "Billiard cloth"]) assert.ok(standing.includes(there), there);
    for (const not of ["Folder", "Terminal", "Window size", "Display"]) assert.ok(!standing.includes(not), not);
  }),
};

/** Control points of a model, wherever they are in it. */
function countPoints(model) {
  const found = [];
  const walk = (value) => {
    if (!value || typeof value !== "object") return;
    if (Array.isArray(value.points)) found.push(value.points.length);
    Object.values(value).forEach(walk);
  };
  walk(model);
  return found[0];
}

async function retype(page, name) {
  // A proposal is replaced by what is typed.
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
  await page.waitForTimeout(200);
}

async function saveAs(page, name) {
  await page.waitForTimeout(150);
  await retype(page, name);
  await page.waitForFunction((name) => globalThis.grafika.files.has(`${name}.IP2`), name);
  await page.evaluate(() => globalThis.grafika.files.line);
}

/** Makes a move of the wheel with a finger: a tap on its key in the strip. */
async function tapMove(page, letter) {
  await page.locator("#strip").getByRole("button", { name: new RegExp(`^${letter}: `) }).tap();
  await settled(page);
}
