# `hunting geometry` refuses what it cannot use.
set(bad ${PROJECT_SOURCE_DIR}/tests/tools/hunting)
function(geometry_refuses what reason)
  refuses(hunting "geometry: ${what}" "${reason}" geometry ${ARGN})
endfunction()
function(wheel_refused what reason file)
  geometry_refuses(${what} ${reason} --wheel ${file} --rail worn-rail.csv ${ARGN}
                   --out ${PROJECT_BINARY_DIR}/ctest/hunting-refused)
endfunction()
wheel_refused("a missing file" "none.csv" none.csv)
wheel_refused("a column without a unit" "inward" ${bad}/bare.csv)
wheel_refused("a height that is a force" "height" ${bad}/wrong_unit.csv)
wheel_refused("too few points" "5 points" ${bad}/short.csv)
wheel_refused("a gap in the points" "gap.csv" ${bad}/gap.csv)
wheel_refused("millimetres named metres" "width of the profile" ${bad}/metres.csv)
wheel_refused("a flange on the outside" "on the outer side: it is mirrored" ${bad}/mirrored.csv)
wheel_refused("a wheel beside the rail" "do not touch" new-wheel.csv --back-to-back 1900mm)
wheel_refused("flanges on top of the rails" "does not fit" new-wheel.csv --back-to-back 1410mm)
wheel_refused("a profile too short for the table" "reach further" ${bad}/no_flange.csv)
wheel_refused("a table beyond the wheel" "reach further" new-wheel.csv --end 100mm --step 1mm)
wheel_refused("a gauge point below the data" "gauge point" new-wheel.csv --gauge-depth 90mm)
wheel_refused("the whole spacing for the half" "half spacing is 1\\.5 m" new-wheel.csv --half-spacing 1500mm)
wheel_refused("a value that is no number" "finite number" ${bad}/nan.csv)
wheel_refused("inches named millimetres" "width of the profile" ${bad}/inches.csv)
wheel_refused("a gauge of zero" "gauge is 0 m" new-wheel.csv --gauge 0mm)
wheel_refused("a noise of metres" "noise" new-wheel.csv --noise 1m)
geometry_refuses("a wheel without a rail" "both --wheel and --rail" --wheel new-wheel.csv)
geometry_refuses("a gauge for a pair of the paper" "their own place" --gauge 57in)
geometry_refuses("an unknown pair" "pair" --pair old)
geometry_refuses("a gauge without a unit" "gauge" --gauge 1435)
geometry_refuses("a negative radius" "radius" --radius -460mm)
geometry_refuses("an uneven table" "no whole number of steps" --step 0.07mm)
geometry_refuses("an uneven mean" "half the width" --average 0.0025in)
geometry_refuses("a cant in degrees" "cant" --cant 1deg)
add_test(NAME "tool: hunting geometry answers"
         COMMAND railbook hunting geometry --json --out ${PROJECT_BINARY_DIR}/ctest/hunting-geometry)
# The jump of the new wheel, by bisection to 1e-12 m.
set_tests_properties("tool: hunting geometry answers" PROPERTIES PASS_REGULAR_EXPRESSION "10\\.3558")
add_test(NAME "tool: hunting geometry takes profiles" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples/hunting
         COMMAND railbook hunting geometry --wheel worn-wheel.csv --rail new-rail.csv --noise 0.003mm
                 --out ${PROJECT_BINARY_DIR}/ctest/hunting-profiles)
set_tests_properties("tool: hunting geometry takes profiles" PROPERTIES PASS_REGULAR_EXPRESSION
                     "conicity at 3 mm, rolling axle +0\\.15")

# `hunting speed` and `hunting cycle`.
refuses(hunting "speed: a speed of zero" "speed is 0 m/s" speed --speed 0m/s)
refuses(hunting "speed: a range from zero" "lowest is 0 m/s" speed --lowest 0m/s)
refuses(hunting "speed: a range upside down" "highest speed is 20 m/s. allowed: from 30 to 10000" speed --lowest 30m/s --highest 20m/s)
refuses(hunting "speed: a negative mass" "body mass is -3 kg" speed --body-mass -3kg)
refuses(hunting "speed: a wheelset without mass" "wheelset mass is 0 kg" speed --wheelset-mass 0kg)
refuses(hunting "speed: a mass in metres" "body mass is .3m." speed --body-mass 3m)
refuses(hunting "speed: a mass beyond all cars" "body mass is 1e" speed --body-mass 1e300kg)
refuses(hunting "speed: a stiffness that is no number" "f11 is .nanN." speed --f11 nanN)
refuses(hunting "speed: dampers at no frequency" "damper frequency is 0" speed --damper-frequency 0rad/s)
refuses(hunting "speed: a car that is not there" "none.toml" speed none.toml)
refuses(hunting "speed: a name that no car has" "not expected: --bogie-mass" speed ${bad}/unknown.toml)
refuses(hunting "speed: a wheel without a rail" "both --wheel and --rail" speed --wheel new-wheel.csv)
refuses(hunting "cycle: a family that is not there" "family is 3. allowed: from 1 to 2" cycle --family 3)
refuses(hunting "cycle: amplitudes past the table" "largest amplitude is 0.0508 m.*allowed: from 0 to 0.01905" cycle --largest-amplitude 2in)
refuses(hunting "cycle: a first amplitude past the table" "first amplitude is 0.0254 m. allowed: from 0 to 0.01905" cycle --first-amplitude 1in)
refuses(hunting "cycle: a damper beside friction" "lateral-damper" cycle --suspension friction --lateral-damper 3kN*s/m)
refuses(hunting "cycle: speeds without a critical one" "no critical speed" cycle --highest 20m/s)
refuses(hunting "cycle: a speed of zero" "speed is 0 m/s" cycle --speed 0m/s)
refuses(hunting "cycle: a speed outside of the range" "speed on the branch is 60 m/s. allowed: from 1 to 50" cycle --highest 50m/s --speed 60m/s)
refuses(hunting "cycle: a negative mass" "wheelset mass is -1 kg" cycle --wheelset-mass -1kg)
refuses(hunting "cycle: a folder that cannot be" "cannot be" cycle --out /dev/null/x)
set(examples ${PROJECT_SOURCE_DIR}/tools/examples/hunting)
# The critical speeds that are in the chapter's table.
add_test(NAME "tool: hunting speed answers" COMMAND railbook hunting speed --json --out ${PROJECT_BINARY_DIR}/ctest/hunting-speed)
set_tests_properties("tool: hunting speed answers" PROPERTIES PASS_REGULAR_EXPRESSION "hopf_1_m_per_s\": 44\\.05591.*144\\.5 ft/s")
add_test(NAME "tool: hunting speed takes a car and profiles" WORKING_DIRECTORY ${examples}
         COMMAND railbook hunting speed car.toml --wheel worn-wheel.csv --rail new-rail.csv --speed 40m/s)
set_tests_properties("tool: hunting speed takes a car and profiles" PROPERTIES
                     PASS_REGULAR_EXPRESSION "car body +32140 kg")
add_test(NAME "tool: hunting cycle answers"
         COMMAND railbook hunting cycle --pair cn --speed 132ft/s --out ${PROJECT_BINARY_DIR}/ctest/hunting-cycle)
set_tests_properties("tool: hunting cycle answers" PROPERTIES
                     PASS_REGULAR_EXPRESSION "fold +45\\.81.*150\\.30.*cycles at 40\\.2336 m/s +2")

# What may be zero is zero.
foreach(option lateral-stiffness=0N/m vertical-stiffness=0N/m warp-stiffness=0N*m/rad lateral-friction=0N
        vertical-friction=0N warp-friction=0N*m centre-plate-friction=0N*m bolster-mass=0kg bolster-depth=0m f12=0N*m
        f22=0N*m^2 lateral-damper=0N*s/m warp-damper=0N*m*s/rad)
  add_test(NAME "tool: hunting speed with ${option}" COMMAND railbook hunting speed --${option})
  set_tests_properties("tool: hunting speed with ${option}" PROPERTIES PASS_REGULAR_EXPRESSION "critical speeds +[0-9]")
endforeach()
function(says what reason)
  add_test(NAME "tool: hunting ${what}" WORKING_DIRECTORY ${examples} COMMAND railbook hunting ${ARGN})
  set_tests_properties("tool: hunting ${what}" PROPERTIES PASS_REGULAR_EXPRESSION "${reason}")
endfunction()
function(does_not_say what reason)
  says(${what} "." ${ARGN})
  set_tests_properties("tool: hunting ${what}" PROPERTIES FAIL_REGULAR_EXPRESSION "${reason}")
endfunction()
says("cycle without a lateral spring" "points +[0-9]" cycle --lateral-stiffness 0N/m --largest-amplitude 8mm)
says("speed knows rounding" "zero within rounding" speed --lateral-stiffness 1e-12N/m)
does_not_say("speed calls no rounding unstable" "already unstable" speed --lateral-stiffness 1e-12N/m)
# Every word of stability. The cycles of CN at 131 ft/s and their multipliers are those of tests/lib/vehicle/balance.cpp and of an independent
# program's integration in time.
says("speed says that rest is stable" "\\(stable throughout\\)" speed --highest 20m/s)
says("speed says that rest is unstable at once" "\\(already unstable there\\)" speed --lowest 70m/s --highest 80m/s)
says("cycle says that the straight run is stable" "straight run at 30 m/s +stable" cycle --pair cn --speed 30m/s)
says("cycle says which cycle is stable" "cycle 1 at 39\\.9.*[(]stable[)].*cycle 2 at 39\\.9.*[(]unstable, [0-9]+ multipliers outside[)]"
     cycle --pair cn --speed 131ft/s)
does_not_say("cycle calls no lone cycle neutral" "neutral" cycle --pair cn --speed 131ft/s)
# Where describing functions have no cycle, and where theirs are not the equations'.
says("cycle where describing functions have none" "cycles at 45.* m/s +2" cycle --pair cn --speed 149ft/s)
says("cycle below the fold" "cycle 1 at.*22\\.33.*cycle 2 at.*24\\.26" cycle --speed 199ft/s)
says("cycle of the second critical speed" "fold +50\\.37" cycle --family 2 --out ${PROJECT_BINARY_DIR}/ctest/hunting-family-2)
says("cycle beyond the fold" "cycles at 46.* m/s +0 +.none on what was searched" cycle --pair cn --speed 151ft/s)
says("cycle in another datum" "followed in warp.*end of the range" cycle --pair cn --speed 132ft/s --against warp-stiffness
     --factor 0.98)
says("cycle with limited creep" "limited by a friction of 0\\.3.*points +[0-9]" cycle --wheel-rail-friction 0.3
     --largest-amplitude 6mm)
says("cycle with friction that sticks hard" "points +[0-9]" cycle --suspension friction --stick-speed 1.6e-7m/s --stick-rate
     6e-8rad/s)
# Stable cycles off the branches of the critical speeds, by integrations in time of another program: 13.779, 16.147, 13.498 and
# 16.128 mm, 21.7391 rad/s; 13.14, 12.59, 13.10, 12.39 mm, 20.993 rad/s; 12.37, 12.77, 12.25, 12.79 mm, 19.956 rad/s; and
# 11.46, 11.74, 11.36, 11.78 mm, 18.916 rad/s.
foreach(case "45 cn 0.3 13\\.7[78].* 16\\.14.* 13\\.50.* 16\\.12.*21\\.7[34]"
        "41 cn 0.3 13\\.14.* 12\\.59.* 13\\.10.* 12\\.39.*2(0\\.99|1\\.00)"
        "45 cn 0.15 12\\.3[67].* 12\\.77.* 12\\.25.* 12\\.79.*19\\.9[56]"
        "50 new 0.15 11\\.4[67].* 11\\.73.* 11\\.3[67].* 11\\.78.*18\\.91")
  string(REGEX MATCH "^([0-9]+) ([a-z]+) ([0-9.]+) (.*)$" _ "${case}")
  says("cycle finds a stable one in time: ${CMAKE_MATCH_2}, ${CMAKE_MATCH_3}, ${CMAKE_MATCH_1} m/s"
       "straight run at ${CMAKE_MATCH_1} m/s +unstable.*to a stable cycle.*found in time.*${CMAKE_MATCH_4}.*; stable" cycle --pair ${CMAKE_MATCH_2}
       --wheel-rail-friction ${CMAKE_MATCH_3} --speed ${CMAKE_MATCH_1}m/s --points 60)
endforeach()
says("cycle says where nothing stable was found" "WARNING: at 44 m/s the straight run and every cycle found are unstable, and no motion followed in time came to a stable one: the car does something else.*derailed"
     cycle --pair cn --speed 44m/s)
says("cycle says at which speeds nothing stable was found" "WARNING: from 42\\.[0-9]* to 45\\.[0-9]* m/s the straight run and every cycle found are unstable: the car does something else there" cycle --pair cn)
says("cycle says where a branch is lost" "could not be followed farther than [0-9.]* m/s, [0-9.]* mm: it may go on" cycle --pair cn
     --wheel-rail-friction 0.3 --tail 0.01)
# The torus by a finer tail and finer multipliers: 42.307 m/s.
says("cycle says how well a torus is known" "torus +42\\.3[01] [+]- 0\\.0[1-6] m/s" cycle --pair cn --largest-amplitude 12mm)
refuses(hunting "cycle: a datum without a speed" "give --speed" cycle --against warp-stiffness)
refuses(hunting "cycle: a datum that no car has" "against" cycle --speed 40m/s --against bogie-mass)
# Profiles: rounded inches, noise of 20 micrometres, over-smoothing.
says("geometry shows the scatter" "points to smoothed profile, rms +0.00.*scatter of the points" geometry
     --wheel worn-wheel.csv --rail new-rail.csv)
does_not_say("geometry does not warn of a clean profile" "WARNING" geometry --wheel ${bad}/fine-wheel.csv --rail
             ${bad}/fine-rail.csv --end 8mm --step 0.05mm)
says("geometry warns of rounding met exactly" "WARNING: conicity at 1 mm" geometry --wheel ${bad}/rounded-wheel.csv --rail
     ${bad}/rounded-rail.csv --noise 0mm)
says("geometry warns of a profile smoothed away" "WARNING: .*conicity at 3 mm depends" geometry --wheel worn-wheel.csv
     --rail new-rail.csv --noise 0.5mm)
says("speed warns of a profile smoothed away" "WARNING: the first critical speed depends" speed --wheel worn-wheel.csv
     --rail new-rail.csv --noise 0.5mm)
says("geometry tells points that go back" "WARNING: .*no points at -33\\.78 to -30\\.28 mm across.*left out +6 points" geometry
     --wheel ${bad}/backwards.csv --rail worn-rail.csv)
says("geometry takes a right wheel of its own" "runs about +[-0-9.]+ mm.*conicity at 1 mm, level axle" geometry --level
     --wheel worn-wheel.csv --rail new-rail.csv --right-wheel new-wheel.csv --end 8mm --step 0.05mm)
geometry_refuses("a rail upside down" "upside down" --wheel new-wheel.csv --rail ${bad}/upside-down-rail.csv)
# Left and right of their own; how friction limits; what wheels and rails bear.
says("cycle with a right wheel of its own" "at rest the wheelsets stand.*about +0\\.2[0-9]* mm +.to the left of the centre. 0\\.2[0-9]*, 0\\.2[0-9]*, 0\\.2[0-9]* mm"
     cycle --wheel worn-wheel.csv --rail new-rail.csv --right-wheel new-wheel.csv --noise 0.003mm --largest-amplitude 2mm --speed 42.75m/s)
says("cycle with the full theory's creep" "full theory, round contact.*fold +31\\.4[0-9]* [+]- [0-9.e-]+ m/s.*L/V" cycle --pair cn --wheel-rail-friction 0.3
     --creep-law full --speed 110ft/s --largest-amplitude 0.44in)
does_not_say("speed warns of no critical speed that is not there" "depends on the smoothing" speed --wheel worn-wheel.csv --rail new-rail.csv --lowest 10m/s --highest 20m/s)
refuses(hunting "speed: a damper where friction damps" "railbook: vertical-damper is for --suspension dampers" speed --suspension friction
        --vertical-damper 20kN*s/m)
refuses(hunting "cycle: a right wheel without a left one" "the left ones" cycle --right-wheel new-wheel.csv)
refuses(hunting "cycle: a law of no friction" "give --wheel-rail-friction" cycle --creep-law full)
# EN 15302: the numbers of the level axle's own list, 3 mm and (4 mm less 2 mm)/2. A cone of 1:20 on any head has 0.05 and is linear.
add_test(NAME "tool: hunting geometry follows EN 15302" COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/en-15302.sh ${bin})
geometry_refuses("a mean beside EN 15302" "takes no running mean" --standard en-15302 --average 0.5mm)
geometry_refuses("a table too short for EN 15302" "allowed with --standard: 4 mm or more" --standard en-15302 --end 0.1in --step 0.0025in)
geometry_refuses("a standard nobody knows" "standard is" --standard uic-519)
