// Opens the synthetic reports from file:// and uses them as a reader would.
// usage: node report_page.test.mjs PATH/alcove_write_synthetic

import assert from "node:assert/strict";
import { join } from "node:path";
import { openPage, runTests } from "./browser.mjs";

if (process.argv.length !== 3) {
  console.error("usage: node report_page.test.mjs PATH/alcove_write_synthetic");
  process.exit(2);
}

const width = 1000;

function openReport(browser, folder, run, options = {}) {
  return openPage(browser, join(folder, run, "report", "index.html"), { viewport: { width, height: 900 }, ...options });
}

/** Pixels that are not transparent, and a sum that changes when the drawing does. */
function readCanvas(canvas) {
  return canvas.evaluate((element) => {
    const { data } = element.getContext("2d").getImageData(0, 0, element.width, element.height);
    let drawn = 0;
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      drawn += data[i + 3] > 0 ? 1 : 0;
      sum = (sum * 31 + data[i] + 7 * data[i + 1] + 13 * data[i + 2] + data[i + 3]) % 1000000007;
    }
    return { drawn, sum };
  });
}

async function checkNoOverflow(page) {
  const over = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok(over <= 0, `the page is ${over} px wider than the window`);
}

async function waitForImage(image) {
  await image.evaluate((element) => element.decode());
  assert.ok(await image.evaluate((element) => element.naturalWidth > 0), "the picture is loaded");
}

const tests = {
  async "charts are drawn in light and dark, without errors and without a network"(browser, folder) {
    for (const colorScheme of ["light", "dark"]) {
      const { page, troubles, close } = await openReport(browser, folder, "complete", { colorScheme });
      const canvases = page.locator("canvas");
      assert.equal(await canvases.count(), 6, "three charts a round");
      for (let i = 0; i < 6; ++i) {
        assert.ok((await readCanvas(canvases.nth(i))).drawn > 2000, `chart ${i} has pixels`);
      }
      await checkNoOverflow(page);
      assert.deepEqual(troubles, []);
      await close();
    }
  },

  async "another metric, state or set of curves redraws the charts"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const section = page.locator("#round-r0-balls");
    const scatter = section.locator('[data-chart="scatter"]');
    const before = await readCanvas(scatter.locator("canvas"));
    await scatter.getByLabel("State").selectOption("converged");
    const converged = await readCanvas(scatter.locator("canvas"));
    assert.notEqual(converged.sum, before.sum);
    await scatter.getByLabel("Metric").selectOption("ssim");
    assert.notEqual((await readCanvas(scatter.locator("canvas"))).sum, converged.sum);

    const times = section.locator('[data-chart="times"]');
    const all = await readCanvas(times.locator("canvas"));
    const chip = times.getByRole("button", { name: "tssao" });
    await chip.click();
    assert.equal(await chip.getAttribute("aria-pressed"), "false");
    assert.notEqual((await readCanvas(times.locator("canvas"))).sum, all.sum);
    await times.locator(".u-over").hover();
    assert.match(await times.locator(".axis-reading").textContent(), /^frame \d+$/);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "frame, method and picture switch what is shown"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const viewer = page.locator('[data-viewer="r0-balls"]');
    const images = viewer.locator(".pane img");
    const source = () => images.first().getAttribute("src");
    assert.equal(await source(), "../images/r0-balls/hemisphere_ssao/0006_visibility.png");
    await waitForImage(images.first());
    await viewer.getByRole("button", { name: "54" }).click();
    assert.match(await source(), /hemisphere_ssao\/0054_visibility/);
    await viewer.getByRole("button", { name: "Error map" }).click();
    assert.match(await source(), /0054_error/);
    await viewer.getByLabel("Method", { exact: true }).selectOption("tssao");
    assert.match(await source(), /tssao\/0054_error/);
    await viewer.getByRole("button", { name: "Shaded reference" }).click();
    assert.match(await source(), /reference\/0054_shaded/);
    await waitForImage(images.first());

    await viewer.focus();
    await page.keyboard.press("1");
    await page.keyboard.press("ArrowRight");
    assert.match(await source(), /tssao\/0090_visibility/);
    await page.keyboard.press("p");
    assert.match(await source(), /hemisphere_ssao-samples64\/0090_visibility/);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "a round of radiance shows its pictures, and the film begins with them"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "radiance");
    const viewer = page.locator('[data-viewer="r0-balls"]');
    const images = viewer.locator(".pane img");
    assert.equal(await images.first().getAttribute("src"), "../images/r0-balls/hemisphere_ssao/0006_picture.png");
    await waitForImage(images.first());
    await viewer.getByRole("button", { name: "Reference" }).click();
    assert.match(await images.first().getAttribute("src"), /reference\/0006_picture/);
    assert.equal(await viewer.getByRole("button", { name: "Shaded" }).count(), 0);
    const film = page.locator('[data-film="r0-balls"]');
    await film.scrollIntoViewIfNeeded();
    const sources = await film.locator("img:visible").evaluateAll((all) => all.map((image) => image.getAttribute("src")));
    assert.deepEqual(sources.slice(0, 2),
      ["../images/r0-balls/tssao/0040_film_picture.png", "../images/r0-balls/reference/0040_film_picture.png"]);
    assert.match(await page.locator("#round-r0-balls").textContent(), /tone curve of Reinhard/);
    assert.match(await page.locator('[data-viewer="r1-courtyard"] .pane img').first().getAttribute("src"), /_visibility/);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "wipe and side by side compare with the reference under one zoom"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const viewer = page.locator('[data-viewer="r0-balls"]');
    const images = viewer.locator(".pane img");
    await viewer.getByRole("button", { name: "Wipe" }).click();
    assert.equal(await images.count(), 2);
    assert.match(await images.nth(0).getAttribute("src"), /reference\/0006_visibility/);
    assert.match(await images.nth(1).getAttribute("src"), /hemisphere_ssao\/0006_visibility/);
    await viewer.getByLabel("Wipe position").fill("20");
    assert.match(await viewer.locator(".top-image").getAttribute("style"), /inset\(0(px)? 80%/);

    await viewer.getByRole("button", { name: "Side by side" }).click();
    await viewer.getByLabel("Compared with").selectOption("tssao");
    assert.equal(await viewer.locator(".pane").count(), 2);
    const transforms = () => images.evaluateAll((all) => all.map((image) => image.style.transform));
    const before = await transforms();
    await viewer.getByRole("button", { name: "+" }).click();
    const after = await transforms();
    assert.notEqual(after[0], before[0]);
    assert.equal(after[0], after[1]);
    await viewer.getByRole("button", { name: "90" }).click();
    assert.equal((await transforms())[0], after[0], "the zoom stays when the picture changes");
    assert.deepEqual(troubles, []);
    await close();
  },

  async "pictures that were not kept are said to be missing"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const viewer = page.locator('[data-viewer="r1-courtyard"]');
    await viewer.getByLabel("Method", { exact: true }).selectOption("tssao");
    assert.equal(await viewer.locator(".pane .missing").textContent(), "not kept");
    await viewer.getByRole("button", { name: "Reference", exact: false }).first().click();
    await waitForImage(viewer.locator(".pane img").first());
    assert.deepEqual(troubles, []);
    await close();
  },

  async "a click on a head sorts, the third gives back the order"(browser, folder) {
    const { page, close } = await openReport(browser, folder, "complete");
    const table = page.locator("#round-r0-balls table.summary");
    const names = async () => (await table.locator("tbody th").allTextContents()).map((name) => name.replace("front", "").trim());
    const original = await names();
    const head = table.locator("thead th", { hasText: "Time" });
    await head.click();
    assert.deepEqual((await names()).slice(2, 5), ["hemisphere_ssao", "tssao", "hemisphere_ssao:samples=64"]);
    await head.click();
    assert.equal((await names())[0], "hemisphere_ssao:samples=64");
    assert.equal((await names()).at(-1), "none", "rows without a number stay below");
    await head.click();
    assert.deepEqual(await names(), original);
    // A head of the second row sorts its own column.
    await table.locator("thead tr").nth(1).locator("th").nth(2).click();
    assert.equal((await names())[0], "none", "ssim is lowest there");
    await close();
  },

  async "the film is scrubbed by slider, keys and buttons, several kinds at once"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const film = page.locator('[data-film="r0-balls"]');
    const sources = () => film.locator("img:visible").evaluateAll((all) => all.map((image) => image.getAttribute("src")));
    const path = (frame, kind, cell = "tssao") => `../images/r0-balls/${cell}/00${frame}_film_${kind}.png`;
    await film.scrollIntoViewIfNeeded();
    assert.deepEqual(await sources(), [path(40, "visibility"), path(40, "visibility", "reference"), path(40, "error"), path(40, "age"), path(40, "cause")]);
    assert.equal(await film.locator(".missing:visible").count(), 1, "the first frame has no flicker");
    await film.getByLabel("Frame of the film").fill("3");
    assert.deepEqual((await sources())[3], path(43, "temporal_flicker"));
    assert.equal(await film.locator(".film-position").textContent(), "frame 43 (4 of 8)");
    await waitForImage(film.locator("img").first());
    await film.focus();
    await page.keyboard.press("ArrowRight");
    assert.equal((await sources())[0], path(44, "visibility"));
    await page.keyboard.press("End");
    assert.equal((await sources())[0], path(47, "visibility"));
    await page.keyboard.press("ArrowRight");
    assert.equal((await sources())[0], path(47, "visibility"), "nothing lies behind the last frame");
    await film.getByRole("button", { name: "First frame" }).click();
    assert.equal((await sources())[0], path(40, "visibility"));

    await film.getByRole("button", { name: "Samples a pixel" }).click();
    await film.getByRole("button", { name: "Visibility" }).click();
    assert.equal((await sources())[0], path(40, "visibility", "reference"));
    assert.equal((await sources()).at(-1), path(40, "samples"));
    await film.getByLabel("Method of the film").selectOption("hemisphere_ssao");
    assert.deepEqual(await sources(), [path(40, "visibility", "reference"), path(40, "error", "hemisphere_ssao")]);
    assert.equal(await film.getByRole("button", { name: "Age of the history" }).count(), 0, "it has no history");
    assert.equal(await page.locator('[data-film="r1-courtyard"]').count(), 0, "the second round has no film");
    assert.deepEqual(troubles, []);
    await close();
  },

  async "the film plays to its end and stops, and says what happens"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const film = page.locator('[data-film="r0-balls"]');
    const event = film.locator(".film-event");
    assert.equal(await event.textContent(), "cut (frame 40)");
    assert.deepEqual(await film.locator(".film-tick").evaluateAll((all) => all.map((tick) => tick.title)), ["cut", "box lifts"]);
    await film.getByLabel("Frame of the film").fill("4");
    assert.equal(await event.textContent(), "box lifts (frame 44)");
    await film.getByLabel("Frames a second").selectOption("30");
    const play = film.getByRole("button", { name: "Play", exact: true });
    await play.click();
    await film.getByText("frame 47 (8 of 8)").waitFor({ timeout: 5000 });
    await play.waitFor({ timeout: 5000 }); // "Pause" while it runs
    assert.equal(await event.textContent(), "box lifts (frame 44, 3 ago)");
    await film.getByLabel("Frames a second").selectOption("2");
    await play.click();
    assert.equal(await film.locator(".film-position").textContent(), "frame 40 (1 of 8)", "it begins anew");
    await film.getByRole("button", { name: "Pause" }).click();
    assert.ok(await play.isVisible());
    assert.deepEqual(troubles, []);
    await close();
  },

  async "legends name the colours of the kinds that are shown"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const legends = page.locator("#round-r0-balls .film + .legends");
    const age = legends.locator('[data-legend="age"]');
    assert.match(await age.textContent(), /lost just now.*32 frames ago or more.*converged.*background/);
    const chip = legends.locator('[data-legend="cause"] .chip').nth(2);
    assert.equal(await chip.evaluate((element) => getComputedStyle(element).backgroundColor), "rgb(33, 102, 191)");
    assert.equal(await legends.locator('[data-legend="samples"]').isVisible(), false);
    await page.locator('[data-film="r0-balls"]').getByRole("button", { name: "Samples a pixel" }).click();
    assert.ok(await legends.locator('[data-legend="samples"]').isVisible());
    const maps = page.locator("#round-r0-balls .accumulated");
    assert.equal(await maps.locator("img").count(), 4 + 2, "flicker of four methods, two maps of a history");
    assert.deepEqual(troubles, []);
    await close();
  },

  async "curves have metrics over time and marks where something happens"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete");
    const section = page.locator("#round-r0-balls");
    for (const name of ["times", "errors"]) {
      const lines = section.locator(`[data-chart="${name}"] .event-line`);
      assert.deepEqual(await lines.allTextContents(), ["ball rolls", "cut", "box lifts"], "what lies in a burst");
      const places = await lines.evaluateAll((all) => all.map((line) => Number.parseFloat(line.style.left)));
      assert.ok(places[0] > 0 && places[1] > places[0] && places[2] > places[1], `marks at ${places}`);
    }
    const errors = section.locator('[data-chart="errors"]');
    const before = await readCanvas(errors.locator("canvas"));
    for (const metric of ["temporal_flicker", "recovery_frames", "history_samples"]) {
      await errors.getByLabel("Metric").selectOption(metric);
      const drawn = await readCanvas(errors.locator("canvas"));
      assert.notEqual(drawn.sum, before.sum);
      assert.ok(drawn.drawn > 2000, `${metric} is drawn`);
      assert.equal(await errors.locator(".event-line").count(), 3);
    }
    assert.equal(await section.locator('[data-chart="scatter"] option[value="temporal_flicker"]').count(), 0);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "hostile texts stay texts, progress and provisional times are marked"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "hostile");
    assert.notEqual(await page.title(), "owned");
    assert.equal(await page.locator('img[src="x"]').count(), 0);
    for (const place of [".verdict", "table.summary", ".legend", "#definitions", "#skipped", ".viewer select", ".film select",
      ".film-event", ".event-line", ".events", "table.wide", ".facts"]) {
      const text = await page.locator(place).first().textContent();
      assert.ok(text.includes("<img src=x onerror=") && text.includes("</script>"), `${place} shows the text`);
    }
    assert.equal(await page.locator(".state").textContent(), "in progress: 1 of 2 rounds");
    const provisional = page.locator("#unfinished tr", { hasText: "provisional" });
    assert.match(await provisional.textContent(), /12\.5.*\(n=1\)/);
    assert.ok(await provisional.isVisible());
    await checkNoOverflow(page);
    assert.deepEqual(troubles, []);
    await close();
  },

  async "everything but charts and viewer works without JavaScript"(browser, folder) {
    const { page, troubles, close } = await openReport(browser, folder, "complete", { javaScriptEnabled: false });
    assert.ok(await page.locator("#round-r0-balls table.summary").isVisible());
    assert.ok(await page.locator("#round-r0-balls .verdict").isVisible());
    const sheet = page.locator("#round-r0-balls .sheet").first();
    assert.ok(await sheet.locator("img").first().isVisible());
    assert.equal(await sheet.locator("img").count(), 4 * 5);
    assert.ok(await page.getByText("need JavaScript").isVisible());
    assert.equal(await page.locator(".charts").first().isVisible(), false);
    assert.match(await page.locator("#round-r0-balls .over-time table").first().textContent(), /temporal_flicker/);
    const film = page.locator("#round-r0-balls .sheet[open]", { hasText: "Film, frame 47" });
    assert.equal(await film.locator("img").count(), 4 * 4 + 4, "four kinds of all methods, four of a history");
    assert.ok(await film.locator("img").first().isVisible());
    assert.ok(await page.locator('#round-r0-balls [data-legend="samples"]').first().isVisible());
    await checkNoOverflow(page);
    await page.locator("#round-r0-balls summary", { hasText: "Passes" }).click();
    assert.ok(await page.getByText("tssao/occlusion").first().isVisible());
    assert.deepEqual(troubles, []);
    await close();
  },
};

await runTests(tests, process.argv[2]);
