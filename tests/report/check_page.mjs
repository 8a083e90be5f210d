// node check_page.mjs BROWSER REPORT: opens a report as its reader does, and says what is wrong.
import {open, settle} from "./browser.mjs";
import {coloredPixels, LINE} from "./pixels.mjs";

const [program, file] = process.argv.slice(2);
const {browser, page, faults} = await open(program, file);
const expect = (what, holds) => { if (!holds) faults.push(what); };

const seek = async (part) => {
  await page.$eval("#time", (slider, p) => {
    slider.value = slider.max * p;
    slider.dispatchEvent(new Event("input"));
  }, part);
  await settle(page);
};
const clock = () => page.$eval("#clock", (output) => parseFloat(output.textContent));

// What the replay looks like once it is drawn: a browser that is short of time may be late with it.
const replayPixels = async () => {
  const view = await page.$("#view");
  const shot = async () => Buffer.from(await view.screenshot()).toString("base64");
  let before, now = await shot();
  do {
    before = now;
    await settle(page);
    now = await shot();
  } while (now !== before);
  return now;
};

const checkPlots = async () => {
  const charts = await page.$$(".chart");
  expect(`${charts.length} plots, expected motion, loads and energy`, charts.length >= 12);
  for (const chart of charts) {
    await chart.scrollIntoView();
    await settle(page);
    const title = await chart.$eval("b", (b) => b.textContent);
    const pixels = await chart.$("canvas") ? await coloredPixels(chart) : 0;
    expect(`plot ${title}: ${pixels} coloured pixels, expected lines`, pixels > LINE);
    const values = await chart.$$eval(".u-series:not(:first-child) .u-value",
                                      (cells) => cells.map((cell) => cell.textContent));
    expect(`plot ${title}: values ${values}`, values.length > 0 && values.every((v) => /\d/.test(v)));
  }
  await page.evaluate(() => scrollTo(0, 0));
};

const checkReplay = async () => {
  await seek(0.1);
  const early = await replayPixels();
  await seek(0.9);
  expect("the replay looks the same at two times", early !== await replayPixels());
  await seek(0.1);
  expect("the replay looks different at the same time", early === await replayPixels());
  const box = await (await page.$("#replay")).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 20, {steps: 4});
  await page.mouse.up();
  await settle(page);
  expect("the replay does not turn with the mouse", early !== await replayPixels());
};

const checkPlaying = async () => {
  await seek(0);
  await page.select("#transport select", "0.1");
  await page.click("#play");
  await page.waitForFunction(() => parseFloat(document.getElementById("clock").textContent) > 0);
  // Where it has come to its end meanwhile, there is nothing left to stop.
  await page.$eval("#play", (button) => { if (button.textContent === "⏸") button.click(); });
  const stopped = await clock();
  await settle(page);
  expect("the replay goes on after a pause", await clock() === stopped);
};

// The cursor in one plot moves the clock and shows the values there; a drag zooms all plots.
const checkCursor = async () => {
  const over = await page.$(".chart .u-over");
  const box = await over.boundingBox();
  const middle = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 4, middle);
  await settle(page);
  const first = await clock();
  const shown = () => page.$$eval(".chart .u-value", (cells) => cells.map((c) => c.textContent).join());
  const before = await shown();
  await page.mouse.move(box.x + box.width * 0.75, middle);
  await settle(page);
  expect("the cursor does not move the clock", await clock() > first);
  expect("the cursor does not change the values", before !== await shown());
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, middle, {steps: 4});
  await page.mouse.up();
  await settle(page);
  expect("a drag does not zoom", await page.$eval("#reset", (button) => !button.disabled));
  await page.click("#reset");
  await settle(page);
  expect("the zoom is not reset", await page.$eval("#reset", (button) => button.disabled));
};

const checkPictures = async () => {
  const first = await page.$$("#strip button");
  expect("no strip of pictures", first.length > 1);
  await first[1].click();
  await settle(page);
  expect("a picture does not move the clock", await clock() > 0);
  await (await page.$("#views button:last-child")).click();
  expect("no picture is shown", await page.$eval("#picture", (image) => !image.hidden && image.naturalWidth > 0));
};

await settle(page);
await checkPlots();
await checkReplay();
await checkPlaying();
await checkCursor();
await checkPictures();
await browser.close();
for (const fault of faults) console.log(fault);
process.exit(faults.length === 0 ? 0 : 1);
