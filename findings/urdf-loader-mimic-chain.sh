#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  npm, urdf-loader 0.13.1 with three 0.187.0 and jsdom 29.1.1.
# Input:    joint m mimics joint a (multiplier 2, offset 0.5; own limits -0.2 .. 0.2); joint n mimics m (multiplier 3).
# Expected: After loading, a = 0 and m = 0.5, clamped to 0.2. After a = 0.1: m = 0.7, clamped to 0.2,
#           and n = 3 * m = 0.6: the follower of m follows the position of m.
# Seen:     After loading, m = 0: the offset is not applied until a joint is set. After a = 0.1: m = 0.2 and n = 2.1:
#           n follows the value of m before the clamp.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

npm install --silent --ignore-scripts --no-audit --no-fund --prefix "$work" \
  urdf-loader@0.13.1 three@0.187.0 jsdom@29.1.1 >/dev/null

cat >check.mjs <<'JS'
import { JSDOM } from 'jsdom';
const { window } = new JSDOM('');
for (const name of ['DOMParser', 'XMLSerializer', 'Document', 'Element', 'document']) globalThis[name] = window[name];
const { default: URDFLoader } = await import('urdf-loader');
const joint = (name, limit, mimic) => `<link name="link_${name}"/><joint name="${name}" type="revolute">
  <parent link="base"/><child link="link_${name}"/><axis xyz="0 0 1"/>
  <limit lower="${-limit}" upper="${limit}" effort="1" velocity="1"/>${mimic}</joint>`;
const robot = new URDFLoader().parse(`<robot name="r"><link name="base"/>
  ${joint('a', 1, '')}
  ${joint('m', 0.2, '<mimic joint="a" multiplier="2" offset="0.5"/>')}
  ${joint('n', 3, '<mimic joint="m" multiplier="3" offset="0"/>')}</robot>`);
const { a, m, n } = robot.joints;
const show = (when) => console.log(`${when}: ${[a, m, n].map((j) => j.angle.toFixed(3)).join(' ')}`);
show('after loading');
robot.setJointValue('a', 0.1);
show('after a = 0.1');
JS
node check.mjs | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
after loading: 0.000 0.000 0.000
after a = 0.1: 0.100 0.200 2.100
EXPECTED
