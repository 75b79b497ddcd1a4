# What names, files and the world outside may do to the tools.
set(here ${CMAKE_CURRENT_SOURCE_DIR})
set(examples ${PROJECT_SOURCE_DIR}/tools/examples)
function(names kind subject verb record)
  add_test(NAME "tool: ${subject} ${verb} takes any name (${kind})" COMMAND ${CMAKE_COMMAND} -E env RECORD=${record}
           ${here}/names.sh ${kind} ${bin} ${subject} ${verb} ${ARGN})
  set_tests_properties("tool: ${subject} ${verb} takes any name (${kind})" PROPERTIES SKIP_RETURN_CODE 77)
  if(NOT verb STREQUAL limit) # which meets the most names
    set_tests_properties("tool: ${subject} ${verb} takes any name (${kind})" PROPERTIES LABELS thorough)
  endif()
endfunction()
names(out contact solve "" --body-1-radius-across 0.3m --body-2-radius-along 0.46m --load 3kN --cells-x 32 --cells-y 32)
names(in contact solve ${examples}/contact/rail.csv --body-1-profile @ --body-2-radius-along 1m --load 3kN --cells-x 32 --cells-y 32)
names(out creep curve "" --a 6mm --b 4mm --load 80kN --points 3)
names(out creep history "" ${PROJECT_SOURCE_DIR}/tools/examples/creep/braking.csv --a 6mm --b 4mm --load 80kN --cells 8)
names(out creep table "" --ratios 2 --longitudinal 4 --lateral 4 --spin 3 --points 10)
names(out hunting geometry "")
names(in hunting geometry ${examples}/hunting/worn-wheel.csv --wheel @ --rail ${examples}/hunting/new-rail.csv --noise 0.003mm)
names(out hunting speed "")
names(out hunting cycle "" --pair cn --speed 132ft/s --largest-amplitude 8mm)
names(out filters simulate "" --length 1000ft)
names(in filters integrate ${examples}/filters/axlebox.csv --speed-column speed @)
names(in filters process ${PROJECT_BINARY_DIR}/ctest/filters-sensors.csv --config ${examples}/filters/car.toml @)
names(file psd synthesize "" --length 1km)
names(in psd classify ${PROJECT_BINARY_DIR}/ctest/psd-track.csv @)
names(out quality limit "" --speed 100km/h)
names(in quality index ${examples}/quality/track.csv --column crosslevel --speed 100km/h @)
names(out wheelrail contact "" --load 50kN --speed 30m/s --method strips)
names(in wheelrail measure ${examples}/hunting/worn-wheel.csv @)
names(out track stiffness "")
names(out track joint "" --speed 60mph --dip 0.5in)
names(in track joint ${here}/track/hollow.csv --speed 30m/s --profile @)
set_tests_properties("tool: filters process takes any name (in)" PROPERTIES FIXTURES_REQUIRED filters-record)
set_tests_properties("tool: psd classify takes any name (in)" PROPERTIES FIXTURES_REQUIRED psd-track)

foreach(case "a full pipe" "a closed standard output" "a reader that goes away" "a size limit"
        "a disk that cannot be read" "an interrupt in mid-write" "an end in mid-write" "a kill in mid-write" "an end while gnuplot draws" "an interrupt while answers are written"
        "a folder that is read-only" "a folder that is not there" "another folder, language and time zone"
        "a FIFO of options" "a FIFO that nobody writes to" "a disk that is full" "a gnuplot that hangs" "a gnuplot that fails" "no gnuplot" "a folder for temporary files that is not there")
  add_test(NAME "tool: ${case}" COMMAND ${here}/outside.sh ${case} ${bin} ${examples}/quality/track.csv)
  set_tests_properties("tool: ${case}" PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
set_tests_properties("tool: a FIFO that nobody writes to" PROPERTIES LABELS thorough) # it is waited for

# Many records, and what is typed wrong.
add_test(NAME "tool: many records make a table" COMMAND ${here}/batch.sh ${bin} ${PROJECT_SOURCE_DIR}/tools/examples)
add_test(NAME "tool: a person's habits" COMMAND ${here}/habits.sh ${bin})
add_test(NAME "tool: words on stability and convergence are read by tests" COMMAND ${here}/words.sh ${PROJECT_SOURCE_DIR})
add_test(NAME "tool: columns of tables are explained by --help" COMMAND ${here}/columns.sh ${PROJECT_SOURCE_DIR} ${bin})
add_test(NAME "tool: forty examples" COMMAND ${here}/examples.sh ${bin} ${examples})
add_test(NAME "tool: quality measures find exceptions to FRA classes where they are" COMMAND ${here}/exceptions.sh ${bin})
add_test(NAME "tool: quality measures judge by a file of limits" COMMAND ${here}/limits.sh ${bin} ${PROJECT_SOURCE_DIR}/tools/quality/fra-49-cfr-213.csv)
add_test(NAME "tool: memory does not grow with the record" COMMAND ${here}/memory.sh ${bin})
set_tests_properties("tool: memory does not grow with the record" PROPERTIES SKIP_RETURN_CODE 77 LABELS thorough)
add_test(NAME "tool: records keep their defects, and all columns are looked at" COMMAND ${here}/records.sh ${bin})
add_test(NAME "tool: clean profiles raise no warning" COMMAND ${here}/clean_profiles.sh ${bin})
add_test(NAME "tool: psd classify reads files as recorders write them" COMMAND ${here}/files.sh ${bin})
add_test(NAME "tool: hostile and clumsy inputs" COMMAND ${here}/hostile.sh ${bin} ${examples})
set_tests_properties("tool: hostile and clumsy inputs" PROPERTIES TIMEOUT 300) # for one that waits: its processors' time is limited

add_test(NAME "tool: verify meets its reference numbers, and no changed one"
         COMMAND ${here}/verify.sh ${bin} ${PROJECT_SOURCE_DIR}/tools/verify/data)
find_package(Python3 COMPONENTS Interpreter QUIET)
if(Python3_Interpreter_FOUND)
  execute_process(COMMAND ${Python3_EXECUTABLE} -c "import mpmath" RESULT_VARIABLE without ERROR_QUIET)
  if(NOT without)
    add_test(NAME "reference: the numbers of verify are those of 40 digits"
             COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tests/reference/verify.py --check)
  endif()
endif()

add_test(NAME "readme: its commands on data of one's own" COMMAND ${here}/readme.sh ${PROJECT_SOURCE_DIR} ${bin})
set_tests_properties("readme: its commands on data of one's own" PROPERTIES LABELS long)
add_test(NAME "docs: the commands answer as docs/commands.md shows" COMMAND ${here}/commands.sh ${PROJECT_SOURCE_DIR} ${bin})
set_tests_properties("docs: the commands answer as docs/commands.md shows" PROPERTIES LABELS long)

# A page of a chapter that shows commands has their real answers.
file(GLOB mains CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/*/main.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${mains})
foreach(main ${mains})
  file(STRINGS ${main} commands REGEX "^```console$")
  if(commands)
    get_filename_component(chapter ${main} DIRECTORY)
    get_filename_component(chapter ${chapter} NAME)
    add_test(NAME "page: the commands of ${chapter}" COMMAND ${here}/page.sh ${PROJECT_SOURCE_DIR} ${chapter} ${bin}
             ${PROJECT_BINARY_DIR}/ctest/page-${chapter})
  endif()
endforeach()

# What cannot be drawn is left out of a figure: a curve of one point, a sensor that gave nothing.
add_test(NAME "tool: creep curve of one point" COMMAND railbook creep curve --a 6mm --b 4mm --load 80kN --points 1
         --out ${PROJECT_BINARY_DIR}/ctest/creep-point)
add_test(NAME "tool: filters process without a sensor" COMMAND sh -c "awk -F, -v OFS=, 'NR>1{$3=\"nan\"} 1' $1 > $2 && $0 filters process $2 --out $3"
         ${bin} ${PROJECT_BINARY_DIR}/ctest/filters-sensors.csv ${PROJECT_BINARY_DIR}/ctest/filters-dead.csv ${PROJECT_BINARY_DIR}/ctest/filters-dead)
set_tests_properties("tool: filters process without a sensor" PROPERTIES FIXTURES_REQUIRED filters-record)
# Without figures gnuplot is not asked; with them and no gnuplot the answer would be refused.
add_test(NAME "tool: track stiffness without figures" COMMAND ${CMAKE_COMMAND} -E env RAILBOOK_GNUPLOT=/none
         ${bin} track stiffness --no-figures --out ${PROJECT_BINARY_DIR}/ctest/track-plain)

foreach(subject hunting track contact creep filters psd quality wheelrail)
  add_test(NAME "tool: ${subject} tables say what the answers say" COMMAND ${here}/tables.sh ${subject} ${bin})
  add_test(NAME "tool: ${subject} refuses what is outside of its options' ranges" COMMAND ${here}/ranges.sh ${subject} ${bin})
endforeach()
add_test(NAME "tool: hunting cycles keep the laws of branches" COMMAND ${here}/tables.sh hunting ${bin} hunting-cycles)
set_tests_properties("tool: hunting cycles keep the laws of branches" PROPERTIES LABELS long)
