# Sourced by tables.sh.
# In the mirror left is right; what lies across, and moments about the other axes, change their signs.
answers here contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --method strips
answers there contact --load 50kN --speed 30m/s --shift -4mm --yaw -5mrad --method strips
near "turning" "$(v here turning_rad_per_s)" "$(v there turning_rad_per_s)" 1e-6
near "roll" "$(v here roll_mrad)" "$(awk -v r="$(v there roll_mrad)" 'BEGIN {print -r}')" 1e-5
for key in x_N z_N y_N 1_x_mm 1_y_mm 1_angle_mrad 1_normal_N 1_p_max_MPa 1_creepage_x 1_creepage_y 1_spin_1_per_m 1_fx_N 1_fy_N 1_mz_N_m 1_wear_N; do
  for side in left:right right:left; do
    awk -v key="$key" -v a="$(v here "${side%:*}_$key")" -v b="$(v there "${side#*:}_$key")" 'BEGIN {
      if (key ~ /y_|_y|angle|spin|mz/) b = -b
      d = a < b ? b - a : a - b; size = a < 0 ? -a : a; exit !(a != "" && d <= 1e-4 * size + 1e-4)}' || fail "$side $key: $(v here "${side%:*}_$key"), $(v there "${side#*:}_$key")"
  done
done
near "load" "$(v here left_z_N)" 50e3 50
# Left is on the left; the cells' largest pressure is the answer's, and their shear within FASTSIM's parabola, 4/3 as high.
awk -v l="$(v here left_1_y_mm)" -v r="$(v here right_1_y_mm)" 'BEGIN {exit !(l < -700 && r > 700)}' || fail "left and right"
holds "cells of the patches" here/patches.csv '
  $c["pressure_MPa"] > most[$1] {most[$1] = $c["pressure_MPa"]} {t = sqrt($c["shear_x_MPa"] ^ 2 + $c["shear_y_MPa"] ^ 2)}
  t > 0.3 * 4 / 3 * $c["pressure_MPa"] * 1.01 + 1 {print t " on " $c["pressure_MPa"]; wrong++}
  END {near(most["left"] / l, 1, 0.01); near(most["right"] / r, 1, 0.01)}' l="$(v here left_1_p_max_MPa)" r="$(v here right_1_p_max_MPa)"
