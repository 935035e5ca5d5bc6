// Validators of npm for tests/ci/ci_files_test.py.
//   validate.mjs action FILE    the schema of action files, as published for GitHub Actions
//   validate.mjs matcher FILE   reads {"lines": […]} from the standard input; prints the problem of each
//                               line as JSON, or null, as a reader of VS Code's problem matchers finds it
import fs from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const [kind, file] = process.argv.slice(2);
const text = fs.readFileSync(file, "utf8");

if (kind === "action") {
    const { errors } = require("@action-validator/core").validateAction(text);
    if (errors.length > 0) {
        console.log(JSON.stringify(errors, null, 1));
        process.exit(1);
    }
} else {
    const { parseProblemMatchersJson } = require("@rushstack/problem-matcher");
    const definitions = JSON.parse(text).problemMatcher.map((matcher) => ({ name: matcher.owner, ...matcher }));
    const matchers = parseProblemMatchersJson(definitions);
    const { lines } = JSON.parse(fs.readFileSync(0, "utf8"));
    const problems = lines.map((line) => matchers.map((matcher) => matcher.exec(line + "\n")).filter(Boolean));
    console.log(JSON.stringify(problems));
}
