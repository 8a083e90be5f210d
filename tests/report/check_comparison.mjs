// node check_comparison.mjs BROWSER PAGE: opens a comparison as its reader does, and says what is
// wrong. Its runs differ beyond tolerance.
import {open, settle} from "./browser.mjs";
import {coloredPixels, LINE} from "./pixels.mjs";

const [program, file] = process.argv.slice(2);
const {browser, page, faults} = await open(program, file);
const expect = (what, holds) => { if (!holds) faults.push(what); };
const textOf = (selector) => page.$eval(selector, (node) => node.textContent);
const textsOf = (selector) => page.$$eval(selector, (nodes) => nodes.map((node) => node.textContent));

const checkHead = async () => {
  expect("the verdict", await textOf("#verdict") === "different");
  const head = await textOf("#head");
  expect(`the head names neither run: ${head}`, /small_steps/.test(head) && /large_steps/.test(head));
  const verdicts = await textsOf("#table td:last-child");
  expect(`the table's verdicts: ${verdicts}`, verdicts.some((v) => /^exceeds it from [\d.]+ s$/.test(v)));
};

// Of each plot the lines are there, with values, and that of the moment from which it is beyond.
const checkPlots = async () => {
  const charts = await page.$$(".chart");
  expect(`${charts.length} plots, expected 4 of each of 4 quantities`, charts.length === 16);
  for (const chart of charts) {
    await chart.scrollIntoView();
    await settle(page);
    const title = await chart.$eval("b", (b) => b.textContent);
    const pixels = await chart.$("canvas") ? await coloredPixels(chart) : 0;
    expect(`plot ${title}: ${pixels} coloured pixels, expected lines`, pixels > LINE);
    const values = await chart.$$eval(".u-series:not(:first-child) .u-value",
                                      (cells) => cells.map((cell) => cell.textContent));
    expect(`plot ${title}: values ${values}`, values.length === 2 && values.every((v) => /\d/.test(v)));
  }
  await page.evaluate(() => scrollTo(0, 0));
  await settle(page);
  const first = await page.$eval(".group summary", (node) => node.className);
  expect("the first quantity is not the worst", first === "bad");
  expect("no moment is marked", await page.$eval(".moment", (node) => node.getBoundingClientRect().height > 50));
};

// The cursor in one plot moves the line and the values of all; a drag zooms all.
const checkCursor = async () => {
  const box = await (await page.$(".chart .u-over")).boundingBox();
  const middle = box.y + box.height / 2;
  const shown = async () => (await textsOf(".chart .u-value")).join();
  const moment = () => page.$eval(".moment", (node) => node.style.transform);
  await page.mouse.move(box.x + box.width / 4, middle);
  await settle(page);
  const before = await shown();
  await page.mouse.move(box.x + box.width * 0.75, middle);
  await settle(page);
  expect("the cursor does not change the values", before !== await shown());
  const whole = await moment();
  await page.mouse.down();
  await page.mouse.move(box.x + 2, middle, {steps: 4});
  await page.mouse.up();
  await settle(page);
  expect("a drag does not zoom", await page.$eval("#reset", (button) => !button.disabled));
  expect("the mark does not move with the zoom", whole !== await moment());
  await page.click("#reset");
  await settle(page);
  expect("the zoom is not reset", await page.$eval("#reset", (button) => button.disabled));
  expect("the mark does not come back", whole === await moment());
};

const checkChoice = async () => {
  const first = await page.$eval("#body", (list) => list.selectedOptions[0].textContent);
  await page.click("#table tbody:last-child tr[onclick], #table tbody:last-child tr");
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

await settle(page);
await checkHead();
await checkPlots();
await checkCursor();
await checkChoice();
await browser.close();
for (const fault of faults) console.log(fault);
process.exit(faults.length === 0 ? 0 : 1);
