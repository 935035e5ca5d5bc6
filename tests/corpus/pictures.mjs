// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of how many programs does ncsim make a picture: with nothing typed, with the one option that it
// asks for, with --draft?
//
//     node tests/corpus/pictures.mjs build/ncsim FOLDER [docs/dialect.md]
//
// FOLDER holds INDEX.tsv and programs/, as tests/corpus/run_corpus reads them. Prints a table, then
// the programs without a picture, and why. Writes the table into the text that is named, between
// the lines <!-- pictures --> and <!-- /pictures -->.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const [ncsim, folder, text] = process.argv.slice(2).map((path) => resolve(path));
if (!ncsim || !folder) {
  console.error('usage: node pictures.mjs NCSIM FOLDER [TEXT]');
  process.exit(2);
}
const kSeconds = 300;
const kAtOnce = 2;
const kNothing = 'nothing typed';
const kTool = '`--assume-tool flat:D6`';
const kDraft = '`--draft`';
const ways = { [kNothing]: [], [kTool]: ['--assume-tool', 'flat:D6'], [kDraft]: ['--draft'] };
const scratch = mkdtempSync(join(tmpdir(), 'ncsim-pictures-'));
const [head, ...rows] = readFileSync(join(folder, 'INDEX.tsv'), 'utf8').trimEnd().split('\n').map((l) => l.split('\t'));
const column = (row, name) => row[head.indexOf(name)];

// Why there is no picture; nothing where there is one.
const run = (program, png, options) => new Promise((done) => {
  rmSync(png, { force: true });
  const child = spawn(ncsim, ['run', join(folder, 'programs', program), '-q', '--png', png, ...options],
    { stdio: ['ignore', 'ignore', 'pipe'], timeout: 1000 * kSeconds });
  let said = '';
  child.stderr.on('data', (chunk) => { said = (said + chunk).slice(0, 100_000); });
  child.on('close', (_, signal) => {
    if (existsSync(png)) return done(undefined);
    done(signal ? `more than ${kSeconds} s` : /error: (.*)/.exec(said)?.[1] ?? said);
  });
});

const look = async (program, number) => {
  const png = join(scratch, `${number}.png`);
  const why = { [kNothing]: await run(program, png, ways[kNothing]) };
  // Where all tools are told, an option for those that are not changes nothing.
  why[kTool] = why[kNothing] && (await run(program, png, ways[kTool]));
  why[kDraft] = await run(program, png, ways[kDraft]);
  rmSync(png, { force: true });
  return why;
};

const milling = rows
  .filter((row) => column(row, 'kind') === 'mill' && column(row, 'reference_status').startsWith('ok'))
  .map((row) => column(row, 'program'));
const found = [];
let next = 0;
const work = async () => {
  while (next < milling.length) {
    const number = next++;
    found[number] = await look(milling[number], number);
  }
};
await Promise.all(Array.from({ length: kAtOnce }, work));
rmSync(scratch, { recursive: true });

// Libraries of subroutines, tests of positioning: there is nothing to be seen.
const seen = milling.map((program, i) => ({ program, why: found[i] }))
  .filter(({ why }) => !/makes no (cutting )?move/.test(why[kNothing] ?? ''));
const table = [`| of ${seen.length} programs that mill | with a picture | |`, '| --- | --- | --- |'];
for (const way of Object.keys(ways)) {
  const count = seen.filter(({ why }) => !why[way]).length;
  table.push(`| ${way} | ${count} | ${Math.round((100 * count) / seen.length)} % |`);
}
console.log(table.join('\n'));
const without = seen.filter(({ why }) => why[kDraft]);
console.log(without.length ? `\nWithout one:\n${without.map(({ program, why }) => `${program}: ${why[kDraft]}`).join('\n')}` : '');
if (text) {
  const old = readFileSync(text, 'utf8');
  const marked = /(<!-- pictures -->\n)[^]*?(\n<!-- \/pictures -->)/;
  if (!marked.test(old)) throw new Error(`${text}: no lines <!-- pictures --> and <!-- /pictures -->`);
  writeFileSync(text, old.replace(marked, `$1${table.join('\n')}$2`));
}
