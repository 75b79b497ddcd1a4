# cmake [-DBUILD=build] [-DCHAPTERS=NN-name;...] -P cmake/accept_figures.cmake
# Runs the chapters, not timed (all, or those named), and makes what they draw the golden set, each in its own folder
# figures/NN-name and nowhere else. A chapter that fails is not accepted. Look at the pictures before you commit them.
cmake_minimum_required(VERSION 3.25)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
if(NOT BUILD)
  set(BUILD ${root}/build)
endif()
get_filename_component(BUILD ${BUILD} ABSOLUTE)
set(recorded ${root}/figures/environment.txt)
set(here ${BUILD}/environment.txt)
if(NOT CHAPTERS)
  file(GLOB CHAPTERS RELATIVE ${root}/chapters ${root}/chapters/[0-9][0-9]-*)
  file(COPY_FILE ${here} ${recorded} ONLY_IF_DIFFERENT) # all pictures are made here now
endif()

set(failed)
foreach(chapter ${CHAPTERS})
  string(REGEX REPLACE "^[0-9]+-" "" program ${chapter})
  execute_process(COMMAND ${BUILD}/bin/${program} reproduce --no-timings --out ${BUILD}/ctest/${chapter}
                  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE status)
  if(status EQUAL 0)
    execute_process(COMMAND ${BUILD}/bin/figure_diff accept ${BUILD}/ctest/${chapter} ${root}/figures/${chapter}
                            ${recorded} ${here} RESULT_VARIABLE status)
  else()
    message("${said}")
  endif()
  if(NOT status EQUAL 0)
    message("${chapter}  not accepted: it fails")
    list(APPEND failed ${chapter})
  endif()
endforeach()
if(failed)
  message(FATAL_ERROR "Not accepted: ${failed}")
endif()
