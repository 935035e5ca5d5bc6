#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, libconvert-units-perl 1:0.43-11 (Convert::Units::Length, ::Temperature; unit conversion in Perl).
# Input:    lengths and temperatures with a number and a unit. Source: documentation of Convert::Units::Base ("a collection of
#           modules for parsing strings with unit measurements (such as "12pt" or "3 meters") and converting them"; "It does not
#           yet handle fractions such as "1/2 in". It should handle decimals such as "0.5 in""); the inch is 25.4 mm
#           exactly (international yard, 1959); 0 degrees Celsius are 273.15 K (SI brochure).
# Expected: 1 inch is 25.4 mm, 100 inches are 2540 mm. -2 inches are -50.8 mm, .5 inch is 12.7 mm, +5 mm is 5 mm. A number that
#           is not understood is an error, as an unknown unit is. 20 degrees Celsius are 293.15 K.
# Seen:     A metre has 39.37 inches, so an inch is 25.40005 mm, and 100 inches are 2540.005 mm. In parse, 0.5 inch is 38.1 mm,
#           -2 inches, .5 inch and 1/4 inch are 25.4 mm, and "1 foot -1 inch" is 13 inches. convert has the right sign, but
#           returns 0 without a message for +5 mm, 1.5e3 mm, 1,000 mm and half an inch. 20 degrees Celsius are 293 K.

set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Extracts pinned Debian 12 packages into ./root, without installation.
fetch() {
  mkdir -p deb root
  (cd deb && apt-get download "$@" >/dev/null 2>log) || { cat deb/log >&2; exit 2; }
  for package in deb/*.deb; do dpkg -x "$package" root; done
}
fetch libconvert-units-perl=1:0.43-11

cat >check.pl <<'PL'
use strict;
use lib 'root/usr/share/perl5';
use Convert::Units::Length;
use Convert::Units::Temperature;

sub show {
    my ($name, $function, $from, $to) = @_;
    my $value = eval { $function->($from, $to) };
    printf "%s(\"%s\", \"%s\"): %s\n", $name, $from, $to, defined $value ? sprintf('%.5f', $value) : 'error';
}
for ('1 inch', '100 inch', '0.5 inch', '.5 inch', '-2 inch', '+5 mm', '1.5e3 mm', '1,000 mm', 'half an inch', '1 furlong') {
    show('convert', \&Convert::Units::Length::convert, $_, 'mm');
}
for ('1 inch', '0.5 inch', '.5 inch', '-2 inches', '1/4 inch', '1 furlong') {
    show('parse', \&Convert::Units::Length::parse, $_, 'mm');
}
show('parse', \&Convert::Units::Length::parse, $_, 'inch') for '5 feet, 3 inches', '1 foot -1 inch';
show('convert', \&Convert::Units::Temperature::convert, '20 c', $_) for 'f', 'k';
PL
perl check.pl 2>log | tee seen
diff seen - <<'EXPECTED' || { cat log >&2; echo 'behaviour changed' >&2; exit 1; }
convert("1 inch", "mm"): 25.40005
convert("100 inch", "mm"): 2540.00508
convert("0.5 inch", "mm"): 12.70003
convert(".5 inch", "mm"): 12.70003
convert("-2 inch", "mm"): -50.80010
convert("+5 mm", "mm"): 0.00000
convert("1.5e3 mm", "mm"): 0.00000
convert("1,000 mm", "mm"): 0.00000
convert("half an inch", "mm"): 0.00000
convert("1 furlong", "mm"): error
parse("1 inch", "mm"): 25.40005
parse("0.5 inch", "mm"): 38.10008
parse(".5 inch", "mm"): 25.40005
parse("-2 inches", "mm"): 25.40005
parse("1/4 inch", "mm"): 25.40005
parse("1 furlong", "mm"): error
parse("5 feet, 3 inches", "inch"): 63.00000
parse("1 foot -1 inch", "inch"): 13.00000
convert("20 c", "f"): 68.00000
convert("20 c", "k"): 293.00000
EXPECTED
