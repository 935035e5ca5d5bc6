#!/usr/bin/env python3
"""Tests the man pages and shell completions that cmake/help_pages.py writes.

Usage: help_pages_test.py NCSIM pages|bash|zsh|fish

bash and zsh run on a terminal. The Tab key inserts all completions there, and a function ncsim stores the
words of the line. fish prints completions itself. Exits with 77 if a shell or a formatter is missing.
"""
import gzip
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import time

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../cmake/help_pages.py")
SKIPPED = 77
PATIENCE = 600  # s; only a shell that hangs needs as long
VIEWS = "iso top bottom front back left right".split()
FILES = ["part.nc", "part.png", "OLD.PNG", "part two.png", "part.glb", "mill.toml", "mill.urdf", "many.txt"]

# A typed line, and the words that may stand in place of its last word.
CASES = [
    ("ncsim ru", ["run", "rules"]),
    ("ncsim mea", ["measure"]),
    ("ncsim --ver", ["--version"]),
    ("ncsim help me", ["measure", "merge"]),
    ("ncsim help ver", ["verdicts"]),
    ("ncsim run --vi", ["--view", "--views"]),
    ("ncsim run part.nc --3", ["--3mf"]),
    ("ncsim rules --j", ["--json"]),
    ("ncsim rules --v", []),
    ("ncsim run --view ", VIEWS),
    ("ncsim run --view=b", ["--view=bottom", "--view=back"]),
    ("ncsim run --views iso,b", ["iso,bottom", "iso,back"]),
    ("ncsim merge --view ri", ["right"]),
    ("ncsim check --dialect f", ["fanuc"]),
    ("ncsim check --model c", ["cda"]),
    ("ncsim measure --model c", ["cda", "cda-flat"]),
    ("ncsim parse --for grb", ["grbl", "grblhal"]),
    ("ncsim check --require holder,t", ["holder,travels"]),
    ("ncsim check --select rapid", ["rapid-in-material"]),
    ("ncsim check --ignore plunge,rapid", ["plunge,rapid-in-material"]),
    ("ncsim check --severity plunge=e", ["plunge=error"]),
    ("ncsim check --accept stock-", ["stock-guess"]),
    ("ncsim tools --block-delete of", ["off"]),
    ("ncsim tools --block-delete part.n", ["part.nc"]),
    ("ncsim run --increments=o", ["--increments=on", "--increments=off"]),
    ("ncsim run --png pa", ["part.png", "part two.png"]),
    ("ncsim run --png OL", ["OLD.PNG"]),
    ("ncsim run --png=part.", ["--png=part.png"]),
    ("ncsim run --frames p", ["pictures"]),
    ("ncsim run --machine mi", ["mill.toml", "mill.urdf"]),
    ("ncsim check --list ma", ["many.txt"]),
    ("ncsim machine mi", ["mill.toml", "mill.urdf"]),
    ("ncsim run part.n", ["part.nc"]),
    ("ncsim init -o mill.t", ["mill.toml"]),
]


def output_of(*arguments, **options):
    return subprocess.run(arguments, capture_output=True, encoding="utf-8", check=True, **options)


def option_names(program, command):
    """Returns the options in the help of `command`: the first words of its indented lines."""
    text = output_of(program, *command.split(), "--help").stdout
    return set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.M))


def commands_of(program):
    return re.findall(r"^  ([a-z]+) ", output_of(program, "--help").stdout.split("Subcommands:")[1].split("Topics:")[0],
                      re.M)


def expect(is_true, message):
    if not is_true:
        sys.exit("FAILED: " + message)


def need(*programs):
    for program in programs:
        if not shutil.which(program):
            print(f"skipped: no {program} (packages.txt)")
            sys.exit(SKIPPED)


def check_pages(program, folder):
    need("groff", "man", "mandoc")
    pages = os.path.join(folder, "man/man1")
    commands = commands_of(program)
    expect(sorted(os.listdir(pages)) == sorted(["ncsim.1"] + [f"ncsim-{name}.1" for name in commands]),
           f"pages: {os.listdir(pages)}")
    environment = dict(os.environ, MANWIDTH="80", LC_ALL="C.UTF-8", MANROFFOPT="")
    main_page = output_of("man", "-l", os.path.join(pages, "ncsim.1"), env=environment).stdout
    for command in [""] + commands:
        path = os.path.join(pages, f"ncsim-{command}.1" if command else "ncsim.1")
        for arguments in (["groff", "-man", "-ww", "-z", "-Tutf8", path], ["mandoc", "-Tlint", "-W", "warning", path],
                          ["man", "--warnings", "-E", "UTF-8", "-l", path]):
            done = subprocess.run(arguments, capture_output=True, encoding="utf-8", env=environment)
            said = done.stderr + (done.stdout if arguments[0] == "mandoc" else "")
            expect(done.returncode == 0 and not said, f"{' '.join(arguments)}: {said}")
        text = done.stdout
        text = re.sub(r".\x08", "", text).replace("\u2010\n", "")
        for option in option_names(program, command):
            expect(re.search(rf"^ +(-\w, )?{option}(?![\w-])", text, re.M), f"{path} has no {option}")
        for word in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
            expect(re.search(rf"^{word}$", text, re.M), f"{path} has no section {word}")
        expect(f"ncsim {command}" in main_page, f"ncsim.1 does not list {command}")


def check_script(program, folder):
    """Same bytes twice; compressed pages are the same text; an unknown line of help is an error."""
    with tempfile.TemporaryDirectory() as second:
        write(program, second, "--gzip")
        for root, _, names in os.walk(folder):
            for name in names:
                path = os.path.join(root, name)
                with open(path, "rb") as file:
                    data = file.read()
                other = os.path.join(second, os.path.relpath(path, folder))
                if "/man/" in path:
                    with open(other + ".gz", "rb") as file:
                        packed = file.read()
                    expect(packed[4:8] == b"\0\0\0\0", f"{name}.gz has the time at which it was written")
                    expect(gzip.decompress(packed) == data, f"{name}.gz differs from {name}")
                else:
                    with open(other, "rb") as file:
                        expect(file.read() == data, f"{name} differs in a second run")
        fake = os.path.join(second, "fake")
        with open(fake, "w") as file:
            file.write("#!/bin/sh\necho Summary\necho\necho Options:\necho '  an unknown line'\n")
        os.chmod(fake, 0o755)
        done = subprocess.run([sys.executable, SCRIPT, fake, os.path.join(second, "out")], capture_output=True,
                              encoding="utf-8")
        expect(done.returncode != 0 and "an unknown line" in done.stderr, "an unknown line of help is passed over")
        expect(not os.path.exists(os.path.join(second, "out")), "files were written in spite of an error")


def write(program, folder, *options):
    output_of(sys.executable, SCRIPT, program, folder, *options, env=dict(os.environ, SOURCE_DATE_EPOCH="1700000000"))


class Terminal:
    """An interactive shell, in which Tab inserts all completions and ncsim writes its arguments to a file."""

    def __init__(self, arguments, setup, folder):
        self.answer = os.path.join(folder, "answer")
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.chdir(os.path.join(folder, "work"))
            os.environ.update(TERM="dumb", LC_ALL="C.UTF-8", HISTFILE="/dev/null", INPUTRC="/dev/null",
                              ZDOTDIR=folder)
            os.execvp(arguments[0], arguments)
        store = f"ncsim() {{ printf '%s\\n' \"$@\" >{self.answer}.part; command mv {self.answer}.part {self.answer}; }}"
        with open(os.path.join(folder, "setup"), "w") as file:
            file.write(setup + "\n" + store + "\n")
        os.write(self.terminal, f". {folder}/setup; ncsim ready\n".encode())
        expect(self.wait() == ["ready"], "the shell does not start")

    def wait(self):
        """Returns the stored arguments. Reads the terminal, because a full one stops the shell."""
        end = time.monotonic() + PATIENCE
        os.set_blocking(self.terminal, False)
        said = b""
        while not os.path.exists(self.answer):
            try:
                said += os.read(self.terminal, 65536)
            except (BlockingIOError, OSError):
                time.sleep(0.01)
            expect(time.monotonic() < end, f"no answer from the shell; it printed {said.decode(errors='replace')}")
        with open(self.answer) as file:
            words = file.read().split("\n")[:-1]
        os.remove(self.answer)
        return words

    def complete(self, line):
        os.write(self.terminal, line.encode() + b"\t")
        time.sleep(0.05)  # a pasted line end would end the line before the completion
        os.write(self.terminal, b"\n")
        typed = line.split(" ")
        words = self.wait()
        start = typed[1:-1]
        expect(words[:len(start)] == start, f"{line}: the line became {words}")
        found = [word for word in words[len(start):] if word]
        # A line that stays as typed has no completion.
        return [] if found == [typed[-1]] and not os.path.exists(os.path.join("work", typed[-1])) else found

    def close(self):
        os.write(self.terminal, b"exit\n")
        end = time.monotonic() + PATIENCE
        while os.waitpid(self.pid, os.WNOHANG)[0] == 0 and time.monotonic() < end:
            time.sleep(0.01)
        os.close(self.terminal)


class Fish:
    def __init__(self, completion, folder):
        self.completion, self.folder = completion, folder

    def complete(self, line):
        script = "source $argv[1]; complete -C $argv[2]"
        done = output_of("fish", "--no-config", "-c", script, self.completion, line, cwd=os.path.join(self.folder, "work"),
                         env=dict(os.environ, HOME=self.folder, LC_ALL="C.UTF-8"))
        expect(not done.stderr, f"fish: {line}: {done.stderr}")
        return [row.split("\t")[0].replace("\\ ", " ") for row in done.stdout.split("\n") if row]

    def close(self):
        pass


def open_shell(shell, share, folder):
    if shell == "bash":
        setup = f"bind '\"\\t\": insert-completions'; . {share}/bash-completion/completions/ncsim"
        return Terminal(["bash", "--norc", "--noprofile", "-i"], setup, folder)
    if shell == "zsh":
        setup = (f"fpath=({share}/zsh/vendor-completions $fpath)\n"
                 "autoload -U compinit && compinit -D -u\n"
                 "all_matches() { _main_complete; compstate[insert]=all }\n"
                 "zle -C all-matches complete-word all_matches\nbindkey '^I' all-matches\n"
                 "zstyle ':completion:*' insert-tab false\n")
        return Terminal(["zsh", "-f", "-i"], setup, folder)
    return Fish(f"{share}/fish/vendor_completions.d/ncsim.fish", folder)


def check_shell(shell, program, share):
    need(shell)
    with tempfile.TemporaryDirectory(prefix="ncsim-help-") as folder:
        os.makedirs(os.path.join(folder, "work/pictures"))
        for name in FILES:
            with open(os.path.join(folder, "work", name), "w"):
                pass
        os.chdir(folder)
        completion = open_shell(shell, share, folder)
        cases = CASES + [(f"ncsim {command} --", sorted(option_names(program, command)))
                         for command in commands_of(program)]
        faults = []
        for line, words in cases:
            found = [word.rstrip("/") for word in completion.complete(line)]
            typed = line.split(" ")[-1]
            if shell == "bash" and "=" in typed:  # bash inserts the further words without the part before =
                start = typed[:typed.index("=") + 1]
                found = found[:1] + [word if word.startswith(start) else start + word for word in found[1:]]
            if sorted(found) != sorted(words):
                faults.append(f"{line}: {' '.join(sorted(found))}; expected {' '.join(sorted(words))}")
        completion.close()
        os.chdir("/")
        expect(not faults, f"{shell}:\n" + "\n".join(faults))
        print(f"{shell}: {len(cases)} lines completed")


def check_values(program, share):
    """The program accepts each value that the completion of bash offers, and refuses another one."""
    with open(os.path.join(share, "bash-completion/completions/ncsim")) as file:
        text = file.read()
    seen = set()  # commands share options
    for command, body in re.findall(r"^    (\w+)\)\n(.*?)^        ;;", text, re.M | re.S):
        files = ["none.nc", "none.nc"] if command == "diff" else ["none.nc"]
        for option, kind, values in re.findall(r"^        (\S+)\) kind=(words|list) offered='(.+)' ;;", body, re.M):
            for value in values.split():
                if (option, value) in seen:
                    continue
                seen.add((option, value))
                done = subprocess.run([program, command, *files, option, value], capture_output=True,
                                      encoding="utf-8", cwd=share)
                expect("expected" not in done.stderr and "of this name" not in done.stderr,
                       f"ncsim {command} {option} {value}: {done.stderr}")
                if kind == "list" and len(values.split()) > 20:
                    break  # rules and reasons: ncsim rules lists these
    expect(len(seen) > 50, f"only {len(seen)} values are offered")
    print(f"{len(seen)} values accepted")


def main():
    program, part = os.path.abspath(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        write(program, folder)
        if part == "pages":
            check_script(program, folder)
            check_values(program, folder)
            check_pages(program, folder)
        else:
            check_shell(part, program, folder)


if __name__ == "__main__":
    main()
