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
  const own = join(made, name.replaceAll(/\W+/g, "_"));
  await mkdir(own, { recursive: true });
  // A browser on a busy machine may be late once; what fails twice is wrong.
  for (let tries = 1; tries <= 2; tries++) {
    const began = performance.now();
    try {
      await test({ address: server.address, folder: own, root: fileURLToPath(new URL("../..", import.meta.url)) });
      const taken = ((performance.now() - began) / 1000).toFixed(1);
      console.log(`ok    ${name} (${taken} s${tries > 1 ? ", at the second try" : ""})`);
      break;
    } catch (error) {
      console.log(`FAILED ${name}: ${error.stack ?? error}`);
      if (tries === 2) failures++;
    }
  }
}
server.close();
console.log(failures ? `${failures} failed` : "all passed");
process.exit(failures ? 1 : 0);
