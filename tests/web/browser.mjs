// Finds what the browser test needs and starts it. A missing part skips the test with its reason (exit code 77).

import { execFileSync } from "node:child_process";
import { accessSync, constants, mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";
import { pathToFileURL } from "node:url";

export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

function findChromium() {
  const candidates = process.env.CHROMIUM
    ? [process.env.CHROMIUM]
    : (process.env.PATH ?? "").split(delimiter).map((folder) => join(folder, "chromium"));
  const found = candidates.find((path) => {
    try {
      accessSync(path, constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
  return found ?? skip("no chromium on PATH and none in $CHROMIUM");
}

function loadPlaywright() {
  try {
    return createRequire(import.meta.url)("playwright-core").chromium;
  } catch {
    return skip("playwright-core is missing: run npm ci");
  }
}

/** Writes the synthetic runs into a new folder, opens a browser, and removes both whatever happens. */
async function withBrowser(writeSynthetic, act) {
  const chromium = loadPlaywright();
  const executablePath = findChromium();
  const folder = mkdtempSync(join(tmpdir(), "alcove-web-"));
  let browser;
  try {
    execFileSync(writeSynthetic, [folder], { stdio: "inherit" });
    browser = await chromium.launch({
      executablePath,
      headless: true,
      args: ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync"],
    });
    await act(browser, folder);
  } finally {
    await browser?.close();
    rmSync(folder, { recursive: true, force: true });
  }
}

/** A page from a file that collects everything that must not happen. */
export async function openPage(browser, path, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const troubles = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && troubles.push(message.text()));
  page.on("pageerror", (error) => troubles.push(error.message));
  page.on("request", (request) => request.url().startsWith("file:") || troubles.push(`request ${request.url()}`));
  await page.goto(pathToFileURL(path).href);
  return { page, troubles, close: () => context.close() };
}

/** Runs every test on what the program writes, however many of them fail. */
export async function runTests(tests, writeSynthetic) {
  await withBrowser(writeSynthetic, async (browser, folder) => {
    let failed = 0;
    for (const [name, test] of Object.entries(tests)) {
      try {
        await test(browser, folder);
        console.log(`ok: ${name}`);
      } catch (error) {
        ++failed;
        console.log(`FAILED: ${name}\n${error.stack}`);
      }
    }
    console.log(`${Object.keys(tests).length - failed} of ${Object.keys(tests).length} passed`);
    process.exitCode = failed > 0 ? 1 : 0;
  });
}
