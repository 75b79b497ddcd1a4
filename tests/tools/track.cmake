# The tool refuses what it cannot use: exit status 2.
refuses(track "an unknown rail" "rail section .140RE. is not known"
                 stiffness --rail 140RE)
refuses(track "a spacing of zero" "tie spacing is 0 m. allowed: from 0.001 to 100"
                 stiffness --tie-spacing 0in)
refuses(track "a negative stiffness" "tie stiffness is -3000 N/m. allowed: from 1 to 1e+20"
                 stiffness --tie-stiffness -3kN/m)
refuses(track "a wrong unit" "tie spacing is .3kN., a quantity in N. allowed: a unit of m"
                 stiffness --tie-spacing 3kN)
refuses(track "a missing unit" "ballast depth is .12., without a unit. allowed: a unit of m"
                 stiffness --ballast-depth 12)
refuses(track "a tie wider than the spacing" "tie width is 0.762 m. allowed: from 1e-06 to 0.4953"
                 stiffness --tie-width 30in)
refuses(track "two sources of K" "foundation modulus is given and so are parts it would be made of"
                 stiffness --foundation-modulus 2000psi --tie-spacing 24in)
refuses(track "a sprung joint without its spring" "joint sprung needs joint rotation (such as 5 MN.m), and no other"
                 stiffness --joint sprung)
refuses(track "an unknown option" "not expected: --gauge, no option of stiffness"
                 stiffness --gauge 1435mm)
refuses(track "a modulus beyond all ranges" "foundation modulus is .1e-320psi., which a double cannot hold"
                 stiffness --foundation-modulus 1e-320psi)
refuses(track "a ballast beyond all ranges" "ballast depth is 2.54e+198 m. allowed: from 0 to 100"
                 stiffness --ballast-depth 1e200in)
refuses(track "a quantity that is no number" "tie stiffness is .nanN/m.. allowed: a finite number with a unit of N/m"
                 stiffness --tie-stiffness nanN/m)
refuses(track "a tie mass without its chain" "tie mass serves the lumped model, which a foundation modulus alone"
                 stiffness --foundation-modulus 2000psi --tie-mass 200lb)
refuses(track "the place of no joint" "joint at is given but no joint"
                 stiffness --joint-at 30in)
refuses(track "two wheels in one place" "distance between wheels is 0 m. allowed: at least 0.001"
                 stiffness --wheels 0in 66in 0in)
refuses(track "a folder that cannot be" "cannot be written: Not a directory"
                 stiffness --out /dev/null/x)
add_test(NAME "tool: track stiffness answers"
         COMMAND railbook track stiffness --rail 136RE --tie-spacing 19.5in --ballast-depth 12in
                 --out ${PROJECT_BINARY_DIR}/ctest/track-stiffness)

# Closed form (2): 132RE on 2000 psi is 191 688 lb/in;
# a quarter of it is left at a free joint, 8.3924 MN/m.
add_test(NAME "tool: track stiffness knows equation 2"
         COMMAND railbook track stiffness --foundation-modulus 2000psi --json)
set_tests_properties("tool: track stiffness knows equation 2" PROPERTIES
                     PASS_REGULAR_EXPRESSION "point_stiffness_lbf_per_in\": 191688\\.")
add_test(NAME "tool: track stiffness leaves a quarter at a free joint"
         COMMAND railbook track stiffness --foundation-modulus 2000psi --joint free)
set_tests_properties("tool: track stiffness leaves a quarter at a free joint" PROPERTIES
                     PASS_REGULAR_EXPRESSION "that wheel feels +8\\.392 MN/m")

set(profiles ${PROJECT_SOURCE_DIR}/tests/tools/track)
refuses(track "no speed" "--speed is required"
                 joint --dip 0.5in)
refuses(track "a speed of zero" "speed is 0 m/s. allowed: from 0.1 to 200"
                 joint --speed 0mph --dip 0.5in)
refuses(track "a speed without a unit" "speed is .60., without a unit. allowed: a unit of m/s"
                 joint --speed 60 --dip 0.5in)
refuses(track "no surface" "surface: give one of --dip, --angle and --profile"
                 joint --speed 60mph)
refuses(track "two surfaces" "surface: give one of --dip, --angle and --profile"
                 joint --speed 60mph --dip 0.5in --angle 7mrad)
refuses(track "an angle in inches" "angle is .0.5in., a quantity in m. allowed: a unit of rad"
                 joint --speed 60mph --angle 0.5in)
refuses(track "a negative wheel" "wheel mass is -650 kg. allowed: from 1 to 100000"
                 joint --speed 60mph --dip 0.5in --wheel-mass -650kg)
refuses(track "a negative damping" "bed damping is -1000 N.s/m. allowed: from 0 to 1000000000"
                 joint --speed 60mph --dip 0.5in --bed-damping -1kN*s/m)
refuses(track "a history too short for its peaks" "end of the history is 0.001 s. allowed: at least"
                 joint --speed 60mph --dip 0.5in --duration 1ms)
refuses(track "a tolerance of zero" "tolerance is 0. allowed: from 1e-13 to 0.001"
                 joint --speed 60mph --dip 0.5in --tolerance 0)
refuses(track "a rail lighter than a wire" "rail mass is 1e-09 kg. allowed: from 0.0001 to 1000000"
                 joint --speed 60mph --dip 0.5in --rail-mass 1e-9kg)
refuses(track "a mass that no double holds" "rail mass is .5e-324kg., which a double cannot hold"
                 joint --speed 60mph --dip 0.5in --rail-mass=5e-324kg)
refuses(track "a second sign" "tie spacing is .+-19.5in.. allowed: a finite number"
                 stiffness --tie-spacing +-19.5in)
refuses(track "a raised joint by its dip" "dip is -0.0127 m. allowed: from 0 to 0.2"
                 joint --speed 60mph --dip -0.5in)
refuses(track "a speed beyond all ranges" "speed is 4.4704e+29 m/s. allowed: from 0.1 to 200"
                 joint --speed 1e30mph --dip 0.5in)
refuses(track "a history beyond all memory" "duration is 1000000000 s. allowed: from 0 to 2"
                 joint --speed 60mph --dip 0.5in --duration 1e9s)
refuses(track "a damper beyond all ranges" "bed damping is 1e+200 N.s/m. allowed: from 0 to 1000000000"
                 joint --speed 60mph --dip 0.5in --bed-damping 1e200N*s/m)
refuses(track "a rail length with a profile" "rail length belongs to --dip and --angle. a profile has its own joint"
                 joint --speed 30m/s --profile ${profiles}/hollow.csv --rail-length 39ft)
refuses(track "a profile that begins past the joint" "first distance of the profile is 1 m. allowed: from -10000 to 0"
                 joint --speed 30m/s --profile ${profiles}/late.csv)
refuses(track "a missing profile" ".none.csv.: cannot be read"
                 joint --speed 30m/s --profile none.csv)
refuses(track "a profile that goes back" "profile distance: sample 3 does not lie beyond the one before it"
                 joint --speed 30m/s --profile ${profiles}/backwards.csv)
refuses(track "a profile with a gap" "gap.csv., line 3: column .profile_mm. is empty or NaN. allowed: a"
                 joint --speed 30m/s --profile ${profiles}/gap.csv)
refuses(track "a profile without a unit" "bare.csv.: column .profile. names no unit. allowed: a header that"
                 joint --speed 30m/s --profile ${profiles}/bare.csv)
refuses(track "a profile shorter than the run" "distance at the end of the run .speed times duration. is 3.6 m. allowed: from -1.2 to 3"
                 joint --speed 60m/s --profile ${profiles}/hollow.csv)
add_test(NAME "tool: track joint answers"
         COMMAND railbook track joint --speed 60mph --dip 0.5in --json --out ${PROJECT_BINARY_DIR}/ctest/track-joint)
add_test(NAME "tool: track joint takes a profile"
         COMMAND railbook track joint --speed 30m/s --profile ${profiles}/hollow.csv
                 --out ${PROJECT_BINARY_DIR}/ctest/track-profile)
set_tests_properties("tool: track joint answers" PROPERTIES PASS_REGULAR_EXPRESSION "p1_kN\": 178\\.182")

# passes(WHAT PATTERN arguments...), and the same where no warning may stand.
function(track_says what pattern)
  add_test(NAME "tool: track ${what}" COMMAND railbook track ${ARGN})
  set_tests_properties("tool: track ${what}" PROPERTIES PASS_REGULAR_EXPRESSION ${pattern})
endfunction()
function(track_is_sure_of what)
  add_test(NAME "tool: track is sure of ${what}" COMMAND railbook track ${ARGN})
  set_tests_properties("tool: track is sure of ${what}" PROPERTIES FAIL_REGULAR_EXPRESSION "WARNING|railbook:")
endfunction()
track_says("warns of ties 6 m apart" "WARNING: the ties are too far apart for eq. .2."
           stiffness --tie-spacing 6m)
track_is_sure_of("typical ties" stiffness)
track_says("warns of a coarse joint" "WARNING: the profile's samples are too far apart"
           joint --speed 60mph --profile ${profiles}/coarse.csv)
track_says("warns of a profile of few samples" "WARNING: a profile of 5 samples"
           joint --speed 60mph --profile ${profiles}/few.csv)
track_is_sure_of("a hollow" joint --speed 30m/s --profile ${profiles}/hollow.csv)
track_is_sure_of("a dip" joint --speed 60mph --dip 0.5in)
track_says("carries a rail of a gram" "p1_kN\": 158\\.15.*Radau IIA"
           joint --speed 60mph --dip 0.5in --rail-mass 1g --json)
