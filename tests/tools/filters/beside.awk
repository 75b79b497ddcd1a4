# A record of a car with rows just outside of what is plausible, and just inside: an acceleration of 20 m/s^2, a rate of 1 rad/s, a displacement of
# 1 m (of two rows, for one alone is a spike), a spike of 50 mm, a speed of 150 m/s.
NR == 1 {for (i = 1; i <= NF; ++i) c[$i] = i}
NR == 100 {$c["vertical_left_m_per_s2"] = 20.1}
NR == 150 {$c["lateral_m_per_s2"] = -19.9}
NR == 200 {$c["yaw_rate_deg_per_s"] = 57.58}
NR == 250 {$c["roll_rate_deg_per_s"] = -57.0}
NR == 300 || NR == 301 {$c["height_left_mm"] = 1005}
NR == 350 || NR == 351 {$c["height_right_mm"] = -995}
NR == 400 || NR == 402 {$c["gage_left_mm"] = 20}
NR == 401 {$c["gage_left_mm"] = 70.3}
NR == 450 || NR == 452 {$c["gage_right_mm"] = 20}
NR == 451 {$c["gage_right_mm"] = -29.7}
NR == 2580 {$c["elapsed_s"] = 0.3048 / 150.7}
NR == 2570 {$c["elapsed_s"] = 0.3048 / 149.3}
{print}
