# The tools of wheel on rail: what they refuse, answers with known digits, and a table in parts.
set(out --out ${PROJECT_BINARY_DIR}/ctest/wheelrail-refused)
set(position ${out} --load 50kN --speed 30m/s)
refuses(wheelrail "no load" "load is required" contact ${out} --speed 30m/s)
refuses(wheelrail "no speed" "speed is required" contact ${out} --load 50kN)
refuses(wheelrail "a load without a unit" "load is .50., without a unit" contact ${out} --speed 30m/s --load 50)
refuses(wheelrail "a shift off the rails" "shift is 0.06 m. allowed: from -0.05" contact ${position} --shift 60mm)
refuses(wheelrail "a wheel beside its rail" "nowhere above its rail\\|end of a profile" contact ${position} --gauge 1700mm --roll 0rad --slip 0)
refuses(wheelrail "the end of a tread" "end of a profile" contact ${position} --gauge 1590mm --roll 0rad --slip 0)
refuses(wheelrail "roll without slip" "give both roll and slip" contact ${position} --roll 1mrad)
refuses(wheelrail "a negative friction" "mu is -0.1. allowed" contact ${position} --mu -0.1)
refuses(wheelrail "a method nobody knows" "method is .kalker.*allowed" contact ${position} --method kalker)
refuses(wheelrail "four cells" "cells is 4. allowed: from 8" contact ${position} --cells 4)
refuses(wheelrail "a file that is not there" "none.csv.: cannot be read: No such file" contact ${position} --wheel none.csv)
refuses(wheelrail "shifts that go down" "last shift is -0.01 m. allowed: from 0.001 to 0.05" table ${position} --from 1mm --to -10mm)
refuses(wheelrail "yaws that go down" "last yaw is -0.001 rad. allowed: from 0.001 to 0.1" table ${position} --yaw-from 1mrad --yaw-to -1mrad)
refuses(wheelrail "a table of a thousand million rows" "rows of the table is 1000000000. allowed: from 1 to 20000000" table ${position} --shifts 100000 --yaws 10000 --yaw-to 1mrad)

# The Manchester benchmark, y = 3 mm: CONTACT says 713.2 MPa and 9774 N on the right wheel.
add_test(NAME "tool: wheelrail contact answers the benchmark"
         COMMAND railbook wheelrail contact --head 60E1-benchmark --shift 3mm --yaw 7.2mrad --roll -0.1803mrad --load 10kN --speed 2m/s
         --slip -0.000615411 --wheel-young 209.92GPa --rail-young 209.92GPa --out ${PROJECT_BINARY_DIR}/ctest/wheelrail-contact)
set_tests_properties("tool: wheelrail contact answers the benchmark" PROPERTIES PASS_REGULAR_EXPRESSION
                     "left.*49[89][.0-9]* [+]- [0-9.]+ MPa.*right patch 1.*normal force +977[0-9.]+ N.*largest pressure +71[0-9.]+ [+]- [0-9.]+ MPa.*von Mises stress in the rail +46[0-9.]+ MPa.*depth of +0\\.9[0-9]+ mm")
add_test(NAME "tool: wheelrail contact takes files" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/hunting
         COMMAND railbook wheelrail contact --wheel new-wheel.csv --rail worn-rail.csv --gauge 56.5in --gauge-depth 0.625in
         --radius 16.5in --load 15000lbf --speed 60mph --method strips --mu 0 --out ${PROJECT_BINARY_DIR}/ctest/wheelrail-files)
set_tests_properties("tool: wheelrail contact takes files" PROPERTIES PASS_REGULAR_EXPRESSION "right patch 1"
                     FAIL_REGULAR_EXPRESSION "gnuplot")
add_test(NAME "tool: wheelrail table in parts" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/wheelrail.sh ${bin})
add_test(NAME "tool: profiles are read in each form of file" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/profile_formats.sh ${bin})
add_test(NAME "tool: wheelrail measure gives the gauges" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/measure.sh ${bin})
refuses(wheelrail "a rail without its crown" "the crown, -10 mm across, is not on the profile" measure ${CMAKE_CURRENT_SOURCE_DIR}/wheelrail/aside.csv --body rail)
add_test(NAME "tool: several wheels on several rails are answered in rows" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/pairs.sh ${bin})
add_test(NAME "tool: wheelrail takes two sides that differ" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/two_sides.sh ${bin})

add_test(NAME "tool: wheelrail contact answers upright rails"
         COMMAND railbook wheelrail contact --load 50kN --speed 10m/s --cant 0 --roll 0rad --slip 0 --method strips)
set_tests_properties("tool: wheelrail contact answers upright rails" PROPERTIES PASS_REGULAR_EXPRESSION "right patch 1")
# Rounded points: a solution with profiles half as smooth beside the answer.
add_test(NAME "tool: wheelrail contact says what the smoothing does" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/hunting
         COMMAND railbook wheelrail contact --wheel worn-wheel.csv --rail new-rail.csv --load 50kN --speed 10m/s --slip 0 --roll 0rad
         --shift 0mm)
set_tests_properties("tool: wheelrail contact says what the smoothing does" PROPERTIES PASS_REGULAR_EXPRESSION
                     "scatter of the points.*largest pressure +[0-9.]+ [+]- [0-9.]+ MPa +.[0-9]+ % of the error from the smoothing")
# At Nadal's edge friction and load swing about the depth that bears both.
add_test(NAME "tool: wheelrail contact settles at Nadal's edge"
         COMMAND railbook wheelrail contact --shift 7.3734mm --yaw -10.9721mrad --load 8632N --mu 0.5 --speed 7.84m/s --head 60E1-benchmark
         --cant 0.05 --cells 16)
set_tests_properties("tool: wheelrail contact settles at Nadal's edge" PROPERTIES PASS_REGULAR_EXPRESSION
                     "right rail: force.*down +86[0-9.]+ N.*normal force +(69|7[0-9])[0-9.]+ N")
# Nadal's limit of a flange of 70 degrees and a friction of 0.3: (tan 70 - 0.3)/(1 + 0.3 tan 70) = 1.3417.
add_test(NAME "tool: wheelrail contact gives Y/Q and Nadal's limit"
         COMMAND railbook wheelrail contact --load 50kN --speed 10m/s --slip 0 --roll 0rad --method strips)
set_tests_properties("tool: wheelrail contact gives Y/Q and Nadal's limit" PROPERTIES PASS_REGULAR_EXPRESSION
                     "Nadal's limit of Y/Q +1\\.34[12].*flange of 70\\.0 degrees.*Y/Q, outward over down")
add_test(NAME "tool: wheelrail says what does not converge, and answers nothing" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/unconverged.sh ${bin})

# Beyond the flange's steepest place a wheel has climbed; on its face Y/Q says whether it may.
foreach(case "8mm:climbed. the wheel stands at [0-9]+ degrees on its flange.* 1[0-9.]+ mm above" "6.4mm:Y/Q of 1.[0-9]+ is above Nadal's limit of 1.34")
  string(REGEX MATCH "^([^:]*):(.*)$" all "${case}")
  add_test(NAME "tool: wheelrail contact warns of climbing at ${CMAKE_MATCH_1}"
           COMMAND railbook wheelrail contact --load 80kN --speed 30m/s --method strips --shift ${CMAKE_MATCH_1})
  set_tests_properties("tool: wheelrail contact warns of climbing at ${CMAKE_MATCH_1}" PROPERTIES PASS_REGULAR_EXPRESSION
                       "WARNING: right wheel: ${CMAKE_MATCH_2}" FAIL_REGULAR_EXPRESSION "left wheel: (climbed|Y/Q)")
endforeach()

add_test(NAME "tool: hunting geometry warns of a wheelset on its flanges' roots" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/hunting
         COMMAND railbook hunting geometry --wheel worn-wheel.csv --rail worn-rail.csv --gauge 1415mm)
set_tests_properties("tool: hunting geometry warns of a wheelset on its flanges' roots" PROPERTIES PASS_REGULAR_EXPRESSION
                     "WARNING: wheel .*the centred wheelset stands on the roots of its flanges, at 22 degrees.*back-to-back and origin\n")
# A wheel whose origin is 12 mm off has a flange that no wheel has.
add_test(NAME "tool: hunting warns of a flange that is too thick"
         COMMAND sh -c "awk -F, -v OFS=, '/^[-0-9]/ {$1 -= 12} 1' $1 >$2 && $0 hunting geometry --wheel $2 --rail $3 --no-figures"
                 $<TARGET_FILE:railbook> ${PROJECT_SOURCE_DIR}/tools/examples/hunting/worn-wheel.csv ${PROJECT_BINARY_DIR}/ctest/thick-wheel.csv
                 ${PROJECT_SOURCE_DIR}/tools/examples/hunting/worn-rail.csv)
set_tests_properties("tool: hunting warns of a flange that is too thick" PROPERTIES PASS_REGULAR_EXPRESSION "flange would be [0-9.]+ mm thick .Sd.")
