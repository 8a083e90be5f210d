// node check_runs.mjs BROWSER PAGE: opens the page of three runs with forces as its reader does, and
// says what is wrong.
import {inspect, settle, textsOf} from "./browser.mjs";
import {checkLines, checkMouse} from "./plots.mjs";

const checkHead = async (page, expect) => {
  const names = await textsOf(page, "#runs li");
  expect(`the runs: ${names}`, names.length === 3 && names.every((name, i) => name.endsWith(`density_${400 + 100 * i}`)));
};

// Three lines in each plot of the motion and in one of a load. The weights differ from run to run.
const checkPlots = async (page, expect) => {
  await page.select("#body", "1");
  await settle(page);
  const groups = await textsOf(page, ".group summary");
  expect(`the groups: ${groups}`, groups[0] === "Position" && groups.includes("Buoyancy") && groups.includes("Weight"));
  const charts = (await page.$$(".chart")).slice(0, 13);
  await checkLines(page, expect, charts, (count) => count === 3);
};

const checkZoom = (page, expect) => checkMouse(page, expect, (width) => width / 4, {});

await inspect(checkHead, checkPlots, checkZoom);
