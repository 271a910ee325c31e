#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes the mesh of the two-region example, has CalculiX pull it, and compares the mean stress in each material with the
# closed form, to 1 %. Arguments: the program, the folder of examples. Ends with 77 where there is no CalculiX.
set -eu
program=$1 examples=$2
command -v ccx >/dev/null || {
  echo "skipped: ccx (package calculix-ccx) is not installed"
  exit 77
}
"$program" run "$examples/two_regions_for_calculix.ars"
cp "$examples/two_regions_in_tension.inp" .
rm -f two_regions_in_tension.dat
ccx two_regions_in_tension >ccx.log 2>&1 || {
  tail -n 20 ccx.log
  exit 1
}
# The .dat file lists, per set, element, integration point and six stresses; then the total reaction.
awk '
  /stresses.*STEEL/ { set = "steel" }
  /stresses.*RUBBER/ { set = "rubber" }
  /total force/ { set = "force" }
  NF == 8 && (set == "steel" || set == "rubber") { sum[set] += $5; n[set] += 1 }
  NF == 3 && set == "force" { force = $3 }
  END {
    steel = n["steel"] ? sum["steel"] / n["steel"] : 0
    rubber = n["rubber"] ? sum["rubber"] / n["rubber"] : 0
    printf "mean stress: steel %.6g (210), rubber %.6g (2), force %.6g (21200)\n", steel, rubber, force
    if (steel < 207.9 || steel > 212.1 || rubber < 1.98 || rubber > 2.02 || force < 20988 || force > 21412) exit 1
  }' two_regions_in_tension.dat
