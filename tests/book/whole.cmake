# cmake -DRUNS=build/ctest -DCHAPTERS="01-contact;..." -DROOT=... -P whole.cmake
# Weaves the whole book from the records of the tests, into RUNS/whole/book, and holds it to its size.
cmake_minimum_required(VERSION 3.25)
set(most 12000000) # bytes
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

# The front page: a card for each chapter, a mark for each number that a paper prints, and not much to read. The book was woven, so that each
# link and value of it is there.
list(LENGTH CHAPTERS wanted)
file(READ ${whole}/book/index.html front)
string(REGEX MATCH "<main.*</main>" front "${front}")
string(REPLACE ";" "," front "${front}") # a list has its own
string(REGEX MATCHALL "<svg viewBox=\"0 0 240 150\"" cards "${front}")
list(LENGTH cards cards)
set(printed 0)
foreach(chapter ${CHAPTERS})
  file(READ ${whole}/results/${chapter}.json json)
  string(REGEX MATCHALL "\"source\": \"print\"" found "${json}")
  list(LENGTH found found)
  math(EXPR printed "${printed} + ${found}")
endforeach()
string(REGEX MATCHALL "<title>[^<]*: printed " marks "${front}")
list(LENGTH marks marks)
string(REGEX REPLACE "<style.*</style>|<title>[^<]*</title>|<[^>]*>" " " words "${front}")
string(REGEX MATCHALL "[^ \n]+" words "${words}")
list(LENGTH words words)
message("front page: ${cards} cards, ${marks} marks, ${words} words")
if(NOT cards EQUAL wanted OR NOT marks EQUAL printed OR words GREATER 580)
  message(FATAL_ERROR "wanted: ${wanted} cards, ${printed} marks, at most 580 words, those in pictures among them")
endif()
