// node bundle.mjs PAGE: bundles the page into one file, but for the data of a run.
import {build} from "esbuild";
import {mkdirSync, readFileSync, renameSync, writeFileSync} from "node:fs";
import {dirname} from "node:path";

const bundled = await build({
  entryPoints: {script: "report.js", style: "style.css"},
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  legalComments: "inline",
  write: false,
  outdir: ".",
});
const text = (suffix) => bundled.outputFiles.find((file) => file.path.endsWith(suffix)).text;
const license = (name) => `${name}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8")}`;
const parts = {
  STYLE: text(".css"),
  SCRIPT: text(".js"),
  LICENSES: "This page contains:\n\n" + [license("three"), license("uplot")].join("\n"),
};
const page = readFileSync("page.html", "utf8")
  .replace(/@PLIMSOLL_(STYLE|SCRIPT|LICENSES)@/g, (_, name) => parts[name]);
const out = process.argv[2];
mkdirSync(dirname(out), {recursive: true});
writeFileSync(out + ".part", page);
renameSync(out + ".part", out);
