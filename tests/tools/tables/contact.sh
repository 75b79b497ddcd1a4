# Sourced by tables.sh.
# Pressures add up to the load.
answers press solve --body-1-radius-along 460mm --body-2-radius-across 300mm --load 80kN --cells-x 63 --cells-y 63
holds "pressures" press/pressure.csv '
  NF == 3 {if ($1 > x && rows > 1) dx = $1 - x; if ($2 > y && rows > 1) dy = $2 - y; x = $1; y = $2; sum += $3; if ($3 > most) most = $3}
  END {near(sum * abs(dx * dy) / 80e3, 1, 1e-3); near(most / p, 1, 2e-3)}' p="$(v press p_max_MPa)"
answers inches solve --body-1-radius-along 460mm --body-2-radius-across 300mm --load 80kN --cells-x 63 --cells-y 63 --system inch
for unit in approach_mil:approach_um:25.4 force_lbf:force_kN:0.0044482216 p_max_psi:p_max_MPa:0.0068947573 area_in2:area_mm2:645.16 x_max_in:x_max_mm:25.4; do
  near "$unit" "$(awk -v i="$(v inches "${unit%%:*}")" -v u="${unit##*:}" -v m="$(v press "$(echo $unit | cut -d: -f2)")" 'BEGIN {print i * u / m}')" 1 1e-7
done
# Bodies turned to one another: the ends are those of Hertz's ellipse in its own axes.
answers turned solve --body-1-radius-along 200mm --body-2-radius-across 500mm --body-2-radius-along 400mm --angle 30deg --load 80kN
eval "$(awk -v a="$(v turned hertz_a_mm)" -v b="$(v turned hertz_b_mm)" -v g="$(v turned grid_angle_deg)" 'BEGIN {
  c = cos(g / 57.2957795); s = sin(g / 57.2957795)
  print "x=" sqrt((a * c) ^ 2 + (b * s) ^ 2), "y=" sqrt((a * s) ^ 2 + (b * c) ^ 2)}')"
for end in x_min:-"$x" x_max:"$x" y_min:-"$y" y_max:"$y"; do
  near "${end%%:*} of turned bodies" "$(v turned "${end%%:*}_mm")" "${end#*:}" 0.06
done
# A profile whose lowest place is not at its zero: the contact is about that place, and else Hertz's.
awk 'BEGIN {print "x_mm,depth_mm"; for (i = -200; i <= 200; ++i) {x = i / 10; printf "%.1f,%.9f\n", x, (x - 7) ^ 2 / 600}}' >aside.csv
answers aside solve --body-2-profile aside.csv --body-1-radius-along 460mm --load 80kN
for place in x_touch x_p_max; do near "$place of a profile" "$(v aside ${place}_mm)" 7 0.01; done
for end in x_min x_max y_min y_max; do
  near "$end of a profile" "$(v aside ${end}_mm)" "$(awk -v e="$(v press ${end}_mm)" -v at=${end%_*} 'BEGIN {print e + (at == "x" ? 7 : 0)}')" 0.2
done
near "pressure of a profile" "$(v aside p_max_MPa)" "$(v press p_max_MPa)" 3
# One that ends, on either side, within the contact is refused.
for end in '$1 < 10' '$1 > 4'; do
  awk -F, "NR == 1 || $end" aside.csv >cut.csv
  "$railbook" contact solve --body-2-profile cut.csv --body-1-radius-along 460mm --load 80kN >said 2>&1
  [ $? = 2 ] && grep -q "profile" said || fail "a profile that is cut off: $(cat said)"
done
