# The target `reproduce`: the chapters that something has changed for, then the book.
set(RAILBOOK_LEVEL quick CACHE STRING "What the target `reproduce` runs the chapters at: quick or full")

# railbook_reproduce(NN-NAME NAME): the record build/results/NN-NAME.json from the chapter in the calling folder, made again when
# its program, what it reads or the level is another. A program that was linked again to the same bytes is the same.
function(railbook_reproduce chapter name)
  set(program ${PROJECT_BINARY_DIR}/results/programs/${name})
  add_custom_command(OUTPUT ${program}.linked BYPRODUCTS ${program} DEPENDS ${name} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E copy_if_different $<TARGET_FILE:${name}> ${program}
    COMMAND ${CMAKE_COMMAND} -E touch ${program}.linked
    COMMENT "Comparing ${name} with the program that was run last")
  file(GLOB_RECURSE reads CONFIGURE_DEPENDS data/* *.gp ${PROJECT_SOURCE_DIR}/lib/*.gp)
  set(record ${PROJECT_BINARY_DIR}/results/${chapter}.json)
  add_custom_command(OUTPUT ${record} DEPENDS ${program} ${reads} VERBATIM
    COMMAND $<TARGET_FILE:${name}> reproduce --level ${RAILBOOK_LEVEL} --out ${PROJECT_BINARY_DIR}
    COMMAND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/chapter_stamp.sh ${PROJECT_BINARY_DIR} ${chapter} ${RAILBOOK_LEVEL} >
            ${PROJECT_BINARY_DIR}/results/${chapter}.stamp
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Running chapter ${chapter}")
  add_custom_target(record-${name} DEPENDS ${program}.linked ${record})
  add_dependencies(record-${name} chapter_programs) # time is measured: nothing is compiled beside it
  set_property(GLOBAL APPEND PROPERTY RAILBOOK_RECORDS ${record})
  set_property(GLOBAL APPEND PROPERTY RAILBOOK_RECORD_TARGETS record-${name})
endfunction()

# railbook_reproduce_book(COMMAND...): the target, after all chapters; the command weaves the book when anything of it has changed.
function(railbook_reproduce_book)
  get_property(records GLOBAL PROPERTY RAILBOOK_RECORDS)
  get_property(targets GLOBAL PROPERTY RAILBOOK_RECORD_TARGETS)
  if(NOT records)
    return()
  endif()
  set(all ${PROJECT_SOURCE_DIR})
  file(GLOB_RECURSE woven CONFIGURE_DEPENDS ${all}/chapters/* ${all}/lib/* ${all}/docs/* ${all}/book/* ${all}/README.md ${all}/tests/*.csv)
  set(done ${PROJECT_BINARY_DIR}/results/book.woven)
  add_custom_command(OUTPUT ${done} DEPENDS ${records} ${woven} VERBATIM COMMAND ${ARGN} COMMAND ${CMAKE_COMMAND} -E touch ${done}
                     COMMENT "Weaving the book")
  add_custom_target(reproduce DEPENDS ${done})
  add_dependencies(reproduce ${targets})
endfunction()
