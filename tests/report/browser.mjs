// A browser without a window, and what goes wrong in it.
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";
import puppeteer from "puppeteer-core";

// Pictures are made by the processor: what is tested does not depend on a graphics card.
const SWITCHES = ["--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
                  "--enable-unsafe-swiftshader", "--hide-scrollbars"];

// Opens a file with the network cut off. `faults` gathers errors of the page and whatever it asks
// for beyond itself.
const open = async (program, file) => {
  const browser = await puppeteer.launch({executablePath: program, headless: true, args: SWITCHES});
  const page = await browser.newPage();
  const faults = [];
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`exception: ${error.stack ?? error.message ?? error}`));
  const url = pathToFileURL(resolve(file)).href;
  page.on("request", (request) => {
    if (request.url() !== url && !/^(data|blob):/.test(request.url()))
      faults.push(`request: ${request.url()}`);
  });
  await page.setViewport({width: 1400, height: 900});
  await page.setOfflineMode(true);
  await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: "light"}]);
  await page.goto(url, {waitUntil: "load"});
  return {browser, page, faults};
};

// Waits until the page has drawn what it was told to.
export const settle = (page) =>
  page.evaluate(() => new Promise((done) => {
    let frames = 4;
    const wait = () => (--frames === 0 ? done() : requestAnimationFrame(wait));
    requestAnimationFrame(wait);
  }));

export const textsOf = (page, selector) =>
  page.$$eval(selector, (nodes) => nodes.map((node) => node.textContent));

// Takes the steps, each with the page and `expect(what, holds)`, in the browser and on the file that
// the command line names; prints what is wrong and ends. A step that fails is the last.
export const inspect = async (...steps) => {
  const [program, file] = process.argv.slice(2);
  const {browser, page, faults} = await open(program, file);
  const expect = (what, holds) => { if (!holds) faults.push(what); };
  try {
    await settle(page);
    for (const step of steps) await step(page, expect);
  } catch (error) {
    faults.push(error.stack ?? String(error));
  } finally {
    for (const fault of faults) console.log(fault);
    await browser.close();
  }
  process.exit(faults.length === 0 ? 0 : 1);
};
