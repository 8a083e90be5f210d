// node check_no_replay.mjs BROWSER PAGE: a comparison with a log, which has no scene, says so in
// place of its replay, and has its plots all the same.
import {inspect} from "./browser.mjs";

const checkNote = async (page, expect) => {
  const note = await page.$eval("#stage", (node) => node.textContent);
  expect(`the note: ${note}`, /^There is no replay: .*trajectory.csv is a log and not the folder of a run\.$/.test(note));
  expect("there is a replay", await page.$("canvas#replay") === null);
  expect("no plots", (await page.$$(".chart canvas")).length > 0);
};

await inspect(checkNote);
