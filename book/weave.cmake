# Weaves the book: cmake [-DCHAPTERS=...] [-DRESULTS=...] [-DFIGURES=...] [-DBOOK=...] [-DVERSION=...] -P weave.cmake
# One page for each folder of CHAPTERS that has a record RESULTS/NN-name.json (its CSVs are in RESULTS/NN-name, its
# pictures in FIGURES/NN-name), then the pages made of all records. The folder BOOK is replaced at the end, as a whole; it
# needs nothing outside itself. Exits non-zero when a page cannot be woven; the others are there all the same, and when none can
# be, the book stays what it was.

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
foreach(default CHAPTERS=${root}/chapters RESULTS=${root}/build/results FIGURES=${root}/build/figures
        BOOK=${root}/build/book ROOT=${root})
  string(REGEX MATCH "^([A-Z]+)=(.*)$" _ ${default})
  if(NOT ${CMAKE_MATCH_1})
    set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endif()
  get_filename_component(${CMAKE_MATCH_1} ${${CMAKE_MATCH_1}} ABSOLUTE)
endforeach()
find_program(PANDOC pandoc REQUIRED)

set(time_limit 300) # seconds; a page takes some 5
if(TIME_LIMIT)
  set(time_limit ${TIME_LIMIT})
endif()

set(here ${CMAKE_CURRENT_LIST_DIR})
set(new ${BOOK}.unfinished)
file(REMOVE_RECURSE ${new})
file(MAKE_DIRECTORY ${new}/data ${new}/figures)
file(COPY ${here}/book.css ${here}/book.js ${here}/find.js ${here}/icon.svg ${here}/fonts DESTINATION ${new})
file(GLOB live ${here}/live/*.js) # figures that compute
file(COPY ${live} DESTINATION ${new}/live)
file(GLOB shared_scripts ${root}/lib/*/*.gp) # the look of all figures, and scripts that several chapters use
file(COPY ${shared_scripts} DESTINATION ${new}/data)
set(page_options --template=${here}/template.html --to=html5 --mathml --fail-if-warnings --standalone --wrap=none --no-highlight
    -V version=${VERSION})

file(GLOB drawings ${root}/docs/pictures/*.svg) # of the page Tools
file(COPY ${drawings} DESTINATION ${new}/figures/tools)

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
set(chapter_list)
foreach(chapter ${chapters})
  set(study)
  if(EXISTS ${CHAPTERS}/${chapter}/study/study.cpp)
    set(study study)
  endif()
  list(APPEND chapter_list -M "chapters=${chapter}|${title_${chapter}}|${study}")
endforeach()
set(parts ${new}.parts) # what the pages of the chapters leave for the pages made of all
file(REMOVE_RECURSE ${parts})
file(MAKE_DIRECTORY ${parts})
foreach(chapter ${chapters})
  set(around -M chapter=${chapter} ${chapter_list} -M parts=${parts})

  file(GLOB data ${RESULTS}/${chapter}/*.csv ${CHAPTERS}/${chapter}/*.gp ${CHAPTERS}/${chapter}/study/*.gp)
  file(GLOB pictures ${FIGURES}/${chapter}/*.png ${FIGURES}/${chapter}/*.svg)
  foreach(svg ${pictures}) # what there is as SVG is not needed twice
    string(REGEX REPLACE "\\.svg$" ".png" png ${svg})
    if(NOT png STREQUAL svg)
      list(REMOVE_ITEM pictures ${png})
    endif()
  endforeach()
  file(COPY ${data} DESTINATION ${new}/data/${chapter})
  file(COPY ${pictures} DESTINATION ${new}/figures/${chapter})
  file(READ ${RESULTS}/${chapter}.json json)
  string(REGEX REPLACE "\n *" "" json "${json}") # a text in it has no line end of its own
  string(REGEX REPLACE "([{,]) *\"([a-z_0-9]+)\": " "\\1\"\\2\":" json "${json}")
  file(WRITE ${new}/data/${chapter}.json "${json}")
  file(GLOB printed RELATIVE ${CHAPTERS}/${chapter}/data ${CHAPTERS}/${chapter}/data/*)
  foreach(name ${printed})
    file(COPY ${CHAPTERS}/${chapter}/data/${name} DESTINATION ${new}/data/${chapter}/printed)
    if(NOT name MATCHES "^(symbols|claims|words|trials|inventory|so-what|causes)\\.csv$") # they are on the page, and not printed by the paper
      list(APPEND around -M printed=${name})
    endif()
  endforeach()
  # The chapter's first page, and its second, the files of study/ with study.cpp first; both at the same time.
  set(commands)
  foreach(page paper study)
    if(page STREQUAL paper)
      set(folder ${CHAPTERS}/${chapter})
      set(main ${folder}/main.cpp)
      set(output ${chapter})
    else()
      set(folder ${CHAPTERS}/${chapter}/study)
      set(main ${folder}/study.cpp)
      set(output ${chapter}-study)
    endif()
    if(NOT EXISTS ${main})
      continue()
    endif()
    file(GLOB sources ${folder}/*.cpp ${folder}/*.hpp)
    list(REMOVE_ITEM sources ${main})
    set(study)
    if(EXISTS ${CHAPTERS}/${chapter}/study/study.cpp)
      set(study -M study=${chapter}-study)
    endif()
    list(APPEND commands
         COMMAND ${CMAKE_COMMAND} -E env RAILBOOK_LIB=${ROOT}/lib
                 ${PANDOC} --from=${here}/literate.lua --lua-filter=${here}/results.lua ${page_options} --toc --toc-depth=2
                 ${around} ${study} -M record=${RESULTS}/${chapter}.json -M figures=${FIGURES}/${chapter} -M part=${page}
                 -M data=${new}/data/${chapter} --output=${new}/${output}.html ${main} ${sources})
  endforeach()
  execute_process(${commands} RESULTS_VARIABLE statuses ERROR_VARIABLE said TIMEOUT ${time_limit})
  list(TRANSFORM statuses STRIP)
  list(REMOVE_ITEM statuses 0)
  if(NOT statuses)
    message("${chapter}  ${BOOK}/${chapter}.html")
    list(APPEND records -M record=${RESULTS}/${chapter}.json)
  else()
    file(REMOVE ${new}/${chapter}.html ${new}/${chapter}-study.html)
    message("${chapter}  FAILED: ${statuses}\n${said}")
    list(APPEND failed ${chapter})
    list(APPEND left_out "-M;left-out=${chapter} could not be woven: see the messages of the build")
  endif()
endforeach()

# The pages made of all records.
file(GLOB headers ${ROOT}/lib/*/*.hpp)
list(TRANSFORM headers PREPEND "-M;header=")
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env RAILBOOK_ROOT=${ROOT}
          ${PANDOC} --from=markdown-citations --lua-filter=${here}/index.lua ${page_options} ${records} ${left_out}
          ${chapter_list} ${headers} -M parts=${parts} -M book=${new} -M figures=${FIGURES} -M page=index -M version=${VERSION}
          -M "title=railbook: papers on wheel, rail and track, recomputed" -M "pagetitle=railbook: papers on wheel, rail and track, recomputed" -M front=yes
          --output=${new}/index.html ${here}/index.md
  TIMEOUT ${time_limit} RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status EQUAL 0)
  message("index  FAILED: ${status}\n${said}")
  list(APPEND failed index)
endif()
file(REMOVE_RECURSE ${parts})
if(EXISTS ${new}/search.json) # packed, as a script, which a page from disk can load
  execute_process(COMMAND gzip -9nc ${new}/search.json COMMAND base64 -w 0 OUTPUT_VARIABLE packed COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${new}/search.js "railbookSearch(\"${packed}\");\n")
  file(REMOVE ${new}/search.json)
endif()

if(NOT EXISTS ${new}/index.html AND NOT records) # no page at all: pandoc itself; the book of before stays
  file(REMOVE_RECURSE ${new})
  message(FATAL_ERROR "The book could not be woven: ${failed}")
endif()

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
