// How long the module takes at once, in milliseconds, as a user plays: node tests/web/measure.mjs FOLDER.
// `scripts/web --measure` starts it.

import { resolve } from "node:path";
import { alone, play, serve, start, visit } from "./stage.mjs";

const FRAMES = 90;

/** What the page has counted while something was done. */
async function counted(page, work) {
  await page.evaluate(() => Object.assign(globalThis.grafika.measured, { longest: 0, pictures: 0, spent: 0 }));
  await work();
  return page.evaluate(() => ({ ...globalThis.grafika.measured }));
}

const search = (hash, script) =>
  alone(async ({ context, address }) => {
    const page = await visit(context, address, hash);
    return counted(page, () => play(page, script));
  });

/** A filled surface that an arrow turns at every frame. */
const turning = alone(async ({ context, address }) => {
  const page = await visit(context, address, "#program=zm_hspl&open=K1.ZMS&lang=en&manner=today");
  await play(page, "key F\nkey T");
  const all = await counted(page, () =>
    page.evaluate(async (frames) => {
      const key = new KeyboardEvent("keydown", { key: "ArrowRight", code: "ArrowRight", bubbles: true });
      for (let frame = 0; frame < frames; frame++) {
        document.getElementById("canvas").dispatchEvent(key);
        await new Promise((next) => requestAnimationFrame(next));
      }
    }, FRAMES),
  );
  return { ...all, each: all.spent / FRAMES };
});

/** From an empty browser to the first picture of a program. */
const first = alone(async ({ context, address }) => {
  const page = await context.newPage();
  const begun = performance.now();
  await page.goto("about:blank");
  await start(page, address, "#program=gb_2d_ip&open=O.IP2&lang=en&manner=today");
  return { longest: performance.now() - begun };
});

const measures = {
  "first picture": first,
  "bead wheel, a solution": search("#program=gyongy_k&puzzle=1:7&lang=en&manner=today", "key O\nwait 4000"),
  "cube, a solution": search("#program=csango_k&lang=en&manner=today", "key Enter\nkey Enter\nkey O\nwait 3000"),
  "filled surface, turning": turning,
};

const server = await serve(resolve(process.argv[2]));
for (const [name, measure] of Object.entries(measures)) {
  const { longest, spent = 0, pictures = 0, each } = await measure({ address: server.address });
  const [most, whole] = [longest, spent].map((time) => time.toFixed(1));
  const mean = each ? `, ${each.toFixed(1)} ms a picture` : "";
  console.log(`${name}: at most ${most} ms at once, ${whole} ms in ${pictures} pictures${mean}`);
}
server.close();
process.exit(0);
