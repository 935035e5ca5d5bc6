# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of the recipes in docs/cluster.md have in common. Each of them is
#     sh ENGINE.sh <ncsim> <source>
# and runs the recipe as it stands there, with fewer shards. Exit code 77: the engine is not here.
set -eu

ncsim=$1
source=$2
PATH=$(dirname "$ncsim"):$PATH
export PATH

skip() {
    echo "skipped: $*"
    exit 77
}

need() {
    for command; do
        command -v "$command" >/dev/null || skip "$command is not installed"
    done
}

# The first block of code below the heading $1.
recipe() {
    awk -v heading="## $1" '
        /^## / { within = $0 == heading; next }
        within && /^    / { print substr($0, 5); some = 1; next }
        within && some && /^$/ { print; next }
        within && some { exit }' "$source/docs/cluster.md"
}

# A folder with programs and a list of them, and what one check says of all of them.
begin() {
    work=$(mktemp -d)
    trap 'end' EXIT
    cd "$work"
    mkdir programs
    for program in $(ls "$source"/tests/verdicts/*.nc | head -n 12); do
        cp "$program" programs/
    done
    ls programs/*.nc >programs.txt
    code=0
    ncsim check --list programs.txt --json expected.json >expected.txt || code=$?
    test "$code" = 1
}

stop_services() { :; }

end() {
    result=$?
    trap - EXIT
    [ $result -eq 0 ] || [ $result -eq 77 ] || tail -n 50 ./*.log ./*.out 2>/dev/null || :
    stop_services
    cd /
    rm -rf "$work"
    exit $result
}

# That has to fail. (sh -e looks away where a line begins with !)
refuses() {
    if "$@" >>refused.log 2>&1; then
        echo "did not fail: $*"
        exit 1
    fi
}

# Does results/ say the same as one check?
expect_one_run() {
    code=0
    ncsim merge results/ --json all.json >all.txt || code=$?
    test "$code" = 1
    cmp expected.txt all.txt
    cmp expected.json all.json
}
