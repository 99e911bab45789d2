// Opens dashboards of made-up stores from file:// and reads them as people would.
// usage: node dashboard_page.test.mjs PATH/alcove_write_nights

import assert from "node:assert/strict";
import { join } from "node:path";
import { openPage, runTests } from "./browser.mjs";

if (process.argv.length !== 3) {
  console.error("usage: node dashboard_page.test.mjs PATH/alcove_write_nights");
  process.exit(2);
}

function openDashboard(browser, folder, store, options = {}) {
  return openPage(browser, join(folder, store, "dashboard", "index.html"), { viewport: { width: 1300, height: 900 }, ...options });
}

function sumPixels(canvas) {
  return canvas.evaluate((element) => {
    const { data } = element.getContext("2d").getImageData(0, 0, element.width, element.height);
    let sum = 0;
    for (let i = 3; i < data.length; i += 4) {
      sum += data[i] > 0 ? 1 : 0;
    }
    return sum;
  });
}

const tests = {
  async "what the last night found stands first, in words"(browser, folder) {
    const { page, troubles, close } = await openDashboard(browser, folder, "steps");
    const first = page.locator("main section").first();
    assert.match(await first.locator("h2").textContent(), /Last night of nightly/);
    assert.match(await first.locator("tbody").textContent(), /worse.*image changed/s);
    assert.match(await page.locator("main section").nth(1).textContent(), /Earlier steps.*slower.*software/s);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "200 series are drawn as one scrolls, and let go again, without an error"(browser, folder) {
    const { page, troubles, close } = await openDashboard(browser, folder, "steps");
    const figures = page.locator("main section:nth-of-type(3) figure[data-series]");
    const count = await figures.count();
    assert.equal(count, 25 * 6, "a chart a series; milliseconds and images stand in those of their cell");
    const first = figures.first().locator("canvas");
    await first.waitFor();
    assert.ok((await sumPixels(first)) > 2000, "the first chart has pixels");
    assert.ok((await page.locator("canvas").count()) < 40, "the others wait");
    for (const index of [60, count - 1]) {
      await figures.nth(index).scrollIntoViewIfNeeded();
      await figures.nth(index).locator("canvas").waitFor();
    }
    assert.equal(await figures.first().locator("canvas").count(), 0, "far away, a chart is let go");
    await figures.first().scrollIntoViewIfNeeded();
    await first.waitFor();
    assert.deepEqual(troubles, []);
    await close();
  },

  async "a night under the pointer is read with its fence, its device and its build"(browser, folder) {
    const { page, troubles, close } = await openDashboard(browser, folder, "steps");
    const figure = page.locator("main section:nth-of-type(3) figure[data-series]").first();
    await figure.locator(".u-over").hover();
    const reading = await figure.locator(".history-reading").textContent();
    assert.match(reading, /^2026-01-\d\d: [\d.]+ x anchor, software, fence .* ms, software, build 00112233 commit \d+$/);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "light and dark differ and redraw"(browser, folder) {
    const { page, troubles, close } = await openDashboard(browser, folder, "steps", { colorScheme: "light" });
    const canvas = page.locator("canvas").first();
    await canvas.waitFor();
    const light = await canvas.evaluate((element) => element.toDataURL());
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForFunction((before) => document.querySelector("canvas")?.toDataURL() !== before, light);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "without the script the tables say it all"(browser, folder) {
    const { page, close } = await openDashboard(browser, folder, "steps", { javaScriptEnabled: false });
    assert.ok(await page.locator(".notice").isVisible());
    await page.locator("summary").first().click();
    const rows = page.locator("main section:nth-of-type(3) tbody tr");
    assert.equal(await rows.count(), 200);
    assert.match(await rows.first().textContent(), /method_0.*x anchor.*software/s);
    await close();
  },

  async "what a store calls its methods stays text"(browser, folder) {
    const { page, troubles, close } = await openDashboard(browser, folder, "hostile");
    await page.locator("canvas").first().waitFor();
    assert.equal(await page.title(), "Alcove: dashboard");
    assert.equal(await page.locator("main img, main script").count(), 0);
    assert.match(await page.locator("main h3").first().textContent(), /<img src=x onerror/);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "nothing is wider than the window"(browser, folder) {
    for (const width of [380, 1300]) {
      const { page, close } = await openDashboard(browser, folder, "steps", { viewport: { width, height: 800 } });
      await page.locator("canvas").first().waitFor();
      const over = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
      assert.ok(over <= 0, `at ${width} px the page is ${over} px too wide`);
      await close();
    }
  },
};

await runTests(tests, process.argv[2]);
