# Sourced by tables.sh.
# The table goes over the range; where the greatest growth passes zero is the critical speed, with its frequency.
answers speed speed --lowest 20m/s --highest 80m/s
holds "growth over speed" speed/speed.csv '
  rows == 1 {near($1, 20, 1e-6)} rows > 1 {near($1 - last, 0.25, 1e-5)} $2 < $4 {wrong++}
  rows > 1 && $2 > 0 && before <= 0 {near(last - before * ($1 - last) / ($2 - before), hopf, 0.01); ++roots; near($3, omega, 0.1)}
  {last = $1; before = $2} END {near(last, 80, 1e-6); near(roots, 1, 0)}' \
  hopf="$(v speed hopf_1_m_per_s)" omega="$(v speed hopf_1_rad_per_s)"
# Centred, both sides are alike; displaced, each wheel touches its rail where it has moved to, and the right radius grows no more than the left.
answers pair geometry --pair cn
holds "contacts" pair/contacts.csv '
  rows == 1 {near($2, $4, 1e-6); near($3, $5, 1e-6); near($2, $3, 1e-6)}
  $1 < 5 {near($2 + $1, $3, 0.2); near($4 - $1, $5, 0.2)} !($3 > 700 && $5 > 700) {wrong++}'
holds "rolling radii" pair/wheelset.csv '{near($4, $2 - $3, 1e-5); near($c["D_rad"], ($5 - $6) / 2, 1e-5)}'
# The branch begins at the critical speed and has the extent that is told; what limits the creep is below it for small motions.
answers cycle cycle --pair cn --largest-amplitude 3mm --wheel-rail-friction 0.3
extent=$(sed -n 's/^  "branch_extent": "\([0-9.]*\) to \([0-9.]*\) m.s, \([0-9.]*\) to \([0-9.]*\) mm",\?$/a=\1 b=\2 c1=\3 d=\4/p' cycle.json)
# shellcheck disable=SC2086
holds "a branch of cycles" cycle/cycle.csv '
  rows == 1 {slow = fast = $2; small = large = $3; near($2, hopf, 1); near($3, 1, 0.05)}
  $2 < slow {slow = $2} $2 > fast {fast = $2} $3 < small {small = $3} $3 > large {large = $3}
  {near($c["L_over_V"] > 0 && $c["creep_over_friction"] > 0 && $c["creep_over_friction"] < 1, 1, 0)
   near(($c["stable_mm"] == "nan") + ($c["unstable_mm"] == "nan"), 1, 0); near($c["front_leading_mm"], $3, 1e-6)}
  END {near(slow, a, 1e-4); near(fast, b, 1e-4); near(small, c1, 1e-4); near(large, d, 1e-4); near(rows, n, 0)}' \
  $extent hopf="$(v cycle hopf_m_per_s)" n="$(v cycle branch_points)"
