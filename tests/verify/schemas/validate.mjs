// SPDX-License-Identifier: GPL-3.0-or-later
//
// node validate.mjs <ncsim> <source>: runs ncsim check over the samples and over programs with
// faults, and validates what it writes: our own schema, the schema of SARIF 2.1.0, and what code
// hosting asks for beyond that.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import Ajv from "ajv";

const [ncsim, source] = process.argv.slice(2);
const require = createRequire(import.meta.url);
const sarifSchema = JSON.parse(readFileSync(join(
  dirname(require.resolve("@microsoft/jest-sarif/package.json")),
  "lib/schemas/sarif-2.1.0-rtm.5.json")));
const ownSchema = JSON.parse(readFileSync(join(source, "docs/schemas/check.schema.json")));

const folder = mkdtempSync(join(tmpdir(), "ncsim-schema-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
let failures = 0;
function expect(condition, message) {
  if (condition) return;
  console.error(message);
  failures += 1;
}

function check(names, more = []) {
  let code = 0;
  try {
    execFileSync(ncsim, ["check", ...names, ...more, "--json", "a.json", "--sarif", "a.sarif"],
      { cwd: folder, stdio: "ignore" });
  } catch (error) {
    code = error.status;
  }
  const read = (name) => JSON.parse(readFileSync(join(folder, name)));
  return { code, json: read("a.json"), sarif: read("a.sarif") };
}

function isValid(schema, value) {
  const ajv = new Ajv({ schemaId: "auto", allErrors: true, unknownFormats: "ignore", logger: false });
  ajv.addMetaSchema(require("ajv/lib/refs/json-schema-draft-04.json"));
  return { valid: ajv.validate(schema, value), errors: ajv.errorsText() };
}

function validate(schema, value, what) {
  const { valid, errors } = isValid(schema, value);
  expect(valid, `${what}: ${errors}`);
  // A schema that takes everything would not notice.
  expect(!isValid(schema, { ...value, version: "no" }).valid, `${what}: anything is valid`);
}

const head = "(T1 D=10. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\nG21 G90 G17 T1 M6 S1000 M3\n";
const slot = "G0 X-30 Y0 Z5\nZ-2\nG0 X0\nG0 X30\nG1 Z-1\nG1 X-30 F500\nM777\nG1 Q (\n";
writeFileSync(join(folder, "bad program.nc"), head + slot);
writeFileSync(join(folder, "moved.nc"), head + "(one line more)\nG4 P1\n" + slot);
writeFileSync(join(folder, "accepted.nc"),
  head + "G0 X-30 Y0 Z-2\n(ncsim: ignore rapid-in-material)\nG0 X30\nG1 Z5 F100\n");
writeFileSync(join(folder, "latin1.nc"), Buffer.concat([
  Buffer.from(head), Buffer.from([0x28, 0xfc, 0x29, 0x0a]), Buffer.from("G0 X\xff\n", "latin1")]));
writeFileSync(join(folder, "unknown tool.nc"), "G21 G90 T7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F10\n");
writeFileSync(join(folder, "empty.nc"), "");
for (const [name, depth] of [["design", 2], ["deep", 2.5], ["flat", 1.5]])
  writeFileSync(join(folder, `${name}.nc`), `${head}G0 X-30 Y0 Z5\nZ-${depth}\nG1 X30 F500\n`);
execFileSync(ncsim, ["run", "design.nc", "-q", "--stl", "design.stl"], { cwd: folder });
const samples = ["simple", "complex"].map((name) => join(source, "samples", `${name}.nc`));

// Known findings: some that are there, and with moved.nc made clean some that are not.
check(["bad program.nc", "moved.nc"], ["--write-baseline", "known.json"]);
writeFileSync(join(folder, "known.json"), readFileSync(join(folder, "known.json"), "utf8")
  .replaceAll('"line"', '"why":"foam","line"').replaceAll("through material", "through matter"));
check(["bad program.nc"], ["--write-baseline", "known.json"]);

const runs = {
  faults: check(["bad program.nc", "moved.nc", "accepted.nc", "latin1.nc", "unknown tool.nc",
    "empty.nc", "missing.nc"]),
  samples: check(["--no-project", ...samples]),
  known: check(["bad program.nc", "moved.nc"], ["--baseline", "known.json"]),
  design: check(["design.nc", "deep.nc", "flat.nc"], ["--design", "design.stl"]),
};
expect(runs.faults.code === 2, `exit code ${runs.faults.code} where a file is missing`);
expect(runs.samples.code === 4, `exit code ${runs.samples.code} for the samples`);

for (const [name, { json, sarif }] of Object.entries(runs)) {
  validate(ownSchema, json, `${name}, --json`);
  validate(sarifSchema, sarif, `${name}, --sarif`);
  const run = sarif.runs[0];
  const ids = run.tool.driver.rules.map((rule) => rule.id);
  const prints = new Set();
  for (const result of run.results) {
    expect(ids[result.ruleIndex] === result.ruleId, `${result.ruleId}: index`);
    const { artifactLocation, region } = result.locations[0].physicalLocation;
    expect(!artifactLocation.uri.includes(" "), `${artifactLocation.uri}: not escaped`);
    expect(region === undefined || region.startLine >= 1, `${result.ruleId}: region`);
    const print = `${artifactLocation.uri} ${Object.values(result.partialFingerprints)[0]}`;
    expect(!prints.has(print), `${print} stands twice`);
    prints.add(print);
  }
}

const compared = runs.design.json.programs.map((program) => program.design);
expect(compared.map((d) => d.gouge.regions).join() === "0,1,0", "gouges");
expect(compared.map((d) => d.excess.regions).join() === "0,0,1", "excesses");

const results = runs.faults.sarif.runs[0].results;
const of = (uri, rule) => results.filter((r) => r.ruleId === rule &&
  r.locations[0].physicalLocation.artifactLocation.uri === uri);
const rapid = of("bad%20program.nc", "rapid-in-material");
expect(rapid.length === 1, "successive blocks are not one result");
const region = rapid[0].locations[0].physicalLocation.region;
expect(region.startLine === 6 && region.endLine === 7, `region ${JSON.stringify(region)}`);
expect(rapid[0].level === "error" && rapid[0].properties.value > 799, "level and quantity");
expect(of("accepted.nc", "rapid-in-material")[0].suppressions[0].kind === "inSource",
  "suppressed in the source");
expect(runs.faults.sarif.runs[0].invocations[0].executionSuccessful === false, "success is claimed");

const known = runs.known.json.programs.map((program) => program.baseline);
expect(known[0].accepted > 0 && known[0].no_longer_found.length === 0, "known findings");
expect(known[1].no_longer_found.length === 1, "known findings that are gone");

// Lines above do not change what a finding is taken for; only the file differs here.
writeFileSync(join(folder, "bad program.nc"), head + "(one line more)\nG4 P1\n" + slot);
const again = check(["bad program.nc"]).sarif.runs[0].results
  .filter((r) => r.ruleId === "rapid-in-material");
expect(JSON.stringify(again[0].partialFingerprints) ===
  JSON.stringify(rapid[0].partialFingerprints), "the fingerprint moved with the line");
process.exitCode = failures === 0 ? 0 : 1;
