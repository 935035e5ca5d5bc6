// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts verdicts and reasons for doubt of `ncsim check` per CAM system.
//
//     node tests/corpus/doubts.mjs NCSIM FOLDER [--seconds N] [--save FILE] [--now FILE]
//         [--before FILE] [--text docs/doubts.md] [-- OPTIONS OF CHECK]
//
// FOLDER holds INDEX.tsv and programs/, as tests/corpus/run_corpus reads them. Prints a table.
//
//     --seconds  limit of each program; a program that takes longer counts nowhere
//     --save     writes the verdict and the doubts of each program, JSON
//     --now      reads such a file instead of running ncsim
//     --before   reads such a file of an older ncsim, adds its counts, and lists changed verdicts
//     --text     writes the table between the lines <!-- doubts --> and <!-- /doubts --> of a document
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const options = { seconds: '60' };
const places = [];
let more = [];
for (let words = process.argv.slice(2); words.length > 0;) {
  const word = words.shift();
  if (word === '--') [more, words] = [words, []];
  else if (word.startsWith('--')) options[word.slice(2)] = words.shift();
  else places.push(resolve(word));
}
const [ncsim, folder] = places;
if (!ncsim || !folder) {
  console.error('usage: node doubts.mjs NCSIM FOLDER [--save FILE] [--now FILE] [--before FILE] [--text FILE] [--seconds N]');
  process.exit(2);
}
const [head, ...rows] = readFileSync(join(folder, 'INDEX.tsv'), 'utf8').trimEnd().split('\n').map((l) => l.split('\t'));
const column = (row, name) => row[head.indexOf(name)];

// The verdict of one program and its open doubts, each as "reason: message".
const check = (program) => new Promise((done) => {
  const child = spawn(ncsim, ['check', join(folder, 'programs', program), '--no-project', '--json', '-', '-j', '1', '--threads', '1', ...more],
    { stdio: ['ignore', 'pipe', 'ignore'], timeout: 1000 * Number(options.seconds) });
  let text = '';
  child.stdout.on('data', (chunk) => { text += chunk; });
  child.on('close', () => {
    try {
      const [seen] = JSON.parse(text).programs;
      const doubts = (seen.doubts ?? []).filter((d) => !d.accepted).map((d) => `${d.reason}:${d.line ?? 0}: ${d.message}`);
      done({ verdict: seen.verdict ?? 'unreadable', doubts });
    } catch {
      done({ verdict: 'too long', doubts: [] });
    }
  });
});

const seen = options.now ? JSON.parse(readFileSync(options.now, 'utf8')) : {};
for (const row of options.now ? [] : rows) seen[column(row, 'program')] = await check(column(row, 'program'));
if (options.save) writeFileSync(options.save, JSON.stringify(seen, null, 1));
const before = options.before ? JSON.parse(readFileSync(options.before, 'utf8')) : undefined;

const reasons = (of) => of.doubts.map((d) => d.split(':')[0]);
const count = (found, programs, what) => programs.reduce((n, p) => n + what(found[p] ?? { verdict: '', doubts: [] }), 0);
// Programs that took too long count nowhere.
const is_verified = (found, program) => !['too long', 'not-verified'].includes(found[program]?.verdict);
const counted = rows.filter((row) => [seen, before ?? seen].every((found) => is_verified(found, column(row, 'program'))));
const systems = {};
for (const row of counted) (systems[column(row, 'cam') || 'unnamed'] ??= []).push(column(row, 'program'));
const cell = (programs, what) => `${before ? `${count(before, programs, what)} → ` : ''}${count(seen, programs, what)}`;
const kShown = ['stock-guess', 'tool-guess', 'units-guess', 'start-unknown', 'offset-guess', 'reading-guess', 'left-out', 'variable-unknown', 'block-delete', 'decimal-point'];
const line = (name, programs) => `| ${[name, programs.length, cell(programs, (v) => v.verdict === 'clean'), cell(programs, (v) => v.verdict === 'failed'),
  ...kShown.map((reason) => cell(programs, (v) => reasons(v).includes(reason)))].join(' | ')} |`;
const table = [`| CAM system | programs | clean | failed | ${kShown.map((r) => `\`${r}\``).join(' | ')} |`,
  `|${' --- |'.repeat(kShown.length + 4)}`,
  ...Object.entries(systems).sort(([a], [b]) => (a < b ? -1 : 1)).map(([name, programs]) => line(name, programs)),
  line('all', counted.map((row) => column(row, 'program')))].join('\n');
console.log(table);
for (const program of before ? Object.keys(seen) : []) {
  const was = before[program]?.verdict;
  if (was !== seen[program].verdict) console.log(`${program}: ${was} → ${seen[program].verdict}`);
}
if (options.text) {
  const text = readFileSync(options.text, 'utf8');
  const between = /(<!-- doubts -->\n)[^]*(<!-- \/doubts -->)/;
  writeFileSync(options.text, text.replace(between, (_, from, to) => `${from}${table}\n${to}`));
}
