# Sets $SOURCE_DATE_EPOCH, the time that all files of a package bear, to that of the commit, so that two builders make the same
# package. A tree without git has the time of its files.
get_filename_component(tree ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
if("$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
  set(time "")
  if(EXISTS ${tree}/.git)
    execute_process(COMMAND git -c safe.directory=* -C ${tree} log -1 --format=%ct OUTPUT_VARIABLE time
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  if(NOT time MATCHES "^[0-9]+$")
    file(TIMESTAMP ${tree}/CHANGELOG.md time %s UTC)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${time})
endif()
