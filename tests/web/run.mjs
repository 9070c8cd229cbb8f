// Tests the browser edition in a headless Chromium: node tests/web/run.mjs FOLDER [TEST ...]. `scripts/web --test` starts it.

import { mkdtemp, mkdir } from "node:fs/promises";
import { join, resolve } from "node:path";
import { tmpdir } from "node:os";
import { fileURLToPath } from "node:url";
import { serve } from "./stage.mjs";
import { tests } from "./tests.mjs";

const [folder, ...wanted] = process.argv.slice(2);
const server = await serve(resolve(folder));
const made = await mkdtemp(join(tmpdir(), "grafika-web-test-"));
console.log(`what is made lies in ${made}`);
let failures = 0;
for (const [name, test] of Object.entries(tests)) {
  if (wanted.length && !wanted.some((part) => name.includes(part))) continue;
  const began = performance.now();
  const own = join(made, name.replaceAll(/\W+/g, "_"));
  await mkdir(own, { recursive: true });
  try {
    await test({ address: server.address, folder: own, root: fileURLToPath(new URL("../..", import.meta.url)) });
    console.log(`ok    ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failures++;
    console.log(`FAILED ${name}: ${error.stack ?? error}`);
  }
}
server.close();
console.log(failures ? `${failures} failed` : "all passed");
process.exit(failures ? 1 : 0);
