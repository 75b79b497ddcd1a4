# Sourced by tables.sh.
# From 5 ms before the joint; the peaks are those of the answer, and the joint is the lowest place of the surface.
answers joint joint --speed 60mph --dip 0.5in --duration 40ms
holds "force over a joint" joint/joint.csv '
  rows == 1 {near($1, -5, 1e-6); least = $2} {last = $1} $1 <= 2.5 && $2 > second {second = $2}
  $1 >= 4 && $2 > late {late = $2} $2 < least {least = $2} $6 > deepest {deepest = $6; at = $1}
  END {near(last, 40, 1e-6); near(second, s, 0.1); near(late, l, 0.1); near(least, w, 0.1); near(deepest, 12.7, 0.01); near(at, 0, 0.03)}' \
  s="$(v joint second_kN)" l="$(v joint late_kN)" w="$(v joint least_kN)"
# What the bed bears is the wheel load; the rail is symmetrical about the wheel, and deepest under it.
answers bend stiffness --wheel-load 100kN
holds "deflected rail" bend/stiffness.csv '
  {x[rows] = $1; y[rows] = $2; q[rows] = $3; if ($2 > deepest) {deepest = $2; at = $1}}
  END {for (i = 1; i <= rows; ++i) near(y[i], y[rows + 1 - i], 1e-5)
    for (i = 2; i <= rows; ++i) sum += (x[i] - x[i - 1]) * (q[i] + q[i - 1]) / 2
    near(sum, 100, 0.3); near(at, 0, 1e-6); near(deepest, d, 1e-4)}' d="$(v bend deflection_mm_at_0.000)"
# A track all of whose parts are given: the chain of eqs (4) to (7), the beam of (1) to (3), the two masses of (15) to (19) by hand;
# two wheels and a hinge by reciprocity: what a kink of the rail deflects at a wheel is the moment that a wheel there makes at the kink.
answers parts stiffness --rail-moment 3000cm^4 --rail-mass 60kg/m --tie-spacing 0.6m --tie-width 0.25m --loaded-length 0.9m --ballast-depth 0.3m \
  --ballast-modulus 200MPa --friction-angle 25deg --soil-modulus 50MN/m^3 --tie-stiffness 100MN/m --pad-stiffness 80MN/m --tie-mass 120kg \
  --wheel-load 100kN --wheels 0.7m 2m --joint hinge --joint-at 0.3m
chain='inch = 0.0254; lbf = 4.4482216152605; psi = lbf / inch ^ 2
  spread = 2 * sin(angle) / cos(angle) * h; kb = (spread / h) * (l - w) * eb / log(l * (w + spread) / (w * (l + spread)))
  ks = k0 * (w + spread) * (l + spread); bed = kb * ks / (kb + ks); seat = 1 / (1 / kt + 1 / kp + 2 / bed); K = seat / s
  EI = moment * 206.842718795e9; beta = (K / (4 * EI)) ^ 0.25; kr = 2 * K / beta
  is("tie_spacing_in", s / inch); is("tie_width_in", w / inch); is("loaded_length_in", l / inch); is("ballast_depth_in", h / inch)
  is("ballast_modulus_psi", eb / psi); is("friction_angle_deg", angle * 180 / pi); is("soil_modulus_lbf_per_in3", k0 / (psi / inch))
  is("tie_stiffness_lbf_per_in", kt / (lbf / inch)); is("pad_stiffness_lbf_per_in", kp / (lbf / inch))
  is("ballast_lbf_per_in", kb / (lbf / inch)); is("subgrade_lbf_per_in", ks / (lbf / inch)); is("bed_lbf_per_in", bed / (lbf / inch))
  is("seat_lbf_per_in", seat / (lbf / inch)); is("foundation_modulus_psi", K / psi); is("foundation_modulus_MPa", K / 1e6)
  is("beta_per_in", beta * inch); is("beta_per_m", beta); is("point_stiffness_lbf_per_in", kr / (lbf / inch)); is("point_stiffness_MN_per_m", kr / 1e6)
  is("zero_distance_ft", 3 * pi / 4 / beta / 0.3048); is("zero_distance_m", 3 * pi / 4 / beta); is("wheel_load_kN", P / 1e3)
  kpt = kt * kp / (kt + kp) / s; upper = (kpt / (4 * EI)) ^ 0.25; k1 = 2 * kpt / upper
  rail = 1.5 * mass / upper; ballast = 0.0579 * 0.45359237 / inch ^ 3 * w * 270 * inch ^ 2 * area / (6 * s * (spread / 2 / h))
  is("tie_mass_kg", tie); is("rail_mass_kg", rail); is("bed_mass_kg", 1.5 * (tie / (2 * s) + ballast) / beta)
  is("rail_stiffness_MN_per_m", k1 / 1e6); is("bed_stiffness_MN_per_m", 1 / (1 / kr - 1 / k1) / 1e6)'
given="moment=3e-5 mass=60 s=0.6 w=0.25 l=0.9 h=0.3 eb=200e6 k0=50e6 kt=100e6 kp=80e6 tie=120 P=100e3 area=1"
functions='
  function moment_at(x) {x = beta * abs(x); return exp(-x) * (cos(x) - sin(x)) / (4 * beta)}
  function smooth(x) {x = beta * abs(x); return exp(-x) * (cos(x) + sin(x)) / kr}
  function jointed(x, from) {return smooth(x - from) + moment_at(x - at) * moment_at(from - at) / (spring + EI * beta / 2)} '
means parts "angle = 25 * pi / 180; $chain"'
  at = 0.3; spring = 0; near = P * (jointed(0.7, 0.7) + jointed(0.7, 2)); far = P * (jointed(2, 0.7) + jointed(2, 2))
  is("deflection_mm_at_0.700", 1e3 * near); is("deflection_mm_at_2.000", 1e3 * far)
  is("stiffness_MN_per_m_at_0.700", P / near / 1e6); is("stiffness_MN_per_m_at_2.000", P / far / 1e6)
  is("discrete_over_tie", 1, 1e-3); is("discrete_midspan", 1, 2e-3); says("rail", "^your own"); says("wheel_load_kN", "[|] $")
  says("tie_mass_kg", "[|] $"); says("tie_spacing_in", "[|] $"); says("foundation_modulus_psi", "eq. .3.")' $given
# Five decay lengths on either side of the wheels.
holds "deflection over the wheels" parts/stiffness.csv 'rows == 1 {first = $1} {last = $1} abs($1 - 0.7) < 0.01 {near($2, d, 0.01)}
  {near($3, $2 * k / 1e6, 1e-3)} END {near(rows, 1001, 0); near(0.7 - first, 5 / beta, 1e-4); near(last - 2, 5 / beta, 1e-4)}' \
  d="$(v parts deflection_mm_at_0.700)" beta="$(v parts beta_per_m)" k="$(awk -v k="$(v parts foundation_modulus_MPa)" 'BEGIN {print 1e6 * k}')"
# What is not given is the typical track, and said so; a joint at 0 where no place is given; the moment under a lone wheel is P / (4 beta).
answers usual stiffness
means usual 'inch = 0.0254; lbf = 4.4482216152605; s = 19.5 * inch; w = 9 * inch; l = 30 * inch; h = 12 * inch; psi = lbf / inch ^ 2; eb = 30000 * psi
  k0 = 100 * psi / inch; kt = 5e5 * lbf / inch; kp = 1e300; tie = 200 * 0.45359237; mass = 131.7 * 0.45359237 / 0.9144; moment = 87.9 * inch ^ 4
  P = 27500 * lbf; v["pad_stiffness_lbf_per_in"] = kp / (lbf / inch); angle = 20 * pi / 180; area = 1; '"$chain"'
  is("moment_kN_m", P / (4 * beta) / 1e3); is("deflection_mm_at_0.000", 1e3 * P / kr); is("stiffness_MN_per_m_at_0.000", kr / 1e6)
  for (key in notes) assumed += notes[key] == "assumed"; if (assumed != 9) bad(assumed " assumed")
  says("rail", "132RE"); free("discrete_over_tie discrete_midspan")'
grep -q '"pad_stiffness_lbf_per_in": "rigid (assumed)"' usual.json || fail "a pad that is rigid"
for joint in free:0:4 hinge:0:2 "sprung --joint-rotation 1MN*m:1e6:0"; do
  # shellcheck disable=SC2086 # a joint and its spring
  answers joint stiffness --foundation-modulus 10MPa --rail 60E1 --joint ${joint%%:*} --wheel-load 80kN
  means joint 'EI = 3038.3e-8 * 206.842718795e9; beta = (1e7 / (4 * EI)) ^ 0.25; kr = 2e7 / beta; P = 80e3; inch = 0.0254; lbf = 4.4482216152605
    y = times > 0 ? times * P / kr : P * jointed(0, 0)
    is("deflection_mm_at_0.000", 1e3 * y); is("stiffness_MN_per_m_at_0.000", P / y / 1e6); is("wheel_load_kN", 80); says("rail", "^60E1")
    is("foundation_modulus_MPa", 10); says("foundation_modulus_psi", "given"); is("foundation_modulus_psi", 1e7 / (lbf / inch ^ 2))
    free("beta_per_in beta_per_m point_stiffness_lbf_per_in point_stiffness_MN_per_m zero_distance_ft zero_distance_m")' \
    spring="$(echo "$joint" | cut -d: -f2)" times="${joint##*:}"
done
functions=
answers bare stiffness --ballast-depth 0in
grep -q '"ballast_lbf_per_in": "rigid"' bare.json || fail "no ballast"
# Without an angle of the ballast there is no lumped model; deep ballast overlaps.
answers flat stiffness --friction-angle 0rad
grep -q '"lumped": "none: eq. (18)' flat.json || fail "a friction angle of zero"
answers deep stiffness --ballast-depth 15in
grep -q '"overlap"' deep.json || fail "pyramids that overlap from 14.43 in on"
answers shallow stiffness --ballast-depth 14in
grep -q '"overlap"' shallow.json && fail "pyramids that do not overlap"

# A joint with every part given. Frequencies: their sum of squares and product are those of the chain of three masses.
answers mine joint --speed 30m/s --angle 8mrad --rail-length 12m --wheel-mass 700kg --wheel-load 90kN --wheel-radius 0.4m --crown-radius 0.4m \
  --rail-mass 50kg --rail-stiffness 200MN/m --rail-damping 10kN*s/m --bed-mass 300kg --bed-stiffness 40MN/m --bed-damping 30kN*s/m
means mine 'lbf = 4.4482216152605; e = 0.5 * 30e6 * lbf / 0.0254 ^ 2 / 0.91; hertz = 4 / 3 * e * sqrt(0.4); kh = 1.5 * 90e3 ^ (1 / 3) * hertz ^ (2 / 3)
  is("speed_m_per_s", 30); says("speed_m_per_s", "67.11 mph"); is("dip_mm", 1e3 * 0.008 * 12 / (2 * pi)); is("angle_mrad", 8)
  is("wheel_mass_kg", 700); is("wheel_load_kN", 90); is("contact_stiffness_MN_per_m", kh / 1e6); is("rail_mass_kg", 50); is("rail_stiffness_MN_per_m", 200)
  is("rail_damping_kN_s_per_m", 10); is("bed_mass_kg", 300); is("bed_stiffness_MN_per_m", 40); is("bed_damping_kN_s_per_m", 30)
  for (key in notes) if (notes[key] == "assumed") bad(key " was given")
  split(v["frequencies_Hz"], f, ", "); sum = product = 0; for (k = 1; k <= 3; ++k) {w = (2 * pi * f[k]) ^ 2; sum += w; product = product == 0 ? w : product * w}
  v["sum"] = sum; is("sum", kh / 700 + (kh + 200e6) / 50 + 240e6 / 300, 1e-4); v["product"] = product; is("product", kh * 200e6 * 40e6 / (700 * 50 * 300), 1e-3)
  says("frequencies_Hz", "^[0-9.]+, [0-9.]+, [0-9.]+"); free("p1_kN second_kN late_kN p2_kN least_kN evaluations"); is("contact_lost_ms", 0)
  says("integrator", "Dormand and Prince"); is("tolerance_change", 0, 1e-5); is("energy_defect", 0, 1e-5)'
# The first maximum of the force in the table, and the rail pressed down by what the springs bear once all is still.
holds "a first peak" mine/joint.csv 'rows > 2 && last > before && last > $2 && peak == "" && $1 > 0 {peak = last; at = when} {before = last; last = $2; when = $1}
  {near($6, 48 / 3.14159265358979 * (1 - abs(sin(3.14159265358979 * 30 * $1 / 1e3 / 12))), 1e-4)}
  {sum[rows] = sum[rows - 1] + $2}
  END {near(peak, p, 0.3); near(rows, 3251, 0); for (k = window; k <= rows; ++k) {mean = (sum[k] - sum[k - window]) / window; if (mean > most) most = mean}
    near(most, mean_of_one_period, 0.1)}' p="$(v mine p1_kN)" mean_of_one_period="$(v mine p2_kN)" \
  window="$(sed -n 's/.*"frequencies_Hz": "[0-9.]*, \([0-9.]*\),.*/\1/p' mine.json | awk '{printf "%d", 50000 / $1 + 0.5}')"
# Nothing to fall into: the force stays the static one.
answers still joint --speed 30m/s --dip 0m
means still 'is("dip_mm", 0); is("angle_mrad", 0); for (key in v) if (key ~ /^(p1|p2|second|late|least)_kN/) is(key, 122.3260944, 1e-5); is("contact_lost_ms", 0); is("tolerance_change", 0, 1e-5)
  free("speed_m_per_s frequencies_Hz contact_stiffness_MN_per_m integrator evaluations")
  for (key in v) if (notes[key] == "assumed") {free(key); ++assumed} if (assumed != 8) bad(assumed " assumed")'
# Contact that is lost for as long as the table has no force, a row every 20 us or less.
answers lost joint --speed 100mph --dip 1in --duration 50.01ms
holds "no force" lost/joint.csv '$2 == 0 {++none} {last = $1} END {near(none * 0.02, ms, 0.06); near(last, 50.01, 1e-9); near(rows, 2752, 0)}' ms="$(v lost contact_lost_ms)"
# A flat profile leaves no more open than the least, 0.3 % of the load; of fewer than ten samples nobody knows.
for last in 2.5 3; do
  awk -v last=$last 'BEGIN {print "distance_m,profile_mm"; for (x = -1.5; x <= last; x += 0.5) print x ",0"}' >flat$last.csv
  answers profile$last joint --speed 30m/s --profile flat$last.csv
done
grep -q '"sampling": "a profile of 9 samples' profile2.5.json || fail "a profile of 9 samples causes no warning"
means profile3 'is("profile_samples", 10); says("profile_samples", "500 mm apart")
  for (key in v) if (key ~ /_sampling_kN$/) {is(key, 0.003 * 122.3260944, 1e-5); says(key, "from every second sample$"); ++open}
  for (key in v) if (key ~ /^(p1|p2|second|late|least)_kN$/) is(key, 122.3260944, 1e-5); if (open < 3) bad(open " are open")
  for (key in v) if (notes[key] == "assumed") free(key); is("contact_lost_ms", 0); is("tolerance_change", 0, 1e-5)
  free("speed_m_per_s frequencies_Hz contact_stiffness_MN_per_m integrator evaluations")'
# What the tool warns of it says in per cent.
answers loose joint --speed 60mph --dip 0.5in --rail-mass 10g --tolerance 1e-3
means loose 'for (key in v) free(key); warns("tolerance", sprintf(" %.2g %%", 100 * v["tolerance_change"])); if (!(v["tolerance_change"] > 1e-3)) bad("change")
  if (v["energy_defect"] > 1e-3) warnings("energy")'
answers open joint --speed 60mph --dip 0.5in --rail-mass 100g --tolerance 1e-3
means open 'for (key in v) free(key); warns("energy", sprintf("open by %.2g %%", 100 * v["energy_defect"])); if (!(v["energy_defect"] > 1e-3)) bad("energy")
  if (v["tolerance_change"] > 1e-3) warnings("tolerance")'
answers ties stiffness --tie-spacing 6m
means ties 'for (key in v) free(key); over = abs(v["discrete_over_tie"] - 1); between = abs(v["discrete_midspan"] - 1); worst = over > between ? over : between
  warns("discrete-ties", sprintf("beta l_t = %.2g, .* up to %.2g %%", v["beta_per_m"] * 6, 100 * worst))'
answers coarse joint --speed 60mph --profile "$cases/../track/coarse.csv"
means coarse 'for (key in v) {free(key); if (key ~ /_sampling_kN$/) {force = v[substr(key, 1, length(key) - 12) "_kN"]; if (force < 122.3260944) force = 122.3260944
    if (v[key] / force > worst) worst = v[key] / force}} warns("sampling", sprintf("changes a peak by %.2g %%", 100 * worst))'
