# cmake -DRUNS=build/ctest -DCHAPTERS="01-contact;..." -DROOT=... -P whole.cmake
# Weaves the whole book from the records of the tests, into RUNS/whole/book, and holds it to its size.
cmake_minimum_required(VERSION 3.25)
set(most 14500000) # bytes
set(whole ${RUNS}/whole)
file(REMOVE_RECURSE ${whole})
file(MAKE_DIRECTORY ${whole}/results ${whole}/figures)
foreach(chapter ${CHAPTERS})
  file(COPY ${RUNS}/${chapter}/results/ DESTINATION ${whole}/results)
  file(COPY ${RUNS}/${chapter}/figures/ DESTINATION ${whole}/figures)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -DRESULTS=${whole}/results -DFIGURES=${whole}/figures -DBOOK=${whole}/book
                        -DVERSION=test -P ${ROOT}/book/weave.cmake
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE files ${whole}/book/*)
set(bytes 0)
foreach(file ${files})
  file(SIZE ${file} size)
  math(EXPR bytes "${bytes} + ${size}")
endforeach()
message("${bytes} bytes")
if(bytes GREATER most)
  message(FATAL_ERROR "the book has ${bytes} bytes, at most ${most} wanted")
endif()
