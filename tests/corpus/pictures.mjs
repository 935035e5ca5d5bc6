// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of how many programs does ncsim make a picture: with nothing typed, with the one option that it
// asks for, with --draft?
//
//     node tests/corpus/pictures.mjs build/ncsim FOLDER
//
// FOLDER holds INDEX.tsv and programs/, as tests/corpus/run_corpus reads them. Prints a table, then
// the programs without a picture, and why.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const [ncsim, folder] = process.argv.slice(2).map((path) => resolve(path));
if (!ncsim || !folder) {
  console.error('usage: node pictures.mjs NCSIM FOLDER');
  process.exit(2);
}
const kSeconds = 300;
const ways = { 'nothing typed': [], '`--assume-tool flat:D6`': ['--assume-tool', 'flat:D6'], '`--draft`': ['--draft'] };
const scratch = mkdtempSync(join(tmpdir(), 'ncsim-pictures-'));
const [head, ...lines] = readFileSync(join(folder, 'INDEX.tsv'), 'utf8').trimEnd().split('\n').map((l) => l.split('\t'));
const column = (row, name) => row[head.indexOf(name)];
const counts = Object.fromEntries(Object.keys(ways).map((way) => [way, 0]));
let programs = 0;
const without = [];
for (const row of lines) {
  if (column(row, 'kind') !== 'mill' || !column(row, 'reference_status').startsWith('ok')) continue;
  const program = column(row, 'program');
  const why = {};
  for (const [way, options] of Object.entries(ways)) {
    const png = join(scratch, 'picture.png');
    rmSync(png, { force: true });
    const ran = spawnSync(ncsim, ['run', join(folder, 'programs', program), '-q', '--png', png, ...options],
      { encoding: 'utf8', timeout: 1000 * kSeconds });
    if (existsSync(png)) ++counts[way];
    else why[way] = ran.signal ? `more than ${kSeconds} s` : /error: (.*)/.exec(ran.stderr)?.[1] ?? ran.stderr;
  }
  // Libraries of subroutines, tests of positioning: there is nothing to be seen.
  if (/makes no (cutting )?move/.test(why['`--draft`'] ?? '')) {
    for (const way of Object.keys(ways)) if (!why[way]) --counts[way];
    continue;
  }
  ++programs;
  if (why['`--draft`']) without.push(`${program}: ${why['`--draft`']}`);
}
rmSync(scratch, { recursive: true });
console.log(`| of ${programs} programs that mill | with a picture | |\n| --- | --- | --- |`);
for (const [way, count] of Object.entries(counts))
  console.log(`| ${way} | ${count} | ${Math.round((100 * count) / programs)} % |`);
console.log(without.length ? `\nWithout one:\n${without.join('\n')}` : '');
