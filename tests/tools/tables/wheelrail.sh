# Sourced by tables.sh.
# In the mirror left is right; what lies across, and moments about the other axes, change their signs.
answers here contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --method strips
answers there contact --load 50kN --speed 30m/s --shift -4mm --yaw -5mrad --method strips
near "turning" "$(v here angular_velocity_rad_per_s)" "$(v there angular_velocity_rad_per_s)" 1e-6
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
# One patch a wheel: what it bears, in the track's axes; what is lost in it; and Hertz's ellipse bears two thirds of its largest pressure.
wheels='split("left right", side, " "); for (k = 1; k <= 2; ++k) {s = side[k]; p = s "_1_"; a = v[p "angle_mrad"] / 1e3; N = v[p "normal_N"]; fx = v[p "fx_N"]; fy = v[p "fy_N"]
  is(s "_x_N", fx, 1e-5); is(s "_y_N", fy * cos(a) - N * sin(a), 1e-4); is(s "_z_N", N * cos(a) + fy * sin(a), 1e-5); is(s "_z_N", 50e3, 1e-4); is(s "_Y_over_Q", (k == 1 ? -1 : 1) * v[s "_y_N"] / v[s "_z_N"], 1e-5); is(p "friction", mu)
  is(p "wear_N", abs(fx * v[p "creepage_x"] + fy * v[p "creepage_y"] + v[p "mz_N_m"] * v[p "spin_1_per_m"]), 1e-4); is(p "area_mm2", 1.5 * N / v[p "p_max_MPa"], ellipse); says(p "p_max_MPa", "error")
  if (!(v[p "stick_share"] >= 0 && v[p "stick_share"] <= 1)) bad("stick"); free(p "x_mm " p "y_mm " p "angle_mrad " p "normal_N " p "p_max_MPa " p "approach_um " p "creepage_x " p "creepage_y " p "spin_1_per_m " p "fx_N " p "fy_N " p "mz_N_m " p "stick_share " p "shear_MPa")
  if (!(v[p "shear_MPa"] <= mu * v[p "p_max_MPa"] * 1.35 && v[p "shear_MPa"] >= mu * v[p "p_max_MPa"] / 3)) bad("shear")}
  t = sin(70 * pi / 180) / cos(70 * pi / 180); is("nadal_limit", (t - mu) / (1 + mu * t), 1e-3)
  says("wheel", "^S1002"); says("rail", "^60E1"); is("cant", 0.025); free("roll_mrad angular_velocity_rad_per_s lowered_mm")'
# The places of the patches move no further with the cells than their errors, at the tread, in the gauge corner and at the flange's root.
for shift in 0.3 1 4 5.5; do
  for cells in 24 72; do
    answers place$cells contact --load 60kN --speed 20m/s --shift ${shift}mm --yaw 3mrad --roll 0.1mrad --slip 0 --cells $cells
  done
  cat place24.json place72.json | awk -F'[:,]' '/"(values|errors|units)"/ {section = $1} /^  "(left|right)_1_[xy]_mm"/ {
    if (section ~ /values/) {if ($1 in value) {off = value[$1] - $2; if (off < 0) off = -off; moved[$1] = off} value[$1] = $2}
    if (section ~ /errors/) {error[$1] += $2; if (!($2 > 0 && $2 < 0.5)) exit bad = 1}}
    END {for (key in moved) {n++; if (moved[key] > error[key]) {print key, moved[key], error[key]; bad = 1}} exit bad || n != 4}' >said || fail "places at $shift mm: $(cat said)"
done
draws hertz contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --method hertz
means hertz "$wheels" mu=0.3 ellipse=1e-6
means here "$wheels" mu=0.3 ellipse=0.02
# The same with the roll and the slip that it found; the left wheel's height is told then, and it is that of the right one.
roll=$(v hertz roll_mrad)
slip=$(awk -v w="$(v hertz angular_velocity_rad_per_s)" 'BEGIN {printf "%.15g", w * 0.46 / 30 - 1}')
answers held contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --method hertz --roll "${roll}mrad" --slip "$slip"
means held "$wheels"' says("lowered_mm", "left wheel [0-9.]+ mm"); split(notes["lowered_mm"], word, " "); if (abs(word[3] - v["lowered_mm"]) > 1e-4) bad("lowered")' mu=0.3 ellipse=1e-6
for key in roll_mrad angular_velocity_rad_per_s left_x_N left_y_N right_x_N right_y_N right_1_p_max_MPa left_1_x_mm; do near "$key held" "$(v held $key)" "$(v hertz $key)" "$(awk -v x="$(v hertz $key)" 'BEGIN {print 1e-4 * (x < 0 ? -x : x)}')"; done
# What is drawn: cells that bear the load about the place told, the frames as told, both rails in the mirror, and wheels that touch them.
draws full contact --load 50kN --speed 30m/s --shift 4mm --yaw 5mrad --mu 0 --cells 16
for drawn in hertz full; do
  for side in left:1:-1 right:2:1; do
    name=${side%%:*} number=$(echo $side | cut -d: -f2) sign=${side##*:}
    awk -F, -v name=$name -v number="$number" -v N="$(v $drawn "${name}_1_normal_N")" -v y="$(v $drawn "${name}_1_y_mm")" -v x="$(v $drawn "${name}_1_x_mm")" -v a="$(v $drawn "${name}_1_angle_mrad")" -v p="$(v $drawn "${name}_1_p_max_MPa")" '
      NR == FNR {if ($1 == name) {row[$4]; if (!n++ || $4 < low) low = $4; if (n == 1 || $4 > high) high = $4} next}
      $1 != number {next} {half = $4} !m++ || $2 < left {left = $2} m == 1 || $2 > right {right = $2} {f = $6 * 4 * $4 * $5 / cos(a / 1e3); sum += f; across += f * $2; along += f * $3; if ($6 > most) most = $6; if ($4 * $5 <= 0) exit 1}
      function near(u, w, within) {if (u - w > within || w - u > within) {print u, "is not", w; bad = 1}} END {near(sum / N, 1, 0.02); near(across / sum, y, 0.5); near(along / sum, x, 0.5); near(most / p, 1, 0.03); near(right - left, (high - low) * cos(a / 1e3), 2e-3); near(m, n, 0)
        gap = high - low; for (u in row) for (w in row) if (u - w > 1e-6 && u - w < gap) gap = u - w; near(half / (gap / 2 * cos(a / 1e3)), 1, 5e-3); exit bad}' $drawn/patches.csv $drawn.drawn/1/d3.csv >said ||
      fail "cells of the $drawn $name patch: $(cat said)"
    awk -F, -v number="$number" -v sign="$sign" -v y="$(v $drawn "${name}_1_y_mm")" -v a="$(v $drawn "${name}_1_angle_mrad")" '
      $1 != number {next} {++n; near($2, y, 1e-3); near($8, a * 0.0572957795, 0.051); near($6 ^ 2 + $7 ^ 2, 1, 1e-4); near($4 * $6 + $5 * $7, 0, 1e-4 * sqrt($4 ^ 2 + $5 ^ 2)); near($4 * sign > 0, 1, 0); near(sqrt($4 ^ 2 + $5 ^ 2) > 2, 1, 0); near(sqrt($4 ^ 2 + $5 ^ 2) < 12, 1, 0)}
      function near(u, w, within) {if (u - w > within || w - u > within) {print u, "is not", w; bad = 1}} END {exit bad || n != 1}' $drawn.drawn/1/d2.csv >said || fail "frame of the $drawn $name patch: $(cat said)"
    awk -F, -v number="$number" 'NR == FNR {if ($1 == number) {y = $2; z = $3} next} function near(at) {return at - y < 0.6 && y - at < 0.6} ($1 == 2 * number || $1 == 2 * number - 1) && near($2) {d = $3 - z; if (d < -0.4 || d > 0.4) exit 1; ++n[$1]}
      END {exit !(n[2 * number] > 0 && n[2 * number - 1] > 0)}' $drawn.drawn/1/d2.csv $drawn.drawn/1/d1.csv || fail "the $drawn $name wheel does not touch its rail"
  done
done
awk -F, '$1 == 1 {y[++m] = $2; z[m] = $3} $1 == 3 {++n; if ($2 + y[n] > 1e-3 || $2 + y[n] < -1e-3 || $3 != z[n]) exit 1} END {exit !(n == 401 && m == 401)}' full.drawn/1/d1.csv || fail "rails in the mirror"
# The cells in the track's axes bear the wheels' forces: areas from the corners, pressure along the normals, and the shear.
for name in here full; do
  vtp=$name/patches.vtp
  [ "$(grep -o '<[A-Za-z]*[ >]' $vtp | grep -vc '<?')" -eq "$(grep -o '</[A-Za-z]*>' $vtp | wc -l)" ] || fail "$vtp: elements that do not end"
  awk '/^<DataArray/ {name = match($0, /Name="[a-zA-Z_]*"/) ? substr($0, RSTART + 6, RLENGTH - 7) : "points"; k = 0; next} /^<\// {name = ""}
    /^<Piece/ {split($0, part, "\""); points = part[2]; polys = part[10]} name == "" {next}
    name == "points" {x[k] = $1; y[k] = $2; z[k++] = $3; ++np} name == "connectivity" {if ($1 != 4 * k || $4 != 4 * k + 3) exit bad = 1; ++k; ++nc} name == "pressure_MPa" {p[k++] = $1}
    name == "shear_MPa" {sx[k] = $1; sy[k] = $2; sz[k++] = $3} name == "side" {side[k++] = $1}
    END {if (bad || np != points || nc != polys || nc < 100) {print np, points, nc, polys; exit 1}
      for (k = 0; k < nc; ++k) {i = 4 * k; ax = x[i + 1] - x[i]; ay = y[i + 1] - y[i]; az = z[i + 1] - z[i]; bx = x[i + 3] - x[i]; by = y[i + 3] - y[i]; bz = z[i + 3] - z[i]
        nx = ay * bz - az * by; ny = az * bx - ax * bz; nz = ax * by - ay * bx; a = sqrt(nx ^ 2 + ny ^ 2 + nz ^ 2); s = nz < 0 ? -1 : 1; d = side[k]
        fx[d] += 1e6 * (p[k] * s * nx + sx[k] * a); fy[d] += 1e6 * (p[k] * s * ny + sy[k] * a); fz[d] += 1e6 * (p[k] * s * nz + sz[k] * a)}
      print fx[-1], fy[-1], fz[-1], fx[1], fy[1], fz[1]}' $vtp >forces || fail "$vtp: $(cat forces)"
  column=0
  for key in left_x_N left_y_N left_z_N right_x_N right_y_N right_z_N; do
    column=$((column + 1))
    near "$key of $vtp" "$(awk -v c=$column '{print $c}' forces)" "$(v $name $key)" 700
  done
done
# Without friction nothing lies across but what the angle turns; stresses below a Hertzian patch are some 0.6 and 0.3 of the largest pressure, at a depth of a part of its width.
means full 'for (key in v) free(key); for (k = 1; k <= 2; ++k) {s = k == 1 ? "left" : "right"; p = s "_1_"; is(p "fx_N", 0); is(p "fy_N", 0); is(p "mz_N_m", 0); is(p "wear_N", 0); is(p "friction", 0); is(p "shear_MPa", 0); is(s "_x_N", 0)
  for (b = 1; b <= 2; ++b) {body = b == 1 ? "rail" : "wheel"; is(p body "_von_mises_MPa", 0.6 * v[p "p_max_MPa"], 0.1); is(p body "_shear_MPa", 0.315 * v[p "p_max_MPa"], 0.08)
    width = (v[p "area_mm2"] / pi) ^ 0.5; is(p body "_von_mises_depth_mm", 0.55 * width, 0.35); is(p body "_shear_depth_mm", 0.55 * width, 0.35)}
  is(p "p_max_MPa", v[p "p_max_MPa"]); if (!(errors[p "p_max_MPa"] > 0)) bad("no error of the pressure")}'
holds "cells of the full theory" full/patches.csv '$c["shear_x_MPa"] != 0 || $c["shear_y_MPa"] != 0 {wrong++} $1 == "right" {y = $c["across_mm"]; if (y > most) most = y; if (y < least) least = y; if ($c["rail_von_mises_MPa"] > mises) mises = $c["rail_von_mises_MPa"]}
  END {near(most > 1 && least < -1, 1, 0); near(mises / m, 1, 0.01)}' m="$(v full right_1_rail_von_mises_MPa)"
# A row of a table is the right wheel of that position; its errors are the distance of the next rows' middle, and of the full theory.
"$railbook" wheelrail table --speed 30m/s --from 2mm --to 4mm --shifts 3 --yaw-from 3mrad --yaw-to 5mrad --yaws 2 --load 50kN --slip -0.001 --mu 0.3 --cells 16 --out rows >said || fail "$(cat said)"
awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i} {print $0}' rows/wheelrail-table.csv | tr -d '"' | sed 's/shift \([0-9.]*\) mm, yaw/shift \1 mm yaw/' >rows.csv
holds "places of a table" rows.csv '{near($c["shift_mm"], 2 + int((rows - 1) / 2), 1e-9); near($c["yaw_mrad"], rows % 2 ? 3 : 5, 1e-9); near($c["load_kN"], 50, 0); near($c["friction"], 0.3, 0); near($c["slip"], -0.001, 0); near(($c["interpolation_error_of_mu_N"] == ""), rows > 4, 0)
  near($c["z_N"] / 50e3, 1, 1e-4); near($c["method_error_of_mu_N"] > 0 && $c["method_error_p_max"] > 0, 1, 0)} END {near(rows, 6, 0)}'
row() { awk -F, -v at="$1" -v key="$2" 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i} NR == at + 1 {printf "%s", $c[key]}' rows.csv; }
answers place contact --load 50kN --speed 30m/s --shift 3mm --yaw 5mrad --method strips --roll "$(row 4 roll_mrad)mrad" --slip -0.001
for pair in lowered_mm:lowered_mm x_N:right_x_N y_N:right_y_N z_N:right_z_N along_mm:right_1_x_mm across_mm:right_1_y_mm angle_mrad:right_1_angle_mrad normal_N:right_1_normal_N p_max_MPa:right_1_p_max_MPa area_mm2:right_1_area_mm2 \
  creepage_x:right_1_creepage_x creepage_y:right_1_creepage_y spin_1_per_m:right_1_spin_1_per_m mz_N_m:right_1_mz_N_m stick_share:right_1_stick_share wear_N:right_1_wear_N; do
  near "${pair%:*} of a row" "$(row 4 "${pair%:*}")" "$(v place "${pair#*:}")" "$(awk -v x="$(v place "${pair#*:}")" 'BEGIN {print 1e-6 + 1e-5 * (x < 0 ? -x : x)}')"
done
# The axle's moment is what the force along makes about it, a radius below.
near "the moment on the axle" "$(row 4 axle_moment_N_m)" "$(awk -v x="$(row 4 x_N)" 'BEGIN {print -0.46 * x}')" 40
answers method contact --load 50kN --speed 30m/s --shift 3mm --yaw 5mrad --cells 16 --roll "$(row 4 roll_mrad)mrad" --slip -0.001
near "the error of the method" "$(row 4 method_error_of_mu_N)" "$(awk -v a="$(row 4 x_N)" -v b="$(row 4 y_N)" -v x="$(v method right_x_N)" -v y="$(v method right_y_N)" 'BEGIN {print sqrt((a - x) ^ 2 + (b - y) ^ 2) / 15e3}')" 2e-4
near "the error of its pressure" "$(row 4 method_error_p_max)" "$(awk -v a="$(row 4 p_max_MPa)" -v b="$(v method right_1_p_max_MPa)" 'BEGIN {d = a / b - 1; print d < 0 ? -d : d}')" 2e-4
"$railbook" wheelrail table --speed 30m/s --from 3.5mm --to 3.5mm --shifts 1 --yaw-from 5mrad --yaw-to 5mrad --load 50kN --slip -0.001 --cells 16 --json >middle.json || fail "the middle"
"$railbook" wheelrail table --speed 30m/s --load 50kN --shifts 2 --method hertz --cells 8 --out usual >said || fail "$(cat said)"
[ "$(sed 's/"[^"]*"//' usual/wheelrail-table.csv | awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} {print $c["shift_mm"], $c["yaw_mrad"], $c["friction"], $c["slip"]}' | xargs)" = "-8 0 0.3 0 8 0 0.3 0" ] || fail "what a table is of where nothing is said"
# Of the rows of one position the first says the errors.
"$railbook" wheelrail table --speed 30m/s --from 3mm --to 3mm --shifts 1 --load 40kN 50kN --mu 0.2 0.3 --method hertz --cells 8 --out several >said || fail "$(cat said)"
sed 's/"[^"]*"//' several/wheelrail-table.csv | awk -F, 'NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i; next} {said = said ($c["method_error_of_mu_N"] == "" ? "-" : "+")} END {exit said != "+---"}' || fail "which rows say errors"
middle() { sed -n "s/.*\"$1\":\\([^,]*\\),.*/\\1/p" middle.json | head -1; }
near "the error of interpolation" "$(row 4 interpolation_error_of_mu_N)" "$(awk -v x="$(middle x_N)" -v y="$(middle y_N)" -v a="$(row 4 x_N)" -v b="$(row 4 y_N)" -v p="$(row 6 x_N)" -v q="$(row 6 y_N)" 'BEGIN {print sqrt((x - (a + p) / 2) ^ 2 + (y - (b + q) / 2) ^ 2) / 15e3}')" 1e-5
# Cones of 1:20 on heads of 300 mm: where they touch is where the head has the cone's slope, and of a wheel of 300 mm the contact is nearly a circle. Where the file's heights begin does not matter.
for zero in 0 5; do
  awk -v zero=$zero 'BEGIN {print "inward_mm,height_mm"; for (u = -60; u <= 40; u += 0.5) printf "%.3f,%.6f\n", u, zero - 0.05 * u - (u > 31 ? (u - 31) ^ 2 / 2 : 0)}' >cone.csv
  awk 'BEGIN {print "inward_mm,height_mm"; for (u = -36; u <= 36; u += 0.5) {a = u < 0 ? -u : u; printf "%.3f,%.6f\n", u, -u * u / 600 - (a > 33 ? 3 * (a - 33) ^ 2 : 0)}}' >head.csv
  answers cone contact --wheel cone.csv --rail head.csv --noise 0mm --cant 0 --gauge 1435mm --gauge-depth 14mm --radius 300mm --load 40kN --speed 20m/s --method hertz --roll 0rad --slip 0 --mu 0.2
  means cone 'u = 34; for (k = 0; k < 60; ++k) u = 33 + ((14 - u ^ 2 / 600) / 3) ^ 0.5; l = 717.5 + u - 15; d = atan2(0.05, 1); e = 207e9 / 2 / 0.91; split("left right", side, " ")
    for (k = 1; k <= 2; ++k) {s = side[k]; p = s "_1_"; sign = k == 1 ? -1 : 1; N = v[p "normal_N"]; is(p "y_mm", sign * l, 1e-4); is(p "angle_mrad", -sign * 1e3 * d, 1e-3); is(p "p_max_MPa", (6 * N * e ^ 2 / 0.3 ^ 2) ^ (1 / 3) / pi / 1e6, 0.01)
      is(p "approach_um", 1e6 * (0.75 * N / e) ^ (2 / 3) / 0.3 ^ (1 / 3), 0.02); is(p "creepage_x", -0.05 * (750 - l) / 300, 0.01); is(s "_z_N", 40e3, 1e-4); is(p "x_mm", 0, 1e-3)}
    for (key in v) free(key)'
done
# What help says of each body is said of that one.
for tool in contact table; do
  "$railbook" wheelrail $tool --help | tr -s ' \n' ' ' | sed 's/ \[\([^]]*\)\]/=\1/g' >help # as CLI11 of Debian 12 writes it
  for of in wheel rail; do
    for what in "young QUANTITY=[0-9.e+]* Pa Young's modulus" "poisson QUANTITY=[0-9.]* Poisson's ratio"; do
      grep -q -e "--$of-$what of the $of " help || fail "$tool --help does not say $what of the $of"
    done
  done
done
