// What plots show, and what they do with the mouse.
import {settle, textsOf} from "./browser.mjs";

// Pixels of a plot's canvas in a colour: lines have one, axes and grid are nearly grey.
const GREY = 60;  // of 255, between the largest and the least of red, green and blue
const LINE = 50;  // pixels that the shortest line has at least
const coloredPixels = (chart) => chart.$eval("canvas", (canvas, grey) => {
  const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const rgb = data.subarray(i, i + 3);
    if (data[i + 3] > 128 && Math.max(...rgb) - Math.min(...rgb) > grey) ++count;
  }
  return count;
}, GREY);

// Of each plot the lines are there, and as many values as `rightCount` takes.
export const checkLines = async (page, expect, charts, rightCount) => {
  for (const chart of charts) {
    await chart.scrollIntoView();
    await settle(page);
    const title = await chart.$eval("b", (b) => b.textContent);
    const pixels = await chart.$("canvas") ? await coloredPixels(chart) : 0;
    expect(`plot ${title}: ${pixels} coloured pixels, expected lines`, pixels > LINE);
    const values = await textsOf(chart, ".u-series:not(:first-child) .u-value");
    expect(`plot ${title}: values ${values}`, rightCount(values.length) && values.every((v) => /\d/.test(v)));
  }
  await page.evaluate(() => scrollTo(0, 0));
  await settle(page);
};

// The cursor in one plot changes the values of all; a drag to a part of its width zooms all.
// look: {from, to, zoomed}: called at a quarter of the width, at three quarters, and in the zoom.
export const checkMouse = async (page, expect, dragTo, look) => {
  const box = await (await page.$(".chart .u-over")).boundingBox();
  const middle = box.y + box.height / 2;
  const shown = async () => (await textsOf(page, ".chart .u-value")).join();
  await page.mouse.move(box.x + box.width / 4, middle);
  await settle(page);
  const before = await shown();
  await look.from?.();
  await page.mouse.move(box.x + box.width * 0.75, middle);
  await settle(page);
  expect("the cursor does not change the values", before !== await shown());
  await look.to?.();
  await page.mouse.down();
  await page.mouse.move(box.x + dragTo(box.width), middle, {steps: 4});
  await page.mouse.up();
  await settle(page);
  expect("a drag does not zoom", await page.$eval("#reset", (button) => !button.disabled));
  await look.zoomed?.();
  await page.click("#reset");
  await settle(page);
  expect("the zoom is not reset", await page.$eval("#reset", (button) => button.disabled));
};
