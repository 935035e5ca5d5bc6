# SPDX-License-Identifier: GPL-3.0-or-later
#
# GNU parallel, on this machine.
. "$(dirname "$0")/common.sh"

need parallel
begin
HOME=$work # it keeps a folder there
export HOME
recipe "GNU parallel" | sed 's/^N=200$/N=4/' >shards.sh
grep -q '^N=4$' shards.sh
sh -e shards.sh 2>parallel.log
expect_one_run
# Shards that failed are done again, and only they: here the list was not there at first.
rm -r results jobs.log
mv programs.txt later.txt
refuses sh -e shards.sh
mv later.txt programs.txt
sh -e shards.sh 2>>parallel.log
expect_one_run
test "$(wc -l <jobs.log)" -ge 9
