// node check_comparison.mjs BROWSER PAGE: opens a comparison as its reader does, and says what is
// wrong. Its runs differ beyond tolerance.
import {inspect, settle, textsOf} from "./browser.mjs";
import {checkLines, checkMouse} from "./plots.mjs";

const textOf = (page, selector) => page.$eval(selector, (node) => node.textContent);

const checkHead = async (page, expect) => {
  expect("the verdict", await textOf(page, "#verdict") === "different");
  const head = await textOf(page, "#head");
  expect(`the head names neither run: ${head}`, /small_steps/.test(head) && /large_steps/.test(head));
  const changes = await textOf(page, "#changes");
  expect(`the changed key: ${changes}`, /step/.test(changes) && /0\.02/.test(changes));
  const tables = await textsOf(page, "#table .of-run .first td:first-child");
  expect(`the tables: ${tables}`, tables.includes("forces"));
  const verdicts = await textsOf(page, "#table td:nth-child(3)");
  expect(`the table's verdicts: ${verdicts}`, verdicts.some((v) => /^exceeds it from [\d.]+ s$/.test(v)));
};

// Of each plot the lines are there, with values, and that of the moment from which it is beyond.
const checkPlots = async (page, expect) => {
  const charts = await page.$$(".chart");
  expect(`${charts.length} plots, expected 4 of each of 4 quantities`, charts.length === 16);
  await checkLines(page, expect, charts, (count) => count === 2);
  const first = await page.$eval(".group summary", (node) => node.className);
  expect("the first quantity is not the worst", first === "bad");
  expect("no moment is marked", await page.$eval(".moment", (node) => node.getBoundingClientRect().height > 50));
};

// The line of the moment moves with a zoom.
const checkCursor = async (page, expect) => {
  const moment = () => page.$eval(".moment", (node) => node.style.transform);
  const whole = await moment();
  await checkMouse(page, expect, () => 2, {
    zoomed: async () => expect("the mark does not move with the zoom", whole !== await moment())});
  expect("the mark does not come back", whole === await moment());
};

const checkChoice = async (page, expect) => {
  const first = await page.$eval("#body", (list) => list.selectedOptions[0].textContent);
  await page.click("#table tbody:nth-of-type(2) tr");
  await settle(page);
  const second = await page.$eval("#body", (list) => list.selectedOptions[0].textContent);
  expect(`a click on the table's last body leaves ${first}`, first !== second);
  const ticks = async () => {
    const canvas = await page.$(".chart canvas");
    return canvas.evaluate((node) => node.toDataURL());
  };
  const before = await ticks();
  await page.click("#log");
  await settle(page);
  expect("a logarithmic scale looks like a linear one", before !== await ticks());
};

// Pixels of the replay in the colour of B's bodies.
const pixelsOfB = async (page) => {
  const shot = Buffer.from(await (await page.$("#view")).screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height).getContext("2d");
    canvas.drawImage(image, 0, 0);
    const {data} = canvas.getImageData(0, 0, image.width, image.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] > data[i + 2] + 30) ++count;
    return count;
  }, shot);
};

// Both runs are drawn, at the time of one slider.
const BODY = 500;  // px that a body of B covers at least
const checkReplay = async (page, expect) => {
  const shown = async (part) => {
    await page.$eval("#time", (slider, p) => {
      slider.value = slider.max * p;
      slider.dispatchEvent(new Event("input"));
    }, part);
    await settle(page);
    return Buffer.from(await (await page.$("#view")).screenshot()).toString("base64");
  };
  const early = await shown(0.1);
  const pixels = await pixelsOfB(page);
  expect(`${pixels} pixels of B`, pixels > BODY);
  expect("the replay looks the same at two times", early !== await shown(0.9));
};

await inspect(checkHead, checkPlots, checkCursor, checkReplay, checkChoice);
