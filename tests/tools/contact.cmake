# The tool refuses what it cannot use with exit status 2, and leaves nothing behind.
set(bodies --out ${PROJECT_BINARY_DIR}/ctest/contact-refused --body-1-radius-across 0.3m --body-2-radius-along 0.46m)
refuses(contact "neither approach nor load" "give one of approach and load: the other is the answer"
                 solve ${bodies})
refuses(contact "both approach and load" "give one of approach and load: the other is the answer"
                 solve ${bodies} --approach 10um --load 3kN)
refuses(contact "a load of zero" "load is 0 N. allowed: from 1e-12 to 1e+12"
                 solve ${bodies} --load 0N)
refuses(contact "a load in millimetres" "load is .3mm., a quantity in m. allowed: a unit of N"
                 solve ${bodies} --load 3mm)
refuses(contact "a missing unit" "load is .3., without a unit. allowed: a unit of N"
                 solve ${bodies} --load 3)
refuses(contact "a load that is no number" "load is .nan.. allowed: a finite number with a unit of N"
                 solve ${bodies} --load nan)
refuses(contact "a negative modulus" "body 1 young is -3000000000 Pa. allowed: from 1000 to 1e+18"
                 solve ${bodies} --load 3kN --body-1-young -3GPa)
refuses(contact "a Poisson's ratio above one half" "body 2 poisson is 0.501. allowed: from 0 to 0.5"
                 solve ${bodies} --load 3kN --body-2-poisson 0.501)
refuses(contact "a radius of zero" "radius of body 2 across the rail is 0 m. allowed: 1e-09 m to 1e+06 m"
                 solve ${bodies} --load 3kN --body-2-radius-across 0mm)
refuses(contact "bodies that do not separate" "relative curvature A is 0 1/m. allowed: greater than 0, else the"
                 solve --load 3kN)
refuses(contact "a missing profile" ".none.csv.: cannot be read"
                 solve --body-1-profile none.csv --body-2-radius-along 1m --load 3kN)
refuses(contact "a profile that is none" ".radii.toml.: no column .x."
                 solve --body-1-profile radii.toml --body-2-radius-along 1m --load 3kN)
refuses(contact "a profile and a radius" "body 1 has both a profile and a radius across the rail"
                 solve --body-1-profile rail.csv --body-1-radius-across 0.3m --body-2-radius-along 1m --load 3kN)
refuses(contact "a grid beyond memory" "a grid of 8192 x 8192 cells needs 5.5 GB"
                 solve ${bodies} --load 3kN --cells-x 8192 --cells-y 8192)
refuses(contact "a missing configuration" "none.toml.: cannot be read: No such file"
                 solve --config none.toml)
refuses(contact "a configuration that is a folder" "cannot be read: Is a directory"
                 solve --config .)
refuses(contact "a modulus that overflows" "body 1 young is 1e-300 Pa. allowed: from 1000 to 1e+18"
                 solve ${bodies} --load 3kN --body-1-young 1e-300Pa)
refuses(contact "a radius that overflows" "radius of body 1 across the rail is 1e-300 m. allowed: 1e-09 m to"
                 solve --body-1-radius-across 1e-300m --body-2-radius-along 1m --load 3kN)
refuses(contact "a contact as large as a radius" "the half width of the contact is 1.161 m"
                 solve ${bodies} --load 1e9kN)
refuses(contact "a load beyond the range" "load is 1e+300 N. allowed: from 1e-12 to 1e+12"
                 solve ${bodies} --load 1e300N)
set(points "-2,4\n-1,1\n0,0\n1,1\n2,4\n")
string(REPLACE "4\n" "1e308\n" overflowing "${points}")
string(REGEX REPLACE "\n" ",0\n" two_columns "${points}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/overflowing.csv "x_mm,depth_mm\n${overflowing}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/two-columns.csv "x_mm,depth_mm,height_mm\n${two_columns}")
refuses(contact "a profile that overflows" "point 1 of the profile of body 1: depth is 1e+305 m"
                 solve --body-1-profile ${CMAKE_CURRENT_BINARY_DIR}/overflowing.csv --body-2-radius-along 1m --load 3kN)
refuses(contact "a profile with a height and a depth" "has both a height and a depth. allowed: one of them"
                 solve --body-1-profile ${CMAKE_CURRENT_BINARY_DIR}/two-columns.csv --body-2-radius-along 1m --load 3kN)
foreach(example radii profiles)
  add_test(NAME "tool: contact solves ${example}.toml"
           COMMAND railbook contact solve --config examples/contact/${example}.toml
                   --out ${PROJECT_BINARY_DIR}/ctest/contact-${example}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/tools)
endforeach()
# What the answer says: answers(WHAT PATTERN arguments...).
function(contact_answers what pattern)
  add_test(NAME "tool: contact ${what}" COMMAND railbook contact solve ${ARGN})
  set_tests_properties("tool: contact ${what}" PROPERTIES PASS_REGULAR_EXPRESSION "${pattern}")
endfunction()
# The same as the chapter's cases turned-100, -30 and -10.
foreach(radius 100 30 10)
  contact_answers("holds a slender contact on ${radius} m at 45 degrees against Hertz at the asked load"
                  "Hertz: approach at this load +[0-9.]+ um +.the grid is off by -?[0-9.]+e-0[6-9]" --load 1kN
                  --body-1-radius-across ${radius}m --body-1-radius-along ${radius}m --body-2-radius-across 10mm --angle 45deg)
endforeach()
set(rows "x_mm,depth_mm\n")
set(coarse "x_mm,depth_mm\n")
foreach(k RANGE 0 240) # three summits 20 mm apart: parabolas of 250 mm radius
  math(EXPR u "${k} % 80 - 40")
  math(EXPR x "${k} * 250 - 30000")
  math(EXPR depth "(${u} * ${u} * 250 * 250) / 500") # nanometres
  string(APPEND rows "${x}e-3,${depth}e-6\n")
endforeach()
foreach(k RANGE -20 20) # the radius falls from 250 to 30 mm at 0.1 mm, points every half millimetre
  math(EXPR u "${k} * 500 - 100")
  set(radius 250)
  if(u GREATER 0)
    set(radius 30)
  endif()
  math(EXPR depth "(${u} * ${u}) / (2 * ${radius})")
  string(APPEND coarse "${u}e-3,${depth}e-6\n")
endforeach()
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/summits.csv "${rows}")
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/coarse.csv "${coarse}")
contact_answers("tells three patches" "patches +3 .*patch 3: force" --body-1-profile ${CMAKE_CURRENT_BINARY_DIR}/summits.csv
                --body-1-radius-along 0.5m --approach 20um --cells-x 400 --cells-y 60)
contact_answers("warns of a profile of too few points" "WARNING: every second point of the profiles alone would change"
                --body-1-profile ${CMAKE_CURRENT_BINARY_DIR}/coarse.csv --body-1-radius-along 0.5m --approach 20um)
# A profile whose x descends is the same profile.
add_test(NAME "tool: contact reads a profile from either side"
         COMMAND sh -c "{ sed '/x_mm/q' $1; sed '1,/x_mm/d' $1 | tac; } >$2.csv && cp $1 $2-as-is.csv && for f in $2-as-is $2; do $0 contact solve --body-1-profile $f.csv --body-1-radius-along 1e5m --body-2-radius-along 460mm --load 50kN --cells-x 24 --cells-y 24 --no-figures >$f.said || exit 1; done; tail -n +2 $2-as-is.said >$2.right; tail -n +2 $2.said | cmp $2.right"
                 $<TARGET_FILE:railbook> ${PROJECT_SOURCE_DIR}/tools/examples/contact/rail.csv ${PROJECT_BINARY_DIR}/ctest/contact-turned)
