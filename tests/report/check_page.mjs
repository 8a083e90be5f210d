// node check_page.mjs BROWSER REPORT: opens a report as its reader does, and says what is wrong.
import {inspect, settle} from "./browser.mjs";
import {checkLines, checkMouse} from "./plots.mjs";

const seek = async (page, part) => {
  await page.$eval("#time", (slider, p) => {
    slider.value = slider.max * p;
    slider.dispatchEvent(new Event("input"));
  }, part);
  await settle(page);
};
const clock = (page) => page.$eval("#clock", (output) => parseFloat(output.textContent));

// What the replay looks like once it is drawn: a browser that is short of time may be late with it.
const replayPixels = async (page) => {
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

const checkPlots = async (page, expect) => {
  const charts = await page.$$(".chart");
  expect(`${charts.length} plots, expected motion, loads and energy`, charts.length >= 12);
  await checkLines(page, expect, charts, (count) => count > 0);
};

// The numbers of the six motions, and spectra whose axes end where they do.
const checkAnalysis = async (page, expect) => {
  const names = await page.$$eval("#analysis .numbers td:first-child b", (nodes) => nodes.map((n) => n.textContent));
  expect(`signals: ${names}`, names.join() === "surge,sway,heave,roll,pitch,yaw");
  const titles = await page.$$eval("#analysis figcaption b", (nodes) => nodes.map((n) => n.textContent));
  expect(`spectra: ${titles}`, titles[0] === "Spectra of displacements" && titles[1] === "Spectra of rotations");
  const legend = await page.$eval("#analysis .u-series:first-child .u-value", (node) => node.textContent);
  expect(`the peak: ${legend}`, /^[\d.]+ Hz, [\d.]+ s$/.test(legend));
};

// The replay's wet surfaces have the colours of a bar, which go with a click and come with another.
const checkPressure = async (page, expect) => {
  await seek(page, 0.5);
  expect("the replay has no bar of pressures", await page.$eval("#pressure .colors", (bar) => bar.clientWidth > 50));
  const ticks = await page.$$eval("#pressure .scale span", (nodes) => nodes.map((node) => node.textContent));
  expect(`the bar's ticks: ${ticks}`, ticks.length >= 3 && ticks.every((tick) => /^−?[\d.]+$/.test(tick)));
  const toggle = await page.evaluateHandle(() =>
    [...document.querySelectorAll("#toggles label")].find((label) => label.textContent === "pressure"));
  // The bar goes at once, the surfaces with the next picture of the replay.
  const toggled = async () => {
    await toggle.click();
    await new Promise((done) => { setTimeout(done, 1500); });
    return replayPixels(page);
  };
  // The first click also takes the focus from the clock, which shows.
  const bare = await toggled();
  const colored = await toggled();
  expect("pressures are shown without their toggle", bare !== colored);
  expect("the replay without pressures is not what it was", bare === await toggled());
  await toggled();
};

const checkReplay = async (page, expect) => {
  await seek(page, 0.1);
  const early = await replayPixels(page);
  await seek(page, 0.9);
  expect("the replay looks the same at two times", early !== await replayPixels(page));
  await seek(page, 0.1);
  expect("the replay looks different at the same time", early === await replayPixels(page));
  const box = await (await page.$("#replay")).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 20, {steps: 4});
  await page.mouse.up();
  await settle(page);
  expect("the replay does not turn with the mouse", early !== await replayPixels(page));
};

const checkPlaying = async (page, expect) => {
  await seek(page, 0);
  await page.select("#transport select", "0.1");
  await page.click("#play");
  await page.waitForFunction(() => parseFloat(document.getElementById("clock").textContent) > 0);
  // Where it has come to its end meanwhile, there is nothing left to stop.
  await page.$eval("#play", (button) => { if (button.textContent === "⏸") button.click(); });
  const stopped = await clock(page);
  await settle(page);
  expect("the replay goes on after a pause", await clock(page) === stopped);
};

// The cursor in a plot moves the clock.
const checkCursor = async (page, expect) => {
  let first;
  await checkMouse(page, expect, (width) => width / 2, {
    from: async () => { first = await clock(page); },
    to: async () => expect("the cursor does not move the clock", await clock(page) > first)});
};

const checkPictures = async (page, expect) => {
  const first = await page.$$("#strip button");
  expect("no strip of pictures", first.length > 1);
  await first[1].click();
  await settle(page);
  expect("a picture does not move the clock", await clock(page) > 0);
  await (await page.$("#views button:last-child")).click();
  expect("no picture is shown", await page.$eval("#picture", (image) => !image.hidden && image.naturalWidth > 0));
};

await inspect(checkPlots, checkAnalysis, checkReplay, checkPressure, checkPlaying, checkCursor, checkPictures);
