# Weaves the book: cmake [-DCHAPTERS=...] [-DRESULTS=...] [-DFIGURES=...] [-DBOOK=...] [-DVERSION=...] -P weave.cmake
# One page for each folder of CHAPTERS that has a record RESULTS/NN-name.json (its CSVs are in RESULTS/NN-name, its
# PNGs in FIGURES/NN-name), then the contents and the gallery. The folder BOOK is replaced at the end, as a whole; it
# needs nothing outside itself. Exits non-zero when a page cannot be woven; the others are there all the same.

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
foreach(default CHAPTERS=${root}/chapters RESULTS=${root}/build/results FIGURES=${root}/build/figures
        BOOK=${root}/build/book)
  string(REGEX MATCH "^([A-Z]+)=(.*)$" _ ${default})
  if(NOT ${CMAKE_MATCH_1})
    set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endif()
  get_filename_component(${CMAKE_MATCH_1} ${${CMAKE_MATCH_1}} ABSOLUTE)
endforeach()
find_program(PANDOC pandoc REQUIRED)

set(time_limit 300) # seconds; a page takes some 5

set(here ${CMAKE_CURRENT_LIST_DIR})
set(new ${BOOK}.unfinished)
file(REMOVE_RECURSE ${new})
file(MAKE_DIRECTORY ${new}/data ${new}/figures)
file(COPY ${here}/book.css DESTINATION ${new})
file(GLOB shared_scripts ${root}/lib/*/*.gp) # the look of all figures, and scripts that several chapters use
file(COPY ${shared_scripts} DESTINATION ${new}/data)
set(page_options --template=${here}/template.html --to=html5 --mathml --fail-if-warnings --standalone --wrap=none
    --highlight-style=kate -V version=${VERSION})

file(GLOB folders RELATIVE ${CHAPTERS} ${CHAPTERS}/[0-9][0-9]-*)
list(SORT folders)
set(chapters)
set(left_out)
foreach(chapter ${folders})
  if(EXISTS ${RESULTS}/${chapter}.json)
    file(READ ${RESULTS}/${chapter}.json json)
    string(JSON title_${chapter} ERROR_VARIABLE none GET "${json}" title)
    if(none)
      set(title_${chapter} ${chapter})
    endif()
    list(APPEND chapters ${chapter})
  elseif(EXISTS ${CHAPTERS}/${chapter}/main.cpp)
    list(APPEND left_out "-M;left-out=${chapter} has not been run: there is no record")
    message("${chapter}  no record, left out")
  endif()
endforeach()

set(failed)
set(records)
list(LENGTH chapters count)
set(i 0)
foreach(chapter ${chapters})
  set(around -M chapter=${chapter})
  math(EXPR before "${i} - 1")
  math(EXPR i "${i} + 1")
  if(before GREATER_EQUAL 0)
    list(GET chapters ${before} name)
    list(APPEND around -V prev=${name} -M "prev-title=${title_${name}}")
  endif()
  if(i LESS count)
    list(GET chapters ${i} name)
    list(APPEND around -V next=${name} -M "next-title=${title_${name}}")
  endif()

  file(GLOB data ${RESULTS}/${chapter}/*.csv ${CHAPTERS}/${chapter}/*.gp)
  file(GLOB pngs ${FIGURES}/${chapter}/*.png)
  file(COPY ${data} DESTINATION ${new}/data/${chapter})
  file(COPY ${pngs} DESTINATION ${new}/figures/${chapter})
  file(COPY ${RESULTS}/${chapter}.json DESTINATION ${new}/data)
  file(GLOB printed RELATIVE ${CHAPTERS}/${chapter}/data ${CHAPTERS}/${chapter}/data/*)
  foreach(name ${printed})
    file(COPY ${CHAPTERS}/${chapter}/data/${name} DESTINATION ${new}/data/${chapter}/printed)
    list(APPEND around -M printed=${name})
  endforeach()
  file(GLOB sources ${CHAPTERS}/${chapter}/*.cpp ${CHAPTERS}/${chapter}/*.hpp)
  list(REMOVE_ITEM sources ${CHAPTERS}/${chapter}/main.cpp)
  execute_process(
    COMMAND ${PANDOC} --from=${here}/literate.lua --lua-filter=${here}/results.lua ${page_options} --toc --toc-depth=2
            ${around} -M record=${RESULTS}/${chapter}.json -M figures=${FIGURES}/${chapter}
            -M data=${new}/data/${chapter} --output=${new}/${chapter}.html ${CHAPTERS}/${chapter}/main.cpp ${sources}
    TIMEOUT ${time_limit} RESULT_VARIABLE status ERROR_VARIABLE said)
  if(status EQUAL 0)
    message("${chapter}  ${BOOK}/${chapter}.html")
    list(APPEND records -M record=${RESULTS}/${chapter}.json)
  else()
    file(REMOVE ${new}/${chapter}.html)
    message("${chapter}  FAILED: ${status}\n${said}")
    list(APPEND failed ${chapter})
    list(APPEND left_out "-M;left-out=${chapter} could not be woven: see the messages of the build")
  endif()
endforeach()

foreach(page "index=railbook: papers on wheel, rail and track, recomputed" "gallery=Gallery")
  string(REGEX MATCH "^([a-z]+)=(.*)$" _ ${page})
  execute_process(
    COMMAND ${PANDOC} --from=markdown-citations --lua-filter=${here}/index.lua ${page_options} ${records} ${left_out}
            -V page=index -M "title=${CMAKE_MATCH_2}" -M "pagetitle=${CMAKE_MATCH_2}"
            --output=${new}/${CMAKE_MATCH_1}.html ${here}/${CMAKE_MATCH_1}.md
    TIMEOUT ${time_limit} RESULT_VARIABLE status ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message("${CMAKE_MATCH_1}  FAILED: ${status}\n${said}")
    list(APPEND failed ${CMAKE_MATCH_1})
  endif()
endforeach()

file(REMOVE_RECURSE ${BOOK}.old)
if(EXISTS ${BOOK})
  file(RENAME ${BOOK} ${BOOK}.old)
endif()
file(RENAME ${new} ${BOOK})
file(REMOVE_RECURSE ${BOOK}.old)
if(failed)
  message(FATAL_ERROR "The book could not be woven: ${failed}")
endif()
message("${BOOK}/index.html")
