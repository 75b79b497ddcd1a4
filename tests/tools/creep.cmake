# The tools refuse what they cannot use with exit status 2, for the reason expected, and leave nothing behind.
set(out --out ${PROJECT_BINARY_DIR}/ctest/creep-refused)
set(ellipse ${out} --a 6mm --b 4mm)
set(contact ${ellipse} --load 80kN)
refuses(creep "no load" "load is required" curve ${ellipse})
refuses(creep "a load of zero" "load is 0 N. allowed: from 1e-09" curve ${ellipse} --load 0N)
refuses(creep "a load without a unit" "load is .80., without a unit" curve ${ellipse} --load 80)
refuses(creep "neither axes nor radii" "give either both semi-axes" curve ${out} --load 80kN)
refuses(creep "one axis" "give either both semi-axes" curve ${out} --load 80kN --a 6mm)
refuses(creep "axes and radii" "give either both semi-axes" curve ${contact} --wheel-radius 460mm)
refuses(creep "an axis in newtons" "a is .6N., a quantity in N. allowed: a unit of m" curve ${out} --load 80kN --a 6N --b 4mm)
refuses(creep "bodies that do not separate" "relative curvature B is 0 1/m" curve ${out} --load 80kN --wheel-radius 460mm)
refuses(creep "a radius of zero" "wheel radius is 0 m. allowed: at least 1e-9 m" curve ${out} --load 80kN --wheel-radius 0m --rail-crown 0.3m)
refuses(creep "a contact larger than its radius" "semi-axis is .* of a radius. allowed: less than 1" curve ${out} --load 500MN --wheel-radius 460mm --rail-crown 10mm)
refuses(creep "a negative friction" "mu is -0.1. allowed" curve ${contact} --mu -0.1)
refuses(creep "a friction that is no number" "mu is .nan.. allowed: a finite number" curve ${contact} --mu nan)
refuses(creep "no friction and no range" "friction is 0.*give the end of the range" curve ${contact} --mu 0)
refuses(creep "a Poisson's ratio above one half" "wheel poisson is 0.6. allowed" curve ${contact} --wheel-poisson 0.6)
refuses(creep "a spin without a unit" "spin is .0.2., without a unit" curve ${contact} --spin 0.2)
refuses(creep "a spin in cycles" "spin is .0.2cycle/m.*allowed: a unit of rad/m" curve ${contact} --spin 0.2cycle/m)
refuses(creep "a creepage above one" "to is 2. allowed: from -1 to 1" curve ${contact} --to 2)
refuses(creep "an empty range" "to is 0, and so is from" curve ${contact} --to 0)
refuses(creep "a theory nobody knows" "theory is .kalker.*allowed" curve ${contact} --theory kalker)
refuses(creep "spin in the strip theory" "closed\\|strip theory here is for creepage without spin" curve ${contact} --theory fastrip --spin 0.2rad/m)
refuses(creep "an axis ratio beyond Kalker's table" "axis ratio a/b of Kalker's table is 20. allowed: from 0.1 to 10" curve ${out} --load 80kN --a 20mm --b 1mm --theory fastsim)
refuses(creep "a force beyond friction" "force is 30000 N. allowed: what the range" curve ${contact} --force 30kN)
refuses(creep "half a point" "points is 0.5. allowed" curve ${contact} --points 0.5)
refuses(creep "a missing configuration" "none.toml.: cannot be read: No such file" curve --config none.toml)
refuses(creep "an option nobody knows" "not expected: .*--speed" curve ${contact} --speed 3mph)
refuses(creep "a folder in a file's place" "cannot be written: Not a directory" curve --a 6mm --b 4mm --load 80kN --out ${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt)
refuses(creep "an even number of spins" "spin nodes is 4. allowed: an odd number" table ${out} --spin 4)
refuses(creep "axis ratios that go down" "last axis ratio is 0.5. allowed: from 2" table ${out} --ratio-from 2 --ratio-to 0.5)
refuses(creep "one ratio for a range" "axis ratios is 1. allowed: from 2" table ${out} --ratios 1)
refuses(creep "a table beyond memory" "nodes of the table is .*allowed: from 12 to 10000000" table ${out} --longitudinal 1000 --lateral 1000)
refuses(creep "a reach of zero" "reach is 0. allowed" table ${out} --reach 0)

set(histories ${CMAKE_CURRENT_SOURCE_DIR}/creep)
refuses(creep "a history without places" "no column .distance. or .time." history ${histories}/no-distance.csv ${contact})
refuses(creep "times without a speed" "give the speed of rolling, --speed" history ${histories}/times.csv ${contact})
refuses(creep "a force in millimetres" "column .fx_mm. names no unit that fits" history ${histories}/wrong-unit.csv ${contact})
add_test(NAME "tool: creep warns of a history of columns that it does not know"
         COMMAND sh -c "printf 'distance_mm,slip\n0,0.001\n1,0.001\n' >$1-slip.csv && $0 creep history $1-slip.csv --a 6mm --b 4mm --load 80kN --mu 0.3 --cells 8 --no-figures"
                 $<TARGET_FILE:railbook> ${PROJECT_BINARY_DIR}/ctest/creep)
set_tests_properties("tool: creep warns of a history of columns that it does not know" PROPERTIES
                     PASS_REGULAR_EXPRESSION "no creepage and no force is given, and columns are not used: slip")
add_test(NAME "tool: creep takes a spin in degrees"
         COMMAND railbook creep curve --a 6mm --b 4mm --load 80kN --mu 0.3 --spin 11deg/m --points 3 --cells 8 --no-figures)
refuses(creep "a history that goes back" "distance of row 3 is 0.001 m. allowed: not below" history ${histories}/back.csv ${contact})
refuses(creep "a force of the history beyond friction" "force along of row 1 is .*allowed" history ${PROJECT_SOURCE_DIR}/tools/examples/creep/braking.csv ${contact} --mu 0.1)
refuses(creep "a history without friction" "friction is 0. allowed" history ${PROJECT_SOURCE_DIR}/tools/examples/creep/braking.csv ${contact} --mu 0)
refuses(creep "an odd number of cells" "cells along is 9. allowed: an even number" history ${PROJECT_SOURCE_DIR}/tools/examples/creep/braking.csv ${contact} --cells 9)

set(folder ${PROJECT_BINARY_DIR}/ctest)
add_test(NAME "tool: creep curve answers"
         COMMAND railbook creep curve --config ${PROJECT_SOURCE_DIR}/tools/examples/creep/axes.toml --out ${folder}/creep-curve)
add_test(NAME "tool: creep curve takes radii"
         COMMAND railbook creep curve --config ${PROJECT_SOURCE_DIR}/tools/examples/creep/radii.toml --out ${folder}/creep-radii)
add_test(NAME "tool: creep curve finds the creepage of a force"
         COMMAND railbook creep curve --a 6mm --b 4mm --load 80kN --mu 0.3 --force 12kN)
set_tests_properties("tool: creep curve finds the creepage of a force" PROPERTIES
                     PASS_REGULAR_EXPRESSION "creepage for it +0\\.0015[0-9]+")
add_test(NAME "tool: creep table states its error"
         COMMAND railbook creep table --ratios 2 --longitudinal 4 --lateral 4 --spin 5 --points 20 --out ${folder}/creep-table)
set_tests_properties("tool: creep curve answers" PROPERTIES
                     PASS_REGULAR_EXPRESSION "spin creepage +0\\.2 1/m.*largest force +2[0-9.]+ [+]- [0-9]+ N" FAIL_REGULAR_EXPRESSION "two materials")
set_tests_properties("tool: creep curve takes radii" PROPERTIES
                     PASS_REGULAR_EXPRESSION "semi-axis a, along rolling +6\\.676 mm")
set_tests_properties("tool: creep table states its error" PROPERTIES
                     PASS_REGULAR_EXPRESSION "interpolation error of the force, largest +0\\.[0-9]+ of mu N")
foreach(case "one point|--points 1" "nothing but zeros|--mu 0 --to 0.001" "two points apart by rounding|--points 2 --from 0.004 --to 0.0040000000001")
  string(REGEX REPLACE "[|].*" "" what "${case}")
  string(REGEX REPLACE ".*[|]" "" options "${case}")
  separate_arguments(options)
  add_test(NAME "tool: creep curve draws ${what}" COMMAND railbook creep curve --a 6mm --b 4mm --load 80kN
           --theory fastsim ${options} --out "${folder}/creep-${what}")
endforeach()
# Outside of its range a theory says so above its answer, per row in the file; within, no word.
set(curve railbook creep curve --a 6mm --b 4mm --load 80kN --points 3 --theory)
add_test(NAME "tool: creep curve warns of Shen-Hedrick-Elkins under large spin" COMMAND ${curve} shen-hedrick-elkins --spin 200rad/m)
add_test(NAME "tool: creep curve warns of Polach under large spin" COMMAND ${curve} polach --spin 200rad/m)
add_test(NAME "tool: creep curve warns of Vermeulen-Johnson under spin" COMMAND ${curve} vermeulen-johnson --spin 0.01rad/m)
add_test(NAME "tool: creep curve warns of the linear theory beyond friction" COMMAND ${curve} linear)
add_test(NAME "tool: creep table counts what is outside of the range"
         COMMAND railbook creep table --theory polach --ratios 2 --spin 5 --longitudinal 3 --lateral 3 --points 20)
foreach(test "Shen-Hedrick-Elkins under large spin|Shen, Hedrick and Elkins is for .*3 of 3 rows"
        "Polach under large spin|Polach's law is for .*3 of 3 rows"
        "Vermeulen-Johnson under spin|Vermeulen and Johnson is for no spin" "the linear theory beyond friction|a third of what friction bears")
  string(REGEX REPLACE "[|].*" "" what "${test}")
  string(REGEX REPLACE ".*[|]" "" words "${test}")
  set_tests_properties("tool: creep curve warns of ${what}" PROPERTIES PASS_REGULAR_EXPRESSION "WARNING: .*${words}")
endforeach()
set_tests_properties("tool: creep table counts what is outside of the range" PROPERTIES
                     PASS_REGULAR_EXPRESSION "WARNING: Polach.*of 110 nodes and points")
add_test(NAME "tool: creep curve does not warn of small spin" COMMAND ${curve} shen-hedrick-elkins --spin 0.2rad/m)
add_test(NAME "tool: creep curve does not warn of the full theory" COMMAND ${curve} full --spin 0.2rad/m)
set_tests_properties("tool: creep curve does not warn of small spin" "tool: creep curve does not warn of the full theory" PROPERTIES
                     FAIL_REGULAR_EXPRESSION "WARNING")
add_test(NAME "tool: creep curve shows the error of the moment" COMMAND ${curve} full --spin 2rad/m)
set_tests_properties("tool: creep curve shows the error of the moment" PROPERTIES
                     PASS_REGULAR_EXPRESSION "and of the moment +[0-9.e-]+ N[*]m")
# A brake set at rest: the shift is Cattaneo's, 17.3 um, and the creepage comes to Carter's.
add_test(NAME "tool: creep history comes to steady rolling" COMMAND railbook creep history
         ${PROJECT_SOURCE_DIR}/tools/examples/creep/braking.csv --a 6mm --b 4mm --load 80kN --out ${folder}/creep-history)
set_tests_properties("tool: creep history comes to steady rolling" PROPERTIES
                     PASS_REGULAR_EXPRESSION "creepage at the end +0[.]0019[0-9]* [+]- .*fx +14000 .*\n +1 +0 +80 +- +17[.][0-9]")
add_test(NAME "tool: creep history reads times, loads and spin" COMMAND railbook creep history ${histories}/times.csv
         --a 6mm --b 4mm --load 80kN --speed 10m/s --cells 12)
set_tests_properties("tool: creep history reads times, loads and spin" PROPERTIES
                     PASS_REGULAR_EXPRESSION "columns not used +note.*\n +3 +20 +60 +0[.]002")
add_test(NAME "tool: creep history says what unlike bodies leave out" COMMAND railbook creep history ${histories}/times.csv
         --a 6mm --b 4mm --load 80kN --speed 10m/s --cells 8 --rail-young 30GPa)
set_tests_properties("tool: creep history says what unlike bodies leave out" PROPERTIES
                     PASS_REGULAR_EXPRESSION "WARNING: what the tractions do to the pressure.*Kalker's K")
