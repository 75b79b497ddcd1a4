#!/bin/sh
# Sourced by hunting.sh and hunting-cycles.sh: profiles of the examples, and cones.
# shellcheck disable=SC2034
cp "$cases"/../../../tools/examples/hunting/*.csv .
# Cones of 1:20 on heads of 300 mm, by hand: they touch where the head has the cone's slope, 15 mm inside its top, which the gauge puts in place 14 mm below; R and the
# roll by Wickens's formulas for a coned wheelset, with half the distance l of the contacts.
awk 'BEGIN {print "inward_mm,height_mm"; for (u = -60; u <= 40; u += 0.5) printf "%.3f,%.6f\n", u, -0.05 * u - (u > 31 ? (u - 31) ^ 2 / 2 : 0)}' >cone.csv
awk 'BEGIN {print "inward_mm,height_mm"; for (u = -36; u <= 36; u += 0.5) {a = u < 0 ? -u : u; printf "%.3f,%.6f\n", u, -u * u / 600 - (a > 33 ? 3 * (a - 33) ^ 2 : 0)}}' >head.csv
cones="--wheel cone.csv --rail head.csv --noise 0mm --cant 0 --gauge 1435mm --gauge-depth 14mm --radius 450mm --half-spacing 752mm --end 1.3mm --step 0.05mm"
