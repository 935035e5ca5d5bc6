#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes man pages and shell completions of ncsim from the help that the program prints.

Usage: help_pages.py NCSIM FOLDER [--gzip]

Writes below FOLDER, in the layout of /usr/share:
  man/man1/ncsim.1, ncsim-COMMAND.1     pages; with --gzip: ncsim.1.gz, as Debian installs pages
  bash-completion/completions/ncsim
  zsh/vendor-completions/_ncsim
  fish/vendor_completions.d/ncsim.fish

Requires: NCSIM runs on this machine.
Guarantees: the same program gives the same bytes. The date of the pages is SOURCE_DATE_EPOCH, if set.
Source: commands, options and texts are lines of `ncsim --help` and `ncsim COMMAND --help`. Values of an
option are the values that the program lists when it refuses another one. Rules: `ncsim rules --json`.
"""
import datetime
import gzip
import json
import os
import re
import subprocess
import sys

OPTION = re.compile(r"  (?:(-\w),)?(--[\w-]+)(?: (\S+))?(?:\s{2,}(.*))?$")
POSITIONAL = re.compile(r"  (\w+) ([A-Z]+)\s{2,}(.*)$")
COMMAND = re.compile(r"  ([a-z-]+)\s{2,}(.*)$")  # or a topic
FOOTER = re.compile(r"([A-Z][A-Za-z ]*): +(\S.*)$")
REFUSED = "?"  # no option has this value
SEVERITIES = ["note", "warning", "error"]

# Endings of files by the words of a description.
ENDINGS = {"TOML": "toml", "JSON": "json", "XML": "xml", "CSV": "csv", "HTML": "html", "SARIF": "sarif",
           "Page": "html", "PNG": "png", "Picture": "png", "Animation": "gif", "STL": "stl", "PLY": "ply",
           "3MF": "3mf", "GLB": "glb", "glTF": "glb", "VRML97": "wrl", "STEP": "step stp", "DXF": "dxf",
           "SVG": "svg", "URDF": "urdf", "INI": "ini"}


class Option:
    """An option or a positional argument of a command, with the values that it takes."""

    def __init__(self, short, name, type_name, text):
        self.short, self.name, self.type, self.text = short, name, type_name or "", text or ""
        self.values = []       # permitted values
        self.is_list = False   # several values with commas

    @property
    def is_switch(self):
        return not self.type and self.text.endswith(": on, off")

    @property
    def is_folder(self):
        return self.type in ("DIR", "DIRS")

    @property
    def is_file(self):
        return not self.values and (self.type in ("FILE", "FILES", "OLD", "NEW") or self.type == "STOCK")

    @property
    def repeats(self):
        return "repeatable" in self.text or self.is_list or self.type == "RULE=S"

    def endings(self):
        """Returns the endings of its files; empty if a file may have any name."""
        if not self.is_file or "NC program" in self.text:
            return []
        found = []
        for word in re.findall(r"\.[a-z]\w*|\w+", self.text):
            found += [word[1:]] if word[0] == "." else ENDINGS.get(word, "").split()
        if self.name == "--step":
            found += ["step", "stp"]
        if "step" in found and "stp" not in found:
            found.append("stp")
        if self.text.startswith("Machine:") and "Fusion" in self.text:
            found.append("machine")
        return list(dict.fromkeys(found))


class Command:
    """The help of ncsim or of one of its commands."""

    def __init__(self, name, text):
        self.name = name
        self.groups = []       # (title, options)
        self.positionals = []
        self.commands = []     # (name, text), of ncsim alone
        self.topics = []       # (name, text), of ncsim alone
        self.footers = []      # (title, text)
        self.summary = self.usage = ""
        self.parse(text)

    @property
    def options(self):
        return [option for _, options in self.groups for option in options]

    def parse(self, text):
        lines = text.rstrip("\n").split("\n")
        self.summary = lines[0]
        title = ""
        last = None
        for line in lines[1:]:
            usage = re.match(r"Usage: (.*)", line)
            footer = FOOTER.match(line)
            if not line:
                last = None
            elif usage:
                self.usage = usage[1]
            elif re.match(r"[A-Z].*:$", line):
                title = line[:-1]
                if title not in ("Positionals", "Subcommands", "Topics"):
                    self.groups.append((title, []))
            elif footer:
                self.footers.append(footer.groups())
                title = "footer"
            elif title == "footer":
                name, words = self.footers[-1]
                self.footers[-1] = (name, words + " " + line.strip())
            elif title == "Subcommands":
                self.commands.append(COMMAND.match(line).groups())
            elif title == "Topics":
                self.topics.append(COMMAND.match(line).groups())
            elif title == "Positionals":
                name, type_name, words = POSITIONAL.match(line).groups()
                self.positionals.append(Option(None, name, type_name, words))
            elif last and line.startswith(" " * 20):
                last.text = (last.text + " " + line.strip()).strip()
            else:
                match = OPTION.match(line)
                if not match:
                    raise ValueError(f"ncsim {self.name} --help has an unknown line: {line}")
                last = Option(*match.groups())
                self.groups[-1][1].append(last)


def output_of(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL,
                          check=True).stdout


def has_word(text, word):
    return re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text) is not None


def values_of(program, command, option):
    """Returns the values that the program lists when it refuses REFUSED; empty if it lists none."""
    files = {"diff": ["none.nc", "none.nc"], "machine": ["none.toml"], "merge": ["none"]}.get(command, ["none.nc"])
    done = subprocess.run([program, command, option.name, REFUSED, *files], capture_output=True, encoding="utf-8",
                          stdin=subprocess.DEVNULL, cwd="/")
    start = f"ncsim: {option.name} '{REFUSED}': expected "
    answer = done.stderr.split("\n")[0]
    if done.returncode != 2 or not answer.startswith(start):
        return []
    values = re.split(r", | or ", answer[len(start):])
    if not all(re.fullmatch(r"[a-z0-9-]+", value) for value in values):
        return []
    # A help text without … has all values of the command, which may be fewer than those of the program.
    named = [value for value in values if has_word(option.text, value)]
    return named if named and "…" not in option.text else values


def find_values(program, commands):
    """Sets the values of the options of `commands`."""
    rules = json.loads(output_of(program, "rules", "--json"))
    names = [rule["id"] for rule in rules["rules"]]
    categories = list(dict.fromkeys(rule["category"] for rule in rules["rules"]))
    reasons = [reason["id"] for reason in rules["reasons"]]
    known = {}
    for command in commands:
        for option in command.options:
            if option.type == "RULES":
                option.values, option.is_list = names + categories, True
            elif option.type == "REASONS":
                option.values, option.is_list = ["all"] + reasons, True
            elif option.type == "RULE=S":
                option.values = names + categories
            elif option.is_switch:
                option.values = ["on", "off"]
            elif option.type in ("NAME", "VIEW", "WHAT", "UNIT", "PATH", "CONTROL", "THINGS", "MARKS"):
                option.values = values_of(program, command.name, option)
                option.is_list = option.type in ("THINGS", "MARKS")
                known.setdefault(option.text, option.values)
    for command in commands:
        for option in command.options:
            if option.type == "VIEW" and not option.values:  # merge and machine read other arguments first
                option.values = known.get(option.text, [])
            if option.type == "LIST":
                option.values = next((o.values for o in command.options if o.type == "VIEW"), [])
                option.is_list = True


# Man pages.

def roff(text):
    """Returns `text` for roff: backslashes, hyphens and characters beyond ASCII as escapes."""
    text = text.replace("\\", r"\e").replace("-", r"\-").replace("'", r"\(aq").replace("`", r"\(ga")
    text = "".join(c if ord(c) < 128 else f"\\[u{ord(c):04X}]" for c in text)
    return r"\&" + text if text.startswith(".") else text


def quoted(text):
    return '"' + roff(text).replace('"', r"\(dq") + '"'


def option_entry(option):
    names = ", ".join(rf"\fB{roff(name)}\fR" for name in (option.short, option.name) if name)
    value = rf" \fI{roff(option.type)}\fR" if option.type else ""
    text = option.text[:1].upper() + option.text[1:] + "."
    if option.type in ("RULES", "REASONS", "RULE=S"):
        text += " ncsim rules lists the names."
    elif any(not has_word(text, value) for value in option.values):
        text += f" Values: {', '.join(option.values)}."
    return [".TP", names + value, roff(text)]


def page_date():
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    return datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc).strftime("%Y-%m-%d") if epoch else ""


def footer_lines(command):
    """Returns sections of the notes below the options: notation, files, exit status, examples."""
    lines = []
    for title, text in command.footers:
        if title == "Exit codes":
            lines += [".SH EXIT STATUS"]
            for code, meaning in re.findall(r"(\d) (.*?)(?:; |\.?$)", text):
                lines += [".TP", rf"\fB{code}\fR", roff(meaning[0].upper() + meaning[1:]) + "."]
        elif title == "Example":
            lines += [".SH EXAMPLES", ".nf", roff(text), ".fi"]
        else:
            text = re.sub(r" {2,}", "; ", text)
            lines += [f".SH {title.upper()}", roff(text) + ("" if text.endswith(".") else ".")]
    return lines


def man_page(version, command, others):
    page = "ncsim-" + command.name if command.name else "ncsim"
    title, summary = page.upper(), command.summary
    if not command.name:
        summary = re.sub(r"^ncsim (\w)", r"\1", summary).rstrip(".")
    lines = [r'.\" Written by cmake/help_pages.py from the help of ncsim.',
             f'.TH {quoted(title)} 1 "{page_date()}" {quoted(version)} "User Commands"',
             ".SH NAME", rf"{roff(page)} \- {roff(summary[0].lower() + summary[1:])}", ".SH SYNOPSIS"]
    if command.name:
        words = command.usage.split(" ", 1)
        lines += [rf".B ncsim {roff(words[0])}", roff(words[1]) if len(words) > 1 else ""]
    else:
        lines += [".B ncsim", r"\fICOMMAND\fR [\fIOPTIONS\fR] [\fIFILES\fR]", ".br", ".B ncsim",
                  r"\fBhelp\fR \fITOPIC\fR"]
    lines += [".SH DESCRIPTION", roff(command.summary) + ("" if command.summary.endswith(".") else ".")]
    for option in command.positionals:
        lines += [".TP", rf"\fI{roff(option.name)}\fR", roff(option.text) + "."]
    if command.commands:
        lines += [".SH COMMANDS"]
        for name, text in command.commands:
            lines += [".TP", rf"\fBncsim {name}\fR", roff(text) + "."]
    if command.topics:
        lines += [".SH TOPICS"]
        for name, text in command.topics:
            lines += [".TP", rf"\fBncsim help {roff(name)}\fR", roff(text) + "."]
    lines += [".SH OPTIONS"]
    for group, options in command.groups:
        if group != "Options":
            lines += [f".SS {quoted(group)}"]
        for option in options:
            lines += option_entry(option)
    lines += footer_lines(command) + [".SH SEE ALSO"]
    lines += [", ".join(rf"\fB{roff(name)}\fR(1)" for name in others if name != page) + "."]
    return "\n".join(line for line in lines if line) + "\n"


# Completion for bash.

BASH_HEAD = r"""# Completion of ncsim for bash, written by cmake/help_pages.py from the help of ncsim.

# Offers those of the words $2... that begin with the value $1. bash replaces only the part after the last
# = or :, so the reply has this part alone.
__ncsim_offer_words() {
    local value=$1 word rest=$cur cut
    shift
    [[ $rest == "=" || $rest == ":" ]] && rest=
    cut=${value%"$rest"}
    for word; do
        [[ $word == "$value"* ]] && COMPREPLY+=("${word#"$cut"}")
    done
}

# Offers the words $2... after the last comma of the value $1.
__ncsim_offer_list() {
    local value=$1 before=
    shift
    [[ $value == *,* ]] && before=${value%,*},
    __ncsim_offer_words "$value" "${@/#/$before}"
}

# Offers folders, and files with the endings $2..., that begin with the value $1. Without such a file the
# reply is empty, and bash offers all files.
__ncsim_offer_files() {
    local value=$1 ending rest=$cur cut name
    shift
    [[ $rest == "=" ]] && rest=
    cut=${value%"$rest"}
    compopt -o filenames 2>/dev/null
    while IFS= read -r name; do
        COMPREPLY+=("${name#"$cut"}")
    done < <(
        compgen -d -- "$value"
        for ending; do
            compgen -f -X "!*.$ending" -- "$value"
            compgen -f -X "!*.${ending^^}" -- "$value"
        done
    )
}

_ncsim() {
    local cur=${COMP_WORDS[COMP_CWORD]} line=${COMP_LINE:0:COMP_POINT}
    local command typed option= value options kind= offered
    local -a typed_words
    read -ra typed_words <<<"$line"
    [[ $line == *[[:space:]] ]] && typed_words+=("")
    typed=${typed_words[-1]}
    command=${typed_words[1]}
    COMPREPLY=()
    if ((${#typed_words[@]} == 2)); then
        __ncsim_offer_words "$typed" @COMMANDS@
        return
    fi
    value=$typed
    option=${typed_words[-2]}
    if [[ $typed == --*=* ]]; then
        option=${typed%%=*}
        value=${typed#*=}
    fi
    # kind: what the option takes (words, list, files, folder, severity, switch, text); empty: no value.
    case $command in
"""

BASH_TAIL = r"""    esac
    # shellcheck disable=SC2086 # lists of words
    case $kind in
    words) __ncsim_offer_words "$value" $offered ;;
    list) __ncsim_offer_list "$value" $offered ;;
    severity)
        if [[ $value == *=* ]]; then
            offered="${value%%=*}=note ${value%%=*}=warning ${value%%=*}=error"
            __ncsim_offer_words "$value" $offered
        else
            compopt -o nospace 2>/dev/null
            __ncsim_offer_words "$value" ${offered// /= }=
        fi
        ;;
    files) __ncsim_offer_files "$value" $offered ;;
    folder) __ncsim_offer_files "$value" ;;
    text) ;;
    *)
        # A switch may have a value, or be followed by anything else.
        if [[ $kind == switch && $typed != --* || $kind == switch && $typed == --*=* ]]; then
            __ncsim_offer_words "$value" on off
        fi
        [[ $typed == -* && $typed != *=* ]] && __ncsim_offer_words "$typed" $options
        ;;
    esac
    return 0
}

complete -o bashdefault -o default -F _ncsim ncsim
"""


def bash_kind(option):
    """Returns what the option takes, and the offered words or endings."""
    if option.is_switch:
        return "switch", []
    if option.type == "RULE=S":
        return "severity", option.values
    if option.values:
        return ("list" if option.is_list else "words"), option.values
    if option.is_folder:
        return "folder", []
    if option.endings():
        return "files", option.endings()
    if option.is_file:
        return "", []  # any file
    return ("text" if option.type else ""), []


def bash_completion(commands, topics):
    names = [command.name for command in commands]
    lines = [BASH_HEAD.replace("@COMMANDS@", " ".join(names + ["help", "--help", "--version"])).rstrip("\n")]
    for command in commands:
        words = [word for option in command.options for word in (option.short, option.name) if word]
        lines += [f"    {command.name})", f"        options='{' '.join(words)}'", "        case $option in"]
        for option in command.options:
            kind, offered = bash_kind(option)
            if kind:
                keys = "|".join(word for word in (option.short, option.name) if word)
                lines += [f"        {keys}) kind={kind} offered='{' '.join(offered)}' ;;"]
        lines += ["        *) kind= offered= ;;", "        esac"]
        endings = next((o.endings() for o in command.positionals if o.endings()), [])
        if endings:
            lines += [f"        [[ -z $kind && $typed != -* ]] && kind=files offered='{' '.join(endings)}'"]
        lines += ["        ;;"]
    lines += ["    help) kind=words offered='" + " ".join(names + [name for name, _ in topics]) + "' ;;"]
    return "\n".join(lines) + "\n" + BASH_TAIL


# Completion for zsh.

def zsh_quoted(text):
    return text.replace("'", "'\\''")


def zsh_text(text):
    text = re.sub(r"([\[\]:\\])", r"\\\1", text)
    return zsh_quoted(text)


def zsh_files(option):
    endings = option.endings()
    patterns = "|".join(endings + [ending.upper() for ending in endings])
    return f'_files -g "*.({patterns})(-.)"' if endings else "_files"


def zsh_action(option):
    if option.type == "RULE=S":
        return "__ncsim_severity"
    if option.is_list:
        return "_sequence compadd - " + " ".join(option.values)
    if option.values:
        return "(" + " ".join(option.values) + ")"
    if option.is_folder:
        return "_files -/"
    return zsh_files(option) if option.is_file else " "


def zsh_option(option):
    repeats = "*" if option.repeats else ""
    text = f"[{zsh_text(option.text)}]"
    equals = value = ""
    if option.is_switch:
        equals, value = "=", "::on or off:(on off)"
    elif option.type:
        equals, value = "=", f":{zsh_text(option.type)}:{zsh_quoted(zsh_action(option))}"
    if option.short:
        exclusive = f"({option.short} {option.name})"
        short = option.short + ("+" if option.type else "")
        return f"'{exclusive}'{{{short},{option.name}{equals}}}'{text}{value}'"
    return f"'{repeats}{option.name}{equals}{text}{value}'"


def zsh_completion(commands, topics):
    names = [f"'{command.name}:{zsh_quoted(command.summary)}'" for command in commands]
    pages = [f"'{name}:{zsh_quoted(text)}'" for name, text in topics]
    rules = next(o.values for c in commands for o in c.options if o.type == "RULE=S")
    lines = ["#compdef ncsim", "# Completion of ncsim for zsh, written by cmake/help_pages.py from the help of ncsim.", "",
             "# Offers rules, then severities after =.", "__ncsim_severity() {", "    if compset -P '*='; then",
             f"        compadd - {' '.join(SEVERITIES)}", "    else",
             f"        compadd -S = - {' '.join(rules)}", "    fi", "}", "", "_ncsim() {", "    local -a commands topics",
             "    topics=(", *(f"        {name}" for name in names + pages), "    )",
             "    commands=(", *(f"        {name}" for name in names), "        'help:Explain a command or a topic'",
             "    )", "    if (( CURRENT == 2 )); then",
             "        if [[ $words[2] == -* ]]; then", "            compadd - --help --version", "        else",
             "            _describe -t commands command commands", "        fi", "        return", "    fi",
             "    local command=$words[2]", "    shift words", "    (( CURRENT-- ))", "    case $command in"]
    for command in commands:
        lines += [f"    {command.name})", "        _arguments \\"]
        entries = [zsh_option(option) for option in command.options]
        if command.positionals:
            option = command.positionals[0]
            files = "_files -/" if option.is_folder and command.name != "merge" else zsh_files(option)
            entries.append(f"'*:{zsh_text(option.text)}:{zsh_quoted(files)}'")
        lines += ["            " + " \\\n            ".join(entries), "        ;;"]
    lines += ["    help) _describe -t topics topic topics ;;", "    esac", "}", "",
              '_ncsim "$@"']
    return "\n".join(lines) + "\n"


# Completion for fish.

FISH_HEAD = r"""# Completion of ncsim for fish, written by cmake/help_pages.py from the help of ncsim.

# True if the command line has no command of ncsim.
function __ncsim_no_command
    test (count (commandline -opc)) -eq 1
end

# True if the command of ncsim is one of the arguments.
function __ncsim_command
    set -l typed (commandline -opc)
    test (count $typed) -gt 1; and contains -- $typed[2] $argv
end

# True if the word before the cursor is one of the arguments.
function __ncsim_after
    set -l typed (commandline -opc)
    contains -- $typed[-1] $argv
end

# Prints the arguments after the last comma of the typed word.
function __ncsim_list
    set -l before (string match -r '^(?:--[^=]*=)?(.*,)?' -- (commandline -ct))[2]
    printf '%s\n' "$before"$argv
end

# Prints rules (the arguments), or a rule with each severity.
function __ncsim_severity
    set -l typed (string replace -r '^--severity=' '' -- (commandline -ct))
    set -l rule (string match -r '^[^=]+(?==)' -- $typed)
    if test -n "$rule"
        printf '%s\n' $rule={note,warning,error}
    else
        printf '%s=\n' $argv
    end
end

# Prints folders and the files with one of the endings; all files if there is none of these.
function __ncsim_files
    set -l typed (string replace -r '^--[^=]*=' '' -- (commandline -ct))
    set -l all (__fish_complete_path $typed)
    set -l endings (string join '|' $argv)
    set -l chosen (string match -ri "^[^\t]*(?:/|\.(?:$endings))(?:\t.*)?\$" -- $all)
    test (count $chosen) -gt 0; and printf '%s\n' $chosen; or printf '%s\n' $all
end

complete -c ncsim -n __ncsim_no_command -f
complete -c ncsim -n __ncsim_no_command -s h -l help -d 'Print this help message and exit'
complete -c ncsim -n __ncsim_no_command -l version -d 'Display program version information and exit'
"""


def fish_quoted(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_option(command, option):
    words = ["complete", "-c", "ncsim", "-n", fish_quoted(f"__ncsim_command {command.name}")]
    if option.short:
        words += ["-s", option.short[1:]]
    words += ["-l", option.name[2:]]
    if option.type == "RULE=S":
        words += ["-x", "-a", fish_quoted("(__ncsim_severity " + " ".join(option.values) + ")")]
    elif option.is_list:
        words += ["-x", "-a", fish_quoted("(__ncsim_list " + " ".join(option.values) + ")")]
    elif option.values and not option.is_switch:
        words += ["-x", "-a", fish_quoted(" ".join(option.values))]
    elif option.is_folder:
        words += ["-x", "-a", fish_quoted("(__fish_complete_directories)")]
    elif option.endings():
        words += ["-x", "-a", fish_quoted("(__ncsim_files " + " ".join(option.endings()) + ")")]
    elif option.is_file:
        words += ["-r", "-F"]
    elif option.type:
        words += ["-x"]
    return " ".join(words + ["-d", fish_quoted(option.text)])


def fish_completion(commands, topics):
    names = [command.name for command in commands] + [name for name, _ in topics]
    lines = [FISH_HEAD.rstrip("\n")]
    for command in commands:
        lines += [f"complete -c ncsim -n __ncsim_no_command -a {command.name} -d {fish_quoted(command.summary)}"]
    lines += ["complete -c ncsim -n __ncsim_no_command -a help -d 'Explain a command or a topic'",
              f"complete -c ncsim -n '__ncsim_command help' -f -a '{' '.join(names)}'"]
    for command in commands:
        lines += [fish_option(command, option) for option in command.options]
        switches = [option.name for option in command.options if option.is_switch]
        if switches:
            after = f"__ncsim_command {command.name}; and __ncsim_after {' '.join(switches)}"
            lines += [f"complete -c ncsim -n {fish_quoted(after)} -a 'on off'"]
        for switch in switches:
            within = f"__ncsim_command {command.name}; and string match -q -- '{switch}=*' (commandline -ct)"
            lines += [f"complete -c ncsim -n {fish_quoted(within)} -l {switch[2:]} -x -a 'on off'"]
    return "\n".join(lines) + "\n"


def write(folder, name, text, compressed=False):
    path = os.path.join(folder, name) + (".gz" if compressed else "")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    data = text.encode("utf-8")
    with open(path, "wb") as file:
        file.write(gzip.compress(data, 9, mtime=0) if compressed else data)


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--gzip"]
    if len(arguments) != 2:
        sys.exit("usage: help_pages.py NCSIM FOLDER [--gzip]")
    program, folder = os.path.abspath(arguments[0]), arguments[1]
    version = output_of(program, "--version").strip()
    top = Command("", output_of(program, "--help"))
    commands = [Command(name, output_of(program, name, "--help")) for name, _ in top.commands]
    find_values(program, commands)
    pages = ["ncsim"] + ["ncsim-" + command.name for command in commands]
    for command in [top] + commands:
        page = "ncsim-" + command.name if command.name else "ncsim"
        write(folder, f"man/man1/{page}.1", man_page(version, command, pages), "--gzip" in sys.argv)
    write(folder, "bash-completion/completions/ncsim", bash_completion(commands, top.topics))
    write(folder, "zsh/vendor-completions/_ncsim", zsh_completion(commands, top.topics))
    write(folder, "fish/vendor_completions.d/ncsim.fish", fish_completion(commands, top.topics))


if __name__ == "__main__":
    main()
