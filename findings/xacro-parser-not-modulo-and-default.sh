#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Packages: npm, xacro-parser 0.3.11 (reader of xacro, the macros of robot descriptions) and jsdom 26.1.0 for its XML. Python 3.11
#           evaluates the same expressions.
# Input:    expressions with the properties x = 2, y = 0.5 and side = left; a property with two defaults; a condition that leaves
#           out a link. Source: documentation of xacro in ROS (expressions are those of Python; a default is used only if the
#           property is not defined); readme of the package ("may not support all expression types").
# Expected: The value that Python returns, or an error. A property that is defined keeps its value against a second default.
# Seen:     Without an error, "not x == 3" is false, because not binds to x, so the link is missing; -7 % 3 is -1 instead of 2,
#           log(8, 2) is 2.08 instead of 3, and "'1' + '2'" is 3 instead of 12. The second default replaces the value. sqrt, abs,
#           max, floor, ** and x >= 2 are errors.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" xacro-parser@0.3.11 jsdom@26.1.0 >/dev/null

cat >check.mjs <<'JS'
import { execFileSync } from 'node:child_process';
import { JSDOM } from 'jsdom';
import { XacroParser } from 'xacro-parser';

globalThis.DOMParser = new JSDOM().window.DOMParser;
const properties =
  '<xacro:property name="x" value="2"/><xacro:property name="y" value="0.5"/><xacro:property name="side" value="left"/>';
const parse = async (body) => {
  const text = `<?xml version="1.0"?><robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">${properties}${body}</robot>`;
  return (await new XacroParser().parse(text)).documentElement;
};
const escape = (text) => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
const python = (expression) =>
  execFileSync('python3', ['-c', `from math import *\nx = 2\ny = 0.5\nside = "left"\nprint(${expression})`], { encoding: 'utf8' }).trim();
for (const expression of [
  'x * y', '-pi / 2', '1 + x == 3', 'x == 3 or y == 0.5', 'not x == 3', 'not (x == 3)', "not side == 'right'", '7 % 3', '-7 % 3', '7 % -3',
  'log(8)', 'log(8, 2)', "'1' + '2'", 'pow(x, 3)', 'x ** 3', 'sqrt(x)', 'abs(-x)', 'max(x, y)', 'floor(-y)', 'x > 1', 'x >= 2']) {
  let value;
  try {
    value = (await parse(`<link name="\${${escape(expression)}}"/>`)).firstElementChild.getAttribute('name');
  } catch (error) {
    value = 'an error';
  }
  console.log(`${expression}: ${value}, in Python ${python(expression)}`);
}
const links = async (name, body) => {
  const root = await parse(body);
  console.log(`${name}: ${[...root.children].map((child) => child.getAttribute('name')).join(' ') || 'no link'}`);
};
await links('link if not right', '<xacro:if value="${not side == \'right\'}"><link name="arm"/></xacro:if>');
await links('two defaults',
  '<xacro:property name="n" default="4"/><link name="${n}"/><xacro:property name="n" default="5"/><link name="${n}"/>');
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
x * y: 1, in Python 1.0
-pi / 2: -1.5707963267948966, in Python -1.5707963267948966
1 + x == 3: true, in Python True
x == 3 or y == 0.5: true, in Python True
not x == 3: false, in Python True
not (x == 3): true, in Python True
not side == 'right': false, in Python True
7 % 3: 1, in Python 1
-7 % 3: -1, in Python 2
7 % -3: 1, in Python -2
log(8): 2.0794415416798357, in Python 2.0794415416798357
log(8, 2): 2.0794415416798357, in Python 3.0
'1' + '2': 3, in Python 12
pow(x, 3): 8, in Python 8.0
x ** 3: an error, in Python 8
sqrt(x): an error, in Python 1.4142135623730951
abs(-x): an error, in Python 2
max(x, y): an error, in Python 2
floor(-y): an error, in Python -1
x > 1: true, in Python True
x >= 2: an error, in Python True
link if not right: no link
two defaults: 4 5
EXPECTED
