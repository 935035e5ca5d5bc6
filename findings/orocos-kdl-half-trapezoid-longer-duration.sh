#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Package:  Debian 12, liborocos-kdl-dev 1.5.1-2+b4 (Orocos KDL, kinematics and dynamics of robots). The script calls g++ and
#           needs the headers of Eigen 3 (libeigen3-dev).
# Input:    half trapezoidal velocity profiles with the maximum velocity 2 and the maximum acceleration 4, over the distances
#           1, 0.25 and 0.1, with the minimum duration and with longer ones. Source: velocityprofile_traphalf.hpp ("maximal
#           acceleration of the motion profile", "If the distance is too short between pos1 and pos2, only the acceleration
#           phase is set and the max velocity is not reached", SetProfileDuration: "Can be used to prolong the profile",
#           "the acceleration is lowered").
# Expected: A longer duration needs at most the acceleration of the minimum duration, and no value exceeds its maximum.
# Seen:     Over the distance 0.1, the minimum duration 0.2236 has the acceleration 4 and ends at the velocity 0.89. With the
#           duration 0.3 the acceleration is 20, five times the maximum, and the velocity 2: the axis waits and then starts
#           with a jerk. The profile that ends at rest brakes with -20 likewise. Over the distance 1, the acceleration is lowered.

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
fetch liborocos-kdl-dev=1.5.1-2+b4 liborocos-kdl1.5=1.5.1-2+b4
libraries=$work/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH=$libraries

cat >check.cpp <<'CPP'
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>

#include <kdl/velocityprofile_traphalf.hpp>

static void print(const char* name, const KDL::VelocityProfile& profile)
{
    const double duration = profile.Duration();
    double velocity = 0, acceleration = 0;
    for (int i = 0; i <= 1000; ++i) {
        velocity = std::max(velocity, std::fabs(profile.Vel(duration * i / 1000)));
        acceleration = std::max(acceleration, std::fabs(profile.Acc(duration * i / 1000)));
    }
    std::printf("  %s duration %.4f: position %.2f to %.2f, greatest velocity %.2f, acceleration %.2f\n", name, duration,
                profile.Pos(0), profile.Pos(duration), velocity, acceleration);
}

int main()
{
    for (const bool starting : {true, false})
        for (const double distance : {1.0, 0.25, 0.1}) {
            std::printf("%s rest, distance %g\n", starting ? "from" : "to", distance);
            KDL::VelocityProfile_TrapHalf profile(2, 4, starting);
            profile.SetProfile(0, distance);
            print("minimum", profile);
            const double minimum = profile.Duration();
            for (const double longer : {0.3, 0.6, 1.0}) {
                if (longer <= minimum)
                    continue;
                profile.SetProfileDuration(0, distance, longer);
                print("longer", profile);
            }
        }
}
CPP
g++ -std=c++17 -I root/usr/include -I /usr/include/eigen3 check.cpp -L "$libraries" -lorocos-kdl -o check 2>log || { cat log >&2; exit 2; }
./check | tee seen
diff seen - <<'EXPECTED' || { echo 'behaviour changed' >&2; exit 1; }
from rest, distance 1
  minimum duration 0.7500: position 0.00 to 1.00, greatest velocity 2.00, acceleration 4.00
  longer duration 1.0000: position 0.00 to 1.00, greatest velocity 2.00, acceleration 2.00
from rest, distance 0.25
  minimum duration 0.3536: position 0.00 to 0.25, greatest velocity 1.41, acceleration 4.00
  longer duration 0.6000: position 0.00 to 0.25, greatest velocity 2.00, acceleration 8.00
  longer duration 1.0000: position 0.00 to 0.25, greatest velocity 2.00, acceleration 8.00
from rest, distance 0.1
  minimum duration 0.2236: position 0.00 to 0.10, greatest velocity 0.89, acceleration 4.00
  longer duration 0.3000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
  longer duration 0.6000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
  longer duration 1.0000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
to rest, distance 1
  minimum duration 0.7500: position 0.00 to 1.00, greatest velocity 2.00, acceleration 4.00
  longer duration 1.0000: position 0.00 to 1.00, greatest velocity 2.00, acceleration 2.00
to rest, distance 0.25
  minimum duration 0.3536: position 0.00 to 0.25, greatest velocity 1.41, acceleration 4.00
  longer duration 0.6000: position 0.00 to 0.25, greatest velocity 2.00, acceleration 8.00
  longer duration 1.0000: position 0.00 to 0.25, greatest velocity 2.00, acceleration 8.00
to rest, distance 0.1
  minimum duration 0.2236: position 0.00 to 0.10, greatest velocity 0.89, acceleration 4.00
  longer duration 0.3000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
  longer duration 0.6000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
  longer duration 1.0000: position 0.00 to 0.10, greatest velocity 2.00, acceleration 20.00
EXPECTED
