// node bundle.mjs FOLDER: bundles each page into one file there, but for the data that it shows.
import {build} from "esbuild";
import {mkdirSync, readFileSync, renameSync, writeFileSync} from "node:fs";
import {join} from "node:path";

const PAGES = [
  {page: "page.html", script: "report.js", packages: ["three", "uplot"]},
  {page: "comparison.html", script: "comparison.js", packages: ["three", "uplot"]},
  {page: "runs.html", script: "runs.js", packages: ["uplot"]}];

const license = (name) => `${name}\n\n${readFileSync(`node_modules/${name}/LICENSE`, "utf8")}`;

const folder = process.argv[2];
mkdirSync(folder, {recursive: true});
for (const {page, script, packages} of PAGES) {
  const bundled = await build({
    entryPoints: {script},
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2020",
    legalComments: "inline",
    write: false,
    outdir: ".",
  });
  const text = (suffix) => bundled.outputFiles.find((file) => file.path.endsWith(suffix)).text;
  const parts = {
    STYLE: text(".css"),
    SCRIPT: text(".js"),
    LICENSES: "This page contains:\n\n" + packages.map(license).join("\n"),
  };
  const filled = readFileSync(page, "utf8")
    .replace(/@PLIMSOLL_(STYLE|SCRIPT|LICENSES)@/g, (_, name) => parts[name]);
  const out = join(folder, page);
  writeFileSync(out + ".part", filled);
  renameSync(out + ".part", out);
}
