# SPDX-License-Identifier: GPL-3.0-or-later
#
# Snakemake, on this machine.
. "$(dirname "$0")/common.sh"

need snakemake
begin
HOME=$work
export HOME
recipe Snakemake | sed 's/^N = 200$/N = 4/' >Snakefile
grep -q '^N = 4$' Snakefile
snakemake --cores 2 >snakemake.log 2>&1
expect_one_run
cmp expected.json verdict.json
# What is lost is made again, and what follows from it.
rm results/shard-0002-of-0004.ndjson verdict.json
snakemake --cores 2 >>snakemake.log 2>&1
expect_one_run
cmp expected.json verdict.json
