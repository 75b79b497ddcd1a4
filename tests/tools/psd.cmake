# The tools refuse what they cannot use with exit status 2, for the reason expected and not for another.
set(folder ${PROJECT_BINARY_DIR}/ctest)
file(MAKE_DIRECTORY ${folder})
set(never ${folder}/psd-never.csv)
set(bad ${PROJECT_SOURCE_DIR}/tests/tools/psd)
refuses(psd "a dip without a unit" "dip is .11., without a unit" synthesize ${never} --dip 11)
refuses(psd "a roughness in metres squared" "roughness is .* in m^2" synthesize ${never} --roughness 5e-7m^2)
refuses(psd "a negative roughness" "roughness is -1e-07 m.*allowed: from 0 to 1" synthesize ${never} --roughness -1e-7m)
refuses(psd "a corner of zero" "corner is 0 1/m.*allowed" synthesize ${never} --corner 0cycle/m)
refuses(psd "more gaps than track" "gaps is 0.99.*allowed" synthesize ${never} --gaps 99%)
refuses(psd "a length below the spacing" "length over spacing is 0.003.*allowed: from 1 to 1000000000" synthesize ${never} --length 1mm)
refuses(psd "rails shorter than two samples" "rail length is 0.3048 m.*allowed" synthesize ${never} --dip 1mm --rail 1ft)
refuses(psd "samples nearer than a millimetre" "spacing is 7e-12 m. allowed: from 0.001" synthesize ${never} --spacing 7e-12m)
refuses(psd "samples that divide to infinity" "spacing is 1e-300 m. allowed: from 0.001" synthesize ${never} --spacing 1e-300m)
refuses(psd "a record of 1e12 samples" "length over spacing is 1e+1[12]" synthesize ${never} --length 1e9m --spacing 1mm)
refuses(psd "a rail of atoms" "rail is 1e-300 m. allowed" classify ${never} --rail 1e-300m)
refuses(psd "half a sample to bridge" "bridge is 2.5. allowed: a whole number" classify ${never} --bridge 2.5)
refuses(psd "a segment of a sample" "segment over the spacing is 3.33.*allowed: from 64" roughness ${bad}/short.csv --segment 1m)
refuses(psd "a wheel of a hair" "wheel radius is 0.0001 m. allowed" roughness ${bad}/short.csv --wheel-radius 0.1mm)
refuses(psd "roughness of too few samples" "a spectrum needs 64 in a row" roughness ${bad}/short.csv)
refuses(psd "a folder that is not there" "cannot be written" synthesize ${folder}/none/such/track.csv)
refuses(psd "a record that is not there" "none.csv.: cannot be read" classify ${folder}/none.csv)
refuses(psd "positions that go back" "positions do not ascend" classify ${bad}/descending.csv)
refuses(psd "positions not evenly spaced" "not evenly spaced: 0.6" classify ${bad}/uneven.csv)
refuses(psd "positions against the spacing" "spacing is given as 0.3048" classify ${bad}/short.csv --spacing 1ft)
refuses(psd "a constant signal" "constant signal: all samples are 0.007" classify ${bad}/constant.csv)
refuses(psd "a record shorter than a segment" "has 4 samples, 0 of them missing.*allowed: [0-9]* in a row" classify ${bad}/short.csv)
refuses(psd "a cell that is no number" "line 3: column .profile_mm. is .two." classify ${bad}/text.csv)
refuses(psd "a record of gaps" "no finite sample" classify ${bad}/missing.csv)
refuses(psd "a record of no rows" "no finite sample" classify ${bad}/header.csv)
refuses(psd "a column that is not there" "no column .height..*there are" classify ${bad}/short.csv --column height)
refuses(psd "a column without a unit" "names no unit.*give one with --unit" classify ${bad}/bare.csv --spacing 1ft)
refuses(psd "a record without positions or spacing" "no column .distance.*--spacing" classify ${bad}/bare.csv --unit mm)
refuses(psd "a profile in kilograms" "has the unit kg.*allowed: a length" classify ${bad}/mass.csv)
refuses(psd "two units for a column" "in mm by its header, in ft by --unit" classify ${bad}/short.csv --unit ft)
refuses(psd "a rail without a unit" "rail is .39., without a unit" classify ${bad}/short.csv --rail 39)
refuses(psd "a unit nobody knows" "unit .furlong" classify ${bad}/bare.csv --spacing 1ft --unit furlong)
refuses(psd "heights out of this world" "sample 2 is 1e+97 m.*allowed" classify ${bad}/huge.csv)
refuses(psd "a distance without a unit" "column .distance. names no length" classify ${bad}/distance.csv)
refuses(psd "a row of too many cells" "line 3: 3 cells.*allowed: 2" classify ${bad}/ragged.csv)
refuses(psd "a negative spacing" "spacing is -0.3048 m.*allowed" classify ${bad}/bare.csv --unit mm --spacing -1ft)
refuses(psd "an odd segment" "segment of 65 samples.*allowed: even" classify ${bad}/short.csv --segment 65)
refuses(psd "a window nobody knows" "window is .hat..*allowed" classify ${bad}/short.csv --window hat)
refuses(psd "an option nobody knows" "not expected: --spacng" classify ${bad}/short.csv --config ${bad}/unknown.toml)
refuses(psd "a folder for a record" "cannot be written" synthesize ${folder} --length 1km)

# A record made to order comes back as ordered: zone 7, class 5.
add_test(NAME "tool: psd synthesizes a record"
         COMMAND railbook psd synthesize ${folder}/psd-track.csv --length 50km --roughness 5e-7m^2*cycle/m
                 --corner 0.13cycle/m --dip 11mm --gaps 0.1%)
add_test(NAME "tool: psd classifies it" COMMAND railbook psd classify ${folder}/psd-track.csv --out ${folder}/psd-mine)
set_tests_properties("tool: psd synthesizes a record" PROPERTIES FIXTURES_SETUP psd-track)
set_tests_properties("tool: psd classifies it" PROPERTIES FIXTURES_REQUIRED psd-track
                     PASS_REGULAR_EXPRESSION "roughness A +(4\\.[89]|5\\.[012]).*class +5 ")
function(psd_refuses_track what)
  refuses(psd ${what} ${ARGN})
  set_tests_properties("tool: psd refuses ${what}" PROPERTIES FIXTURES_REQUIRED psd-track)
endfunction()
psd_refuses_track("a chord longer than the record" "chord .* is 100000 m.*allowed" classify ${folder}/psd-track.csv --chord 100km)
psd_refuses_track("a chord blind to the rail" "does not see a rail" classify ${folder}/psd-track.csv --chord 78ft)
psd_refuses_track("old rails with the line of the new" "have a line on that of the rail" classify ${folder}/psd-track.csv --foreign 78ft)
psd_refuses_track("results in a file's place" "cannot be written" classify ${folder}/psd-track.csv --out ${folder}/psd-track.csv)

# A profile passed off as chord offsets causes a warning, gets no class, and is drawn with the blind places left out.
add_test(NAME "tool: psd warns of a profile passed off as a chord's record"
         COMMAND railbook psd classify ${folder}/psd-track.csv --chord 62ft --out ${folder}/psd-chord)
set_tests_properties("tool: psd warns of a profile passed off as a chord's record" PROPERTIES
                     FIXTURES_REQUIRED psd-track PASS_REGULAR_EXPRESSION "WARNING: residuals [0-9.]+ times.*class +none")

# Rails of 25 m are seen, and taken instead of the default; they contradict one that is named.
add_test(NAME "tool: psd synthesizes long rails" COMMAND railbook psd synthesize ${folder}/psd-25m.csv --rail 25m
         --length 20km --spacing 25cm --roughness 5e-7m^2*cycle/m --corner 0.13cycle/m --dip 11mm)
add_test(NAME "tool: psd sees long rails" COMMAND railbook psd classify ${folder}/psd-25m.csv)
add_test(NAME "tool: psd warns of the rails named" COMMAND railbook psd classify ${folder}/psd-25m.csv --rail 39ft)
set_tests_properties("tool: psd synthesizes long rails" PROPERTIES FIXTURES_SETUP psd-25m)
set_tests_properties("tool: psd sees long rails" PROPERTIES FIXTURES_REQUIRED psd-25m PASS_REGULAR_EXPRESSION
                     "WARNING: the spectrum shows rails of (24\\.9|25\\.|25 m).*class +4 ")
set_tests_properties("tool: psd warns of the rails named" PROPERTIES FIXTURES_REQUIRED psd-25m
                     PASS_REGULAR_EXPRESSION "WARNING: the spectrum shows rails of .*not of 11\\.89 m")
add_test(NAME "tool: quality refuses a spacing that the positions contradict" COMMAND
         ${CMAKE_CURRENT_SOURCE_DIR}/refuses.sh "spacing is given as 1 m, but the positions are 0.25" ${bin} quality
         index ${folder}/psd-25m.csv --speed 100km/h --spacing 1m)
set_tests_properties("tool: quality refuses a spacing that the positions contradict" PROPERTIES FIXTURES_REQUIRED psd-25m)
