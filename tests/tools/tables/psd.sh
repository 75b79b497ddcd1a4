# Sourced by tables.sh.
# 4 mm of a wave of 6 m, and waves of 1 m and 60 m: the band of 3 to 25 m has the first alone.
awk 'BEGIN {print "distance_m,profile_mm"; for (i = 0; i < 12000; ++i) {w = 2 * 3.14159265358979 * i / 4
  printf "%.2f,%.4f\n", i / 4, 4 * sin(w / 6) + 2 * sin(w) + 6 * sin(w / 60) + 0.1 * sin(i * i)}}' >waves.csv
answers rms classify waves.csv --reference fra-5
near "rms of waves of 3 to 25 m" "$(v rms rms_3_25_mm)" 2.83 0.05
