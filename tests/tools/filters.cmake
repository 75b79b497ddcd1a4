# `filters process` refuses what it cannot use; what it can use in spite of faults, it uses.
set(bad ${PROJECT_SOURCE_DIR}/tests/tools/filters)
refuses(filters "a record that is not there" "none.csv.: cannot be read" process none.csv)
refuses(filters "a record without times" "no column .elapsed_s.. there are" process ${bad}/no-time.csv)
refuses(filters "a record without sensors" "no sensor in it" process ${bad}/no-sensor.csv)
refuses(filters "a sensor without a unit" "column .yaw_rate. names no unit" process ${bad}/no-unit.csv)
refuses(filters "a yaw rate in millimetres" "column .yaw_rate_mm. names no unit that fits" process ${bad}/wrong-unit.csv)
refuses(filters "distances off the marks" "line 4: distance .* is 1.50 samples" process ${bad}/uneven.csv)
refuses(filters "a distance of more samples than there are" "line 4: distance .* is 1000000001.00 samples" process ${bad}/farther.csv)
refuses(filters "a distance of the last sample there is for its length alone" "the longest run .* has 2 samples" process ${bad}/far.csv)
refuses(filters "a distance far behind" "line 4: distance .* is -2000000000.00 samples" process ${bad}/far-back.csv)
refuses(filters "a cell that is no number" "line 3: column .gage_left_mm. is .two." process ${bad}/text.csv)
refuses(filters "a record too short" "has 2 samples. allowed: at least 663" process ${bad}/short.csv)
refuses(filters "a record of no rows" "has 0 samples. allowed: at least 663" process ${bad}/header.csv)
refuses(filters "a chord of an odd number of samples" "chord is .* allowed: an even number" process ${bad}/short.csv --chord 61ft)
refuses(filters "an even high-pass" "150" process ${bad}/short.csv --high-pass 150)
refuses(filters "an even mean of the curvature" "mean are 50. allowed: odd" process ${bad}/short.csv --curvature-mean 50)
refuses(filters "a corner of zero" "first corner is 0 .*allowed" process ${bad}/short.csv --first-corner 0Hz)
refuses(filters "a corner without a unit" "without a unit" process ${bad}/short.csv --second-corner 1)
refuses(filters "a key nobody knows" "wheels" process ${bad}/short.csv --config ${bad}/unknown.toml)
set(never ${PROJECT_BINARY_DIR}/ctest/filters-never.csv)
refuses(filters "a track that is too short" "length is" simulate --out ${never} --length 10m)
refuses(filters "speeds without distances" "0 distances for 2 speeds" simulate --out ${never} --speeds 60mph 9mph)
refuses(filters "a car that leaves the track" "position of the car" simulate --out ${never} --length 300m --speeds 60mph --distances 400m)
refuses(filters "truth in the record's own file" "truth is .*the record.s own file" simulate --out ${never} --truth ${never})
refuses(filters "a journey of no distance" "does not travel" simulate --out ${never} --speeds 0mph)

# A record to order, its faults, and the geometry made of it.
set(folder ${PROJECT_BINARY_DIR}/ctest)
add_test(NAME "tool: filters simulates a record" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/filters
         COMMAND railbook filters simulate --out ${folder}/filters-sensors.csv --config car.toml --length 4000ft --sensors typical
                 --truth ${folder}/filters-truth.csv)
add_test(NAME "tool: filters processes it" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/filters
         COMMAND railbook filters process ${folder}/filters-sensors.csv --config car.toml --out ${folder}/filters-mine)
add_test(NAME "tool: filters processes it with faults"
         COMMAND sh -c "awk -F, -v OFS=, 'NR==1500{$3=\"nan\"} NR==1600{$2=0} NR==1700{$9=1e30} NR==1750{$9=800} NR==1800{$2=1e-9} 1' $1 > $2 && $0 filters process $2 --out $3"
                 $<TARGET_FILE:railbook> ${folder}/filters-sensors.csv ${folder}/filters-faults.csv ${folder}/filters-faults)
add_test(NAME "tool: filters processes stop and reversal"
         COMMAND sh -c "$0 filters simulate --out $1 --length 4000ft --speeds 40mph 0mph -20mph 0mph 40mph --distances 1500ft 1ft 800ft 1ft 300ft --stand 60s && $0 filters process $1 --out $2"
                 $<TARGET_FILE:railbook> ${folder}/filters-turn.csv ${folder}/filters-turn)
set_tests_properties("tool: filters simulates a record" PROPERTIES FIXTURES_SETUP filters-record)
set_tests_properties("tool: filters processes it" PROPERTIES FIXTURES_REQUIRED filters-record
                     PASS_REGULAR_EXPRESSION "runs without a gap or a turn +1\n.*gage, mean where good +143[0-9]")
set_tests_properties("tool: filters processes it with faults" PROPERTIES FIXTURES_REQUIRED filters-record
                     PASS_REGULAR_EXPRESSION "WARNING: 1 values beyond.*1 spikes.*rejected +2 .*turn +3\n")
add_test(NAME "tool: filters names a misspelt column"
         COMMAND sh -c "sed '1s/lateral/latteral/' $1 > $2 && $0 filters process $2" $<TARGET_FILE:railbook> ${folder}/filters-sensors.csv ${folder}/filters-misspelt.csv)
set_tests_properties("tool: filters names a misspelt column" PROPERTIES FIXTURES_REQUIRED filters-record
                     PASS_REGULAR_EXPRESSION "not in the file: lateral\n.*columns not used: latteral_m_per_s2")
set_tests_properties("tool: filters processes stop and reversal" PROPERTIES
                     PASS_REGULAR_EXPRESSION "turn +3\n")

# Sensors that lie: said above the answer, kept in the JSON, and no figure fails for want of values.
function(warns_of what awk expected)
  set(name filters-${what})
  set(drawn --no-figures)
  if(what STREQUAL dead-sensor)
    set(drawn)
  endif()
  add_test(NAME "tool: filters warns of ${what}"
           COMMAND sh -c "awk -F, -v OFS=, '${awk} 1' $1 > $2.csv && $0 filters process $2.csv --out $2 ${drawn} && grep -q warnings $2/geometry.json"
                   $<TARGET_FILE:railbook> ${folder}/filters-sensors.csv ${folder}/${name})
  set_tests_properties("tool: filters warns of ${what}" PROPERTIES FIXTURES_REQUIRED filters-record PASS_REGULAR_EXPRESSION "${expected}")
endfunction()
warns_of(frozen-sensors "NR==501{l=\$0;split(l,a,FS)} NR>501&&NR<3800{for(i=3;i<=NF;i++)\$i=a[i]}" "WARNING: vertical_left: 3[23][0-9][0-9] rows without a change.*gage, mean where good +143")
warns_of(spike "NR==2000{\$3+=1}" "WARNING: vertical_left: 1 jump of up to 1 m")
warns_of(dead-sensor "NR>1{\$6=\"nan\"}" "WARNING: inclinometer: no value at all")
warns_of(turned-sign "NR>1{\$8=-\$8}" "WARNING: roll_rate: .* its sign is turned")
warns_of(wrong-unit "NR>1{\$5/=9.80665}" "WARNING: lateral: .* in g under a header of m/s.2")
# Biases that the record itself contradicts; with them, what rests on them is not good.
warns_of(yaw-bias "NR>1{\$7+=0.5}" "WARNING: yaw_rate: .*--yaw-bias.*crosslevel, mean where good +nowhere good")
warns_of(roll-bias "NR>1{\$8+=0.5}" "WARNING: roll_rate: .*--roll-bias.*crosslevel, mean where good +nowhere good")
warns_of(inclinometer-bias "NR>1{\$6+=0.05}" "WARNING: inclinometer: .*by 0.0[45][0-9]* m/s.2: a bias.*crosslevel, mean where good +nowhere good")
warns_of(vertical-bias "NR>1{\$3+=0.06}" "WARNING: vertical_left: .* above that of vertical_right.*--stages 2")
add_test(NAME "tool: filters refuses sensors that all stand still"
         COMMAND sh -c "awk -F, -v OFS=, 'NR==2{split(\$0,a,FS)} NR>2{for(i=3;i<=NF;i++)\$i=a[i]} 1' $1 > $2.csv && exec $3 'nothing can be measured' $0 filters process $2.csv --screen still"
                 $<TARGET_FILE:railbook> ${folder}/filters-sensors.csv ${folder}/filters-still ${CMAKE_CURRENT_SOURCE_DIR}/refuses.sh)
set_tests_properties("tool: filters refuses sensors that all stand still" PROPERTIES FIXTURES_REQUIRED filters-record)
foreach(length 2km 777m 1000m 1234.5m 1mi)
  add_test(NAME "tool: filters simulates ${length}" COMMAND railbook filters simulate --out ${folder}/filters-length.csv --length ${length})
  set_tests_properties("tool: filters simulates ${length}" PROPERTIES RUN_SERIAL ON)
endforeach()
refuses(filters "a track of a million million samples" "length of the track over .* is 10000000. allowed: from 100 to 1000000" simulate --out ${never} --length 100km --sample 1cm)
refuses(filters "trucks of one axle" "truck spacing is 0.6 m. allowed: from 0.6096 to 100" simulate --out ${never} --truck-spacing 0.6m)
refuses(filters "a journey of years" "time of the journey is .* s. allowed: from 0 to 100000" simulate --out ${never} --speeds 0.01mm/s)
refuses(filters "a dip of a kilometre" "dip is" simulate --out ${never} --dip 1km)
refuses(filters "a record without a place for it" "out is required" simulate)

# "Try next" of chapter 04, on the copies of its sources that it takes: the corners in configuration.hpp at a tenth.
set(from ${PROJECT_SOURCE_DIR}/chapters/04-filters)
set(to ${CMAKE_CURRENT_BINARY_DIR}/corners-at-a-tenth)
foreach(source experiment.hpp experiment.cpp sections.hpp speeds.cpp)
  configure_file(${from}/${source} ${to}/${source} COPYONLY)
endforeach()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${from}/configuration.hpp)
file(READ ${from}/configuration.hpp text)
string(REPLACE "corner = 2 * units::pi * 1.0;" "corner = 2 * units::pi * 0.1;" tenth "${text}")
if(tenth STREQUAL text)
  message(FATAL_ERROR "chapters/04-filters/configuration.hpp has no corners of 1.0 Hz")
endif()
file(CONFIGURE OUTPUT ${to}/configuration.hpp CONTENT "${tenth}" @ONLY)
# Of the chapter's statements those of speeds.cpp: a claim of an item that is not there is refused.
file(READ ${from}/data/claims.csv claims)
string(REGEX REPLACE "\n(fig-[01]|small-|table-[a-bd-z]|table-co|table-cu|roll|chords)[^\n]*" "" claims "${claims}")
file(COPY ${from}/data DESTINATION ${to})
file(REMOVE ${to}/data/captions.csv) # of all its items
file(WRITE ${to}/data/claims.csv "${claims}")
add_executable(corners_at_a_tenth filters/corners_at_a_tenth.cpp ${to}/experiment.cpp ${to}/speeds.cpp)
target_include_directories(corners_at_a_tenth PRIVATE ${to})
target_compile_definitions(corners_at_a_tenth PRIVATE RAILBOOK_CHAPTER_DIR="${to}")
target_link_libraries(corners_at_a_tenth PRIVATE railbook_flags railbook_geometry_car railbook_filters railbook_num
                      railbook_report railbook_plot)
add_test(NAME "chapter: 04-filters follows its corners" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/filters/corners_at_a_tenth.sh
         $<TARGET_FILE:corners_at_a_tenth> ${PROJECT_BINARY_DIR}/ctest/corners-at-a-tenth ${PROJECT_SOURCE_DIR}/figures/04-filters)
# Joints of rails and a coarse gyro are no faults of sensors: a profile is good where it was, and no warning is printed.
add_test(NAME "tool: filters process keeps joints"
         COMMAND sh -c "$0 filters simulate --out $1-dip.csv --length 2000m --speeds 60mph --dip 30mm && $0 filters process $1-dip.csv"
                 $<TARGET_FILE:railbook> ${folder}/filters)
set_tests_properties("tool: filters process keeps joints" PROPERTIES PASS_REGULAR_EXPRESSION "profile_left, mean where good .*good (8[5-9]|9[0-9])"
                     FAIL_REGULAR_EXPRESSION "WARNING|profile_left, mean where good +nowhere")
add_test(NAME "tool: filters process keeps a coarse gyro on straight track"
         COMMAND sh -c "$0 filters simulate --out $1-straight.csv --length 2000m --speeds 60mph --superelevation 0m --curvature 0rad/m --line-roughness 1e-9m^2*cycle/m --dip 0m && awk -F, -v OFS=, 'NR>1{q=\$7/0.05;\$7=0.05*int(q+(q<0?-.5:.5))} 1' $1-straight.csv >$1-coarse.csv && $0 filters process $1-coarse.csv"
                 $<TARGET_FILE:railbook> ${folder}/filters)
set_tests_properties("tool: filters process keeps a coarse gyro on straight track" PROPERTIES
                     PASS_REGULAR_EXPRESSION "curvature, mean where good .*good 9[0-9]" FAIL_REGULAR_EXPRESSION "masked")

# A wave of 10 m and 2 mm at 20 m/s, with a bias and in g: an rms of 2 mm/sqrt(2) in D1 (to 0.2 %, for ends), whatever the unit; (2 pi 20/25)^2 mm/s^2 a mm at 25 m.
set(wave "BEGIN{k=2*atan2(0,-1)/10; print h; for(i=0;i<1200;i++) printf \"%.2f,%.17g\\n\",i/2,(0.3-20^2*k^2*0.002*cos(k*i/2))/u}")
add_test(NAME "tool: filters integrates an acceleration"
         COMMAND sh -c "awk -v h='distance_m,az_m/s^2' -v u=1 '${wave}' >$1-si.csv && awk -v h=distance_m,az -v u=9.80665 '${wave}' >$1-g.csv && $0 filters integrate $1-si.csv --column az --speed 20m/s && $0 filters integrate $1-g.csv --column az --speed 72km/h --unit g"
                 $<TARGET_FILE:railbook> ${folder}/filters-wave)
set_tests_properties("tool: filters integrates an acceleration" PROPERTIES FAIL_REGULAR_EXPRESSION "WARNING"
                     PASS_REGULAR_EXPRESSION "rms +1\\.41[2-6] mm.*of 1 mm at 25 m +0\\.02527 m/s.2.*rms +1\\.41[2-6] mm")
set(axlebox ${PROJECT_SOURCE_DIR}/tools/examples/filters/axlebox.csv)
refuses(filters "an acceleration without a speed" "give --speed, or its column" integrate ${axlebox})
refuses(filters "a speed twice" "give --speed, or its column" integrate ${axlebox} --speed 20m/s --speed-column speed)
refuses(filters "a speed that is an acceleration" "has the unit m/s.2. allowed: a speed" integrate ${axlebox} --speed-column acceleration)
refuses(filters "an acceleration that is a speed" "has the unit m/s. allowed: an acceleration" integrate ${axlebox} --column speed --speed 20m/s)
refuses(filters "a band longer than the record" "record is 600 m long.*allowed: more than 1328 m" integrate ${axlebox} --speed 20m/s --band D3)
# Waves of 12 m that are cut off in full swing leave nothing in D3 beyond the margin.
add_test(NAME "tool: filters integrate does not ring at ends"
         COMMAND sh -c "awk 'BEGIN{k=2*atan2(0,-1)/12; print \"distance_m,az_m/s^2\"; for(i=0;i<8000;i++) printf \"%.2f,%.9g\\n\",i/4,-30^2*k^2*0.003*sin(k*i/4+1)}' >$1-ends.csv && $0 filters integrate $1-ends.csv --column az --speed 30m/s --band D3"
                 $<TARGET_FILE:railbook> ${folder}/filters)
set_tests_properties("tool: filters integrate does not ring at ends" PROPERTIES
                     PASS_REGULAR_EXPRESSION "height in the band, rms +(0\\.00[0-9]+|[0-9.]+e-0[0-9]) mm.*not within 664 m")
refuses(filters "a band too fine" "shortest wavelength of the band is 1" integrate ${axlebox} --speed 20m/s --band 1m-3m)
# A code for lost samples in an acceleration is warned of by its place, and left out when it is named.
add_test(NAME "tool: filters integrate warns of a code"
         COMMAND sh -c "awk -v h='distance_m,az_m/s^2' -v u=1 '${wave}' | awk -F, -v OFS=, 'NR==602||NR==603{$2=-9999} 1' >$1-code.csv && $0 filters integrate $1-code.csv --column az --speed 20m/s && $0 filters integrate $1-code.csv --column az --speed 20m/s --missing -9999"
                 $<TARGET_FILE:railbook> ${folder}/filters-wave)
set_tests_properties("tool: filters integrate warns of a code" PROPERTIES
                     PASS_REGULAR_EXPRESSION "WARNING: acceleration: 2 samples far off with one value, such as -9999 m/s.2 at 300 m to 300.5 m: a code.*heights in [^W]*rms +1\\.41[0-9] mm")
# Faults of an accelerometer: warned of by count and place, in the answer and in warnings.csv, and taken out where --screen can.
set(faulty "BEGIN{k=2*atan2(0,-1)/10; print \"distance_m,az_m/s^2\"; for(i=0;i<2400;i++){a=-20^2*k^2*(0.002*cos(k*i/4)+0.001*cos(1.7*k*i/4)+1e-4*sin(9.1*k*i/4)); %; printf \"%.2f,%.6f\\n\",i/4,a}}")
function(warns_of name fault options warning)
  string(REPLACE "%;" "${fault};" program "${faulty}")
  add_test(NAME "tool: filters integrate warns of ${name}"
           COMMAND sh -c "awk '${program}' >$1.csv && $0 filters integrate $1.csv --column az --speed 20m/s --out $1 --no-figures ${options} && cat $1/warnings.csv"
                   $<TARGET_FILE:railbook> ${folder}/filters-fault-${name})
  set_tests_properties("tool: filters integrate warns of ${name}" PROPERTIES PASS_REGULAR_EXPRESSION "${warning}")
endfunction()
warns_of(spikes "if(i==900||i==1500)a+=300" "" "WARNING: acceleration: 2 samples in 2 places far off, the largest by 30[0-9.]+ m/s.2 at (225|375) m.*az,outliers,225,225,1,30[0-9.]+,no,--screen outliers")
warns_of(spikes-screened "if(i==900||i==1500)a+=300" "--screen outliers" "2 samples in 2 places far off.*Taken out.*rms +1\\.4[0-9]+ mm.*az,outliers,225,225,1,30[0-9.]+,yes")
warns_of(a-stuck-sensor "if(i>=1000&&i<1080)a=0.2" "" "WARNING: acceleration: 79 samples repeat the one before, 79 of them from 250.25 m to 269.75 m: a sensor that stuck.*az,stuck,250.25,269.75,79,0.2,no")
warns_of(clipping "if(a>0.25)a=0.25" "" "WARNING: [0-9]+ samples are at an end of the range, 0.25 m/s.2, the first at [0-9.]+ m: does the accelerometer clip.*az,clipped,")
warns_of(a-unit-too-large "a*=9.80665*2" "" "WARNING: the heights are more than twice those of the roughest reference spectrum .fra-1, 8 mm.")
warns_of(a-unit-too-small "a/=9.80665" "" "WARNING: the heights are below those of the smoothest reference spectrum .china-hsr, 0.28 mm.")
string(REPLACE "%;" "" faultless "${faulty}")
add_test(NAME "tool: filters integrate keeps a good accelerometer"
         COMMAND sh -c "awk '${faultless}' >$1.csv && $0 filters integrate $1.csv --column az --speed 20m/s" $<TARGET_FILE:railbook> ${folder}/filters-no-fault)
set_tests_properties("tool: filters integrate keeps a good accelerometer" PROPERTIES FAIL_REGULAR_EXPRESSION "WARNING"
                     PASS_REGULAR_EXPRESSION "rms +1\\.4[0-9]+ mm")
