#!/usr/bin/env python3
"""Tests the files for CI services: action.yml, templates/ncsim.yml, .pre-commit-hooks.yaml and
docs/problem-matcher.json.

Usage: ci_files_test.py NCSIM action|gitlab|pre-commit|matcher TOOLS

TOOLS is a folder with validate.mjs and its packages. The shell steps run here, on a folder with good and bad
programs, without network: the programs apt-get, sudo and dev are replaced. No service runs. Exits with 77 if
a program is missing.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import yaml

SOURCE = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
VERDICTS = os.path.join(SOURCE, "tests/verdicts")
SKIPPED = 77
TOOL = "--tool T1=flat:D10:L22"


def expect(is_true, message):
    if not is_true:
        sys.exit(f"FAILED: {message}")


def need(program):
    if not shutil.which(program):
        print(f"skipped: no {program} (packages.txt)")
        sys.exit(SKIPPED)


def read(name):
    with open(os.path.join(SOURCE, name), encoding="utf-8") as file:
        return file.read()


def write(path, text, mode=0o644):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(path, mode)


class Workspace:
    """A repository with programs, and a folder of commands with ncsim."""

    def __init__(self, program, folder):
        self.folder, self.commands = os.path.join(folder, "work"), os.path.join(folder, "bin")
        self.program = program
        programs = os.path.join(self.folder, "programs")
        os.makedirs(programs)
        os.makedirs(self.commands)
        os.symlink(program, os.path.join(self.commands, "ncsim"))
        shutil.copy(os.path.join(VERDICTS, "ok-slot.nc"), os.path.join(programs, "good.nc"))
        shutil.copy(os.path.join(VERDICTS, "rapid-through-stock.nc"), os.path.join(programs, "bad.nc"))
        shutil.copy(os.path.join(VERDICTS, "mill.toml"), os.path.join(self.folder, "my mill.toml"))
        for name in ("programs/with blank.nc", "-x.nc"):
            shutil.copy(os.path.join(VERDICTS, "ok-slot.nc"), os.path.join(self.folder, name))
        shutil.copy(os.path.join(VERDICTS, "rapid-through-stock.nc"), os.path.join(programs, "<b>.nc"))
        self.environment = {"PATH": f"{self.commands}:/usr/bin:/bin", "HOME": folder, "LC_ALL": "C.UTF-8"}

    def path(self, name):
        return os.path.join(self.folder, name)

    def clear(self):
        for name in os.listdir(self.folder):
            if name.startswith("ncsim."):
                os.remove(self.path(name))

    def shell(self, script, environment, *shell):
        return subprocess.run([*shell, script], cwd=self.folder, env={**self.environment, **environment},
                              capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)


def examples():
    """Returns the YAML of docs/ci.md."""
    return [yaml.safe_load(block) for block in re.findall(r"```yaml\n(.*?)```", read("docs/ci.md"), re.S)]


# The action of GitHub.

class Action:
    def __init__(self, workspace):
        self.workspace = workspace
        self.text = yaml.safe_load(read("action.yml"))
        self.steps = {step["name"]: step for step in self.text["runs"]["steps"]}

    def value(self, text, inputs, outputs, action_path):
        """Returns `text` with its expressions replaced. An unknown expression ends the test."""
        def replaced(match):
            kind, _, name = match[1].rpartition(".")
            if kind == "inputs":
                expect(name in self.text["inputs"], f"the input {name} is not declared")
                return inputs.get(name, self.text["inputs"][name]["default"])
            if match[1] == "github.action_path":
                return action_path
            expect(kind == "steps.check.outputs", f"unknown expression {match[1]}")
            return outputs[name]
        return re.sub(r"\$\{\{ (\S+) \}\}", replaced, str(text))

    def run_step(self, name, inputs, outputs=None, action_path="/nowhere"):
        step = self.steps[name]
        expect("${{" not in step["run"], f"{name}: an expression in a script is executed as text of the script")
        expect(step["shell"] == "bash", f"{name}: shell {step['shell']}")
        files = {key: self.workspace.path("../" + key) for key in ("GITHUB_OUTPUT", "GITHUB_STEP_SUMMARY")}
        for path in files.values():
            write(path, "")
        environment = {key: self.value(text, inputs, outputs, action_path) for key, text in step["env"].items()}
        script = self.workspace.path("../step.sh")
        write(script, step["run"])
        done = self.workspace.shell(script, {**environment, **files}, "bash", "--noprofile", "--norc", "-eo",
                                    "pipefail")
        with open(files["GITHUB_OUTPUT"]) as file:
            found = dict(line.rstrip("\n").split("=", 1) for line in file)
        with open(files["GITHUB_STEP_SUMMARY"]) as file:
            return done, found, file.read()

    def run(self, **inputs):
        """Returns the exit code of the action, the text, the outputs and the summary."""
        inputs = {key.replace("_", "-"): value for key, value in inputs.items()}
        self.workspace.clear()
        done, outputs, summary = self.run_step("Check the programs", inputs)
        if done.returncode != 0:
            return done.returncode, done.stdout + done.stderr, outputs, summary
        verdict = self.run_step("Verdict", inputs, outputs)[0]
        return verdict.returncode, done.stdout + done.stderr, outputs, summary


def check_install(action, workspace, folder):
    done = action.run_step("Install ncsim", {})[0]
    version = done.stdout.strip().split(" ")[-1]
    expect(done.returncode == 0 and done.stdout.startswith("ncsim "), f"installed: {done}")
    expect(action.run_step("Install ncsim", {"version": version})[0].returncode == 0, "the right version")
    done = action.run_step("Install ncsim", {"version": "99.0.0"})[0]
    expect(done.returncode == 2 and "::error title=ncsim::version 99.0.0 is required" in done.stdout, f"{done}")
    # A package, and a build from source, with an apt-get that installs a link.
    log = os.path.join(folder, "log")
    write(os.path.join(workspace.commands, "apt-get"),
          f'#!/bin/sh\necho "$@" >>"{log}"\n[ "$1" != install ] || ln -sf "{workspace.program}" '
          f'"{workspace.commands}/ncsim"\n', 0o755)
    write(os.path.join(workspace.commands, "sudo"), '#!/bin/sh\nexec "$@"\n', 0o755)
    write(workspace.path("tools/n csim.deb"), "")
    write(os.path.join(folder, "source/dev"),
          '#!/bin/sh\n[ "$*" = package ] || exit 9\nmkdir -p "$(dirname "$0")/build"\n'
          ': >"$(dirname "$0")/build/ncsim_1_amd64.deb"\n', 0o755)
    source = os.path.join(folder, "source")
    for inputs, package in (({"package": "tools/n csim.deb"}, workspace.path("tools/n csim.deb")),
                            ({}, os.path.join(source, "build/ncsim_1_amd64.deb"))):
        os.remove(os.path.join(workspace.commands, "ncsim"))
        write(log, "")
        done = action.run_step("Install ncsim", inputs, action_path=source)[0]
        expect(done.returncode == 0 and done.stdout.strip().endswith("ncsim " + version), f"{inputs}: {done}")
        with open(log) as file:
            expect(file.read().split("\n")[1] == f"install -y -q --no-install-recommends {package}", "apt-get")


def check_action(program, tools, folder):
    done = subprocess.run(["node", os.path.join(tools, "validate.mjs"), "action", os.path.join(SOURCE, "action.yml")],
                          capture_output=True, encoding="utf-8")
    expect(done.returncode == 0, f"action.yml does not follow its schema: {done.stdout}{done.stderr}")
    workspace = Workspace(program, folder)
    action = Action(workspace)
    check_install(action, workspace, folder)
    options = f'--machine "my mill.toml" {TOOL}'
    cases = [
        ("good", {"files": "programs/good.nc"}, 0, "0"),
        ("bad", {"files": "programs/bad.nc"}, 1, "1"),
        ("not proven", {"files": "programs/good.nc", "options": ""}, 4, "4"),
        ("a warning fails", {"files": "programs/good.nc", "options": "", "fail_on": "warning"}, 1, "1"),
        ("errors alone fail", {"files": "programs/good.nc", "options": "", "fail_on": "error"}, 0, "4"),
        ("an error", {"files": "programs/bad.nc", "fail_on": "error"}, 1, "1"),
        ("never", {"files": "programs/bad.nc", "fail_on": "never"}, 0, "1"),
        ("never, unreadable", {"files": "missing.nc", "fail_on": "never"}, 2, "2"),
        ("a pattern without files", {"files": "none/*.nc"}, 2, "2"),
        ("blank in a name", {"files": "programs/with blank.nc"}, 0, "0"),
        ("a name like an option", {"files": "-x.nc"}, 0, "0"),
        ("lines", {"files": "programs/good.nc\n\n  \nprograms/bad.nc\n"}, 1, "1"),
        ("unknown option", {"files": "programs/good.nc", "options": "--wrong"}, 2, "2"),
    ]
    for name, inputs, code, exit_code in cases:
        found, text, outputs, _ = action.run(**{"options": options, **inputs})
        expect(found == code and outputs["exit-code"] == exit_code, f"{name}: {found}, {outputs}\n{text}")
    found, text, _, _ = action.run(files="programs/good.nc", fail_on="errors")
    expect(found == 2 and "fail-on must be" in text, f"a wrong fail-on: {found} {text}")

    found, text, _, summary = action.run(files="programs/*.nc", options=options, junit="ncsim.xml", json="ncsim.json")
    expect(found == 1, text)
    expect(re.search(r"^::error file=programs/bad.nc,line=\d+,col=\d+,title=rapid-in-material::", text, re.M), text)
    expect("&lt;b&gt;.nc" in summary and "<b>" not in summary and "::error" not in summary, summary)
    expect(summary.count("<pre>") == summary.count("</pre>") == 1 and "4 programs" in summary, summary)
    with open(workspace.path("ncsim.sarif")) as file:
        results = json.load(file)["runs"][0]["results"]
    expect("rapid-in-material" in [result["ruleId"] for result in results], f"SARIF: {results}")
    with open(workspace.path("ncsim.json")) as file:
        expect(len(json.load(file)["programs"]) == 4, "JSON")
    xml.etree.ElementTree.parse(workspace.path("ncsim.xml"))
    text = action.run(files="programs/bad.nc", options=options, annotations="false")[1]
    expect("::error" not in text and "[rapid-in-material]" in text, text)
    upload = action.steps["Upload the SARIF report"]
    used = [step["with"] for text in examples() for job in text.get("jobs", {}).values() for step in job["steps"]
            if "/ncsim@" in step.get("uses", "")]
    expect(used and all(set(inputs) <= set(action.text["inputs"]) for inputs in used), f"docs/ci.md: {used}")
    for name in action.text["inputs"]:
        expect(f"`{name}`" in read("docs/ci.md"), f"docs/ci.md has no input {name}")
    expect(upload["if"] == "inputs.upload-sarif == 'true'", upload)
    print(f"action: {len(cases) + 10} runs")


# The component of GitLab.

def check_gitlab(program, _, folder):
    spec, jobs = yaml.safe_load_all(read("templates/ncsim.yml"))
    inputs = spec["spec"]["inputs"]
    used = set(re.findall(r"\$\[\[ inputs\.([\w-]+) \]\]", read("templates/ncsim.yml")))
    expect(used == set(inputs), f"inputs: {sorted(used ^ set(inputs))} are not both declared and used")
    for name, description in inputs.items():
        expect(set(description) <= {"description", "default", "options", "regex", "type"}, f"{name}: {description}")
        expect(isinstance(description["default"], str) and description["description"], f"{name}: {description}")
        expect(description["default"] in description.get("options", [description["default"]]), name)
    shown = [entry["inputs"] for text in examples() for entry in text.get("include", [])]
    expect(shown and all(set(values) <= set(inputs) for values in shown), f"docs/ci.md: {shown}")
    for name in inputs:
        expect(f"`{name}`" in read("docs/ci.md"), f"docs/ci.md has no input {name}")
    (name, job), = jobs.items()
    expect(name == "$[[ inputs.job-name ]]", name)
    expect(set(job) == {"stage", "image", "variables", "script", "artifacts"}, f"keys of the job: {set(job)}")
    expect(all(isinstance(line, str) for line in job["script"]), "a line of the script is no text")
    expect("inputs." not in "".join(job["script"]), "an input in a script is executed as text of the script")
    workspace = Workspace(program, folder)
    good = f"programs/good.nc", f"--machine my?mill.toml {TOOL}"
    bad = "programs/b*.nc", good[1]
    cases = [(good, "not-proven", 0), (bad, "not-proven", 1), (bad, "error", 1), (bad, "never", 0),
             ((good[0], ""), "not-proven", 4), ((good[0], ""), "error", 0), ((good[0], ""), "warning", 1),
             (("missing.nc", ""), "never", 2)]
    for shell in (["bash", "-eo", "pipefail", "-c"], ["sh", "-ec"]):
        for (files, options), fail_on, code in cases:
            values = {"files": files, "options": options, "fail-on": fail_on}
            def value(text):
                return re.sub(r"\$\[\[ inputs\.([\w-]+) \]\]",
                              lambda match: values.get(match[1], inputs[match[1]]["default"]), text)
            workspace.clear()
            done = workspace.shell("\n".join(job["script"]), {k: value(v) for k, v in job["variables"].items()}, *shell)
            expect(done.returncode == code, f"{files} {options} {fail_on}: {done}")
            if code != 2:
                for report in job["artifacts"]["paths"] + [job["artifacts"]["reports"]["junit"]]:
                    expect(os.path.getsize(workspace.path(report)) > 0, report)
    print(f"gitlab: {2 * len(cases)} runs")


# The hooks of pre-commit.

def check_pre_commit(program, _, folder):
    need("pre-commit")
    need("git")
    hooks = {hook["id"] for hook in yaml.safe_load(read(".pre-commit-hooks.yaml"))}
    shown = {hook["id"] for text in examples() for repo in text.get("repos", []) for hook in repo["hooks"]}
    expect(shown == hooks, f"docs/ci.md: {shown}")
    workspace = Workspace(program, folder)
    os.remove(workspace.path("programs/<b>.nc"))
    os.remove(workspace.path("-x.nc"))
    hooks = os.path.join(folder, "hooks")
    write(os.path.join(hooks, ".pre-commit-hooks.yaml"), read(".pre-commit-hooks.yaml"))
    environment = {"PRE_COMMIT_HOME": os.path.join(folder, "cache"), "GIT_AUTHOR_NAME": "test",
                   "GIT_AUTHOR_EMAIL": "test@example.org", "GIT_COMMITTER_NAME": "test",
                   "GIT_COMMITTER_EMAIL": "test@example.org", "GIT_CONFIG_NOSYSTEM": "1"}

    def run(directory, *arguments):
        return subprocess.run(arguments, cwd=directory, env={**workspace.environment, **environment},
                              capture_output=True, encoding="utf-8")

    done = run(hooks, "pre-commit", "validate-manifest", ".pre-commit-hooks.yaml")
    expect(done.returncode == 0, f"the manifest is not valid: {done}")
    for directory in (hooks, workspace.folder):
        run(directory, "git", "init", "-q")
    run(hooks, "git", "add", "-A")
    run(hooks, "git", "commit", "-qm", "hooks")
    revision = run(hooks, "git", "rev-parse", "HEAD").stdout.strip()
    expect(revision, "no commit of the hooks")
    config = {"repos": [{"repo": hooks, "rev": revision, "hooks": [
        {"id": "ncsim-check", "args": ["--machine", "my mill.toml", *TOOL.split(), "--"]}]}]}
    write(workspace.path(".pre-commit-config.yaml"), yaml.safe_dump(config))
    write(workspace.path("notes.txt"), "Notes of the shop\n")
    run(workspace.folder, "git", "add", ".pre-commit-config.yaml", "notes.txt", "programs/good.nc",
        "programs/with blank.nc")
    done = run(workspace.folder, "pre-commit", "run", "--verbose")
    expect(done.returncode == 0 and "2 programs: 2 clean" in done.stdout, f"clean programs: {done}")
    run(workspace.folder, "git", "add", "programs/bad.nc")
    done = run(workspace.folder, "pre-commit", "run")
    expect(done.returncode == 1 and "programs/bad.nc:" in done.stdout and "exit code: 1" in done.stdout, f"{done}")
    config["repos"][0]["hooks"] = [{"id": "ncsim-check-repository"}]
    write(workspace.path(".pre-commit-config.yaml"), yaml.safe_dump(config))
    write(workspace.path("ncsim.toml"), 'version = 1\nmachine = "my mill.toml"\ntool = ["T1=flat:D10:L22"]\n')
    run(workspace.folder, "git", "add", ".pre-commit-config.yaml", "ncsim.toml")
    done = run(workspace.folder, "pre-commit", "run")
    expect(done.returncode == 1 and "3 programs: 2 clean, 0 not proven, 1 failed" in done.stdout, f"{done}")
    os.remove(workspace.path("programs/bad.nc"))
    run(workspace.folder, "git", "add", "-A")
    done = run(workspace.folder, "pre-commit", "run")
    expect(done.returncode == 0, f"{done}")
    print("pre-commit: 4 runs")


# The problem matcher.

# The package problem-matcher has no severity for the word note; VS Code reads it as information.
SEVERITIES = {"error": "error", "warning": "warning", "note": None}


def expected_problems(report):
    """Returns (file, line, column, severity, message, rule) of each finding and doubt of a JSON report."""
    problems = []
    for program in report["programs"]:
        for finding in program["findings"]:
            if finding["suppressed"] or finding.get("accepted"):
                continue
            rule = finding["rule"] + (":" + finding["code"] if finding.get("code") else "")
            problems.append((finding["file"], finding.get("line"), finding.get("column"),
                             SEVERITIES[finding["severity"]], finding["message"], rule))
        for doubt in program["doubts"]:
            if not doubt["accepted"]:
                problems.append((doubt["file"], doubt.get("line"), doubt.get("column"), "warning", doubt["message"],
                                 doubt["reason"]))
    return problems


def check_github_rules(matchers):
    """GitHub: owners differ, the last pattern has a message, indices are groups, severities are known."""
    expect(len({matcher["owner"] for matcher in matchers}) == len(matchers), "owners")
    for matcher in matchers:
        expect(matcher.get("severity", "error") in ("error", "warning", "notice"), matcher)
        for pattern in matcher["pattern"]:
            groups = re.compile(pattern["regexp"]).groups
            indices = [value for value in pattern.values() if isinstance(value, int)]
            expect(sorted(indices) == list(range(1, groups + 1)) and "message" in pattern, pattern)


def check_matcher(program, tools, _):
    path = os.path.join(SOURCE, "docs/problem-matcher.json")
    check_github_rules(json.loads(read("docs/problem-matcher.json"))["problemMatcher"])
    with open(os.path.join(VERDICTS, "index.json")) as file:
        entries = json.load(file)
    calls = {}
    for entry in entries[::4]:  # the others have the same kinds of lines
        calls.setdefault(tuple(entry["options"]), []).append(entry["program"])
    lines, expected = [], []
    with tempfile.TemporaryDirectory() as folder:
        for options, programs in calls.items():
            report = os.path.join(folder, "report.json")
            programs = list(dict.fromkeys(programs))
            done = subprocess.run([program, "check", *programs, *options, "--notes", "--json", report], cwd=VERDICTS,
                                  capture_output=True, encoding="utf-8")
            expect(done.returncode in (0, 1, 4), f"{options}: {done.stderr}")
            lines += done.stdout.split("\n")
            with open(report) as file:
                expected += expected_problems(json.load(file))
    done = subprocess.run(["node", os.path.join(tools, "validate.mjs"), "matcher", path],
                          input=json.dumps({"lines": lines}), capture_output=True, encoding="utf-8", check=True)
    found = []
    for line, problems in zip(lines, json.loads(done.stdout)):
        expect(len(problems) < 2, f"{len(problems)} matchers for {line}: {problems}")
        for problem in problems:
            found.append((problem["file"], problem.get("line"), problem.get("column"), problem.get("severity"),
                          problem["message"], problem["code"]))
    key = lambda p: (p[0], p[1] or 0, p[2] or 0, p[5], p[3] or "", p[4])
    found.sort(key=key)
    expected.sort(key=key)
    for one, other in zip(found, expected):
        expect(one[:4] == other[:4] and one[5] == other[5] and one[4].startswith(other[4]),
               f"matched: {one}\nreport:  {other}")
    expect(len(found) == len(expected) > 50, f"{len(found)} matched, {len(expected)} in the reports")
    print(f"matcher: {len(found)} findings and doubts of {sum(map(len, calls.values()))} programs, "
          f"{len(lines)} lines")


def main():
    program, part, tools = os.path.abspath(sys.argv[1]), sys.argv[2], os.path.abspath(sys.argv[3])
    parts = {"action": check_action, "gitlab": check_gitlab, "pre-commit": check_pre_commit, "matcher": check_matcher}
    with tempfile.TemporaryDirectory(prefix="ncsim-ci-") as folder:
        parts[part](program, tools, folder)


if __name__ == "__main__":
    main()
