# Helpers that keep each folder's CMakeLists.txt to a line or two.

# Flags shared by every target of the project (third-party headers are system headers, and exempt).
add_library(railbook_flags INTERFACE)
# They are ours: a project that uses the installed library compiles as it likes, but for C++20.
set(flags -Wall -Wextra -Wpedantic -Wconversion -Wshadow $<$<BOOL:${RAILBOOK_WERROR}>:-Werror>
    -ffp-contract=off # no fused multiply-add behind our back: the same digits from every compiler
    -fPIC) # all of it may go into a shared library; as an option of all, it fits the precompiled headers too
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # What -O3 gives here: vectors in loops of any length, short loops unrolled.
  list(APPEND flags $<$<CONFIG:Release>:-fvect-cost-model=dynamic> $<$<CONFIG:Release>:-fpeel-loops>)
  list(APPEND flags -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds) # false alarms in GCC 12 (bugs 105651, 105329)
else()
  # Clang otherwise divides ahead of the test that forbids it, and the flags that we read are raised.
  list(APPEND flags -ffp-exception-behavior=maytrap)
endif()
if(CMAKE_UNITY_BUILD) # several sources in one are no headers of each other
  list(APPEND flags -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
target_compile_options(railbook_flags INTERFACE "$<BUILD_INTERFACE:${flags}>")
target_compile_features(railbook_flags INTERFACE cxx_std_20)
# Releases are hardened: checked buffers and stack frames, no table of addresses that stays writable. Control-flow enforcement (CET) is
# the compiler's default: on for Ubuntu; on Debian 12 the C library's own start files lack it, and the linker then drops it.
target_compile_options(railbook_flags INTERFACE
  "$<BUILD_INTERFACE:$<$<CONFIG:Release>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2;-fstack-protector-strong>>")
target_link_options(railbook_flags INTERFACE "$<BUILD_INTERFACE:$<$<CONFIG:Release>:-Wl,-z,relro,-z,now>>")
# Headers are <railbook/ROOM/FILE.hpp>, in the tree as where they are installed.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/lib ${PROJECT_BINARY_DIR}/include/railbook SYMBOLIC)
target_include_directories(railbook_flags INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                           $<INSTALL_INTERFACE:include>)
if(RAILBOOK_SANITIZE)
  # A null pointer ends under the address sanitizer too; these three checks are half of the compilation time.
  target_compile_options(railbook_flags INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,alignment,vptr -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(railbook_flags INTERFACE -fsanitize=address,undefined)
endif()

# Everything `make reproduce` runs, and everything but what only the tests need.
add_custom_target(chapter_programs)
add_custom_target(programs DEPENDS chapter_programs)
# The test programs of lib/.
add_custom_target(unit_tests)

# railbook_library(NAME [TEXT] [INTERNAL] [NEEDS other libraries of lib/] [USES third-party targets] [WITHOUT sources])
# The target railbook_NAME from every .cpp of the calling folder, but for those named after WITHOUT. TEXT: it writes, draws
# or reads options, and computes little. INTERNAL: only our own programs use it; it is static always, and not installed.
function(railbook_library name)
  cmake_parse_arguments(arg "TEXT;INTERNAL" "" "NEEDS;USES;WITHOUT" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  foreach(source ${arg_WITHOUT})
    list(FILTER sources EXCLUDE REGEX "/${source}\\.cpp$")
  endforeach()
  set_property(GLOBAL PROPERTY RAILBOOK_NEEDS_${name} ${arg_NEEDS})
  list(TRANSFORM arg_NEEDS PREPEND railbook_)
  set(kind lib)
  if(arg_TEXT)
    set(kind text)
  endif()
  set(linkage "") # static, or shared with BUILD_SHARED_LIBS
  if(arg_INTERNAL)
    set(linkage STATIC)
  endif()
  if(sources)
    add_library(railbook_${name} ${linkage} ${sources})
    set_target_properties(railbook_${name} PROPERTIES VERSION ${PROJECT_VERSION}
                          SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_link_libraries(railbook_${name} PUBLIC railbook_flags ${arg_NEEDS} ${arg_USES})
    railbook_precompile(railbook_${name} ${kind})
    add_library(railbook::${name} ALIAS railbook_${name}) # as find_package names it
  else()
    add_library(railbook_${name} INTERFACE)
    target_link_libraries(railbook_${name} INTERFACE railbook_flags ${arg_NEEDS} ${arg_USES})
  endif()
endfunction()

# railbook_method(NAME NN-NAME [NEEDS libraries of lib/] [USES third-party targets])
# The solver that only one chapter has, from its folder method/: the target railbook_NAME, and the program test_NAME from
# tests/chapters/NN-NAME. It is not installed.
function(railbook_method name chapter)
  cmake_parse_arguments(arg "" "" "NEEDS;USES" ${ARGN})
  list(TRANSFORM arg_NEEDS PREPEND railbook_)
  file(GLOB sources CONFIGURE_DEPENDS method/*.cpp)
  add_library(railbook_${name} STATIC ${sources})
  target_include_directories(railbook_${name} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(railbook_${name} PUBLIC railbook_flags ${arg_NEEDS} ${arg_USES})
  railbook_precompile(railbook_${name} lib)
  railbook_tests(${name} FOLDER chapters/${chapter})
endfunction()

# railbook_tests(NAME [FOLDER folder of tests/] [NEEDS ...] [USES ...])
# The program test_NAME from the folder, lib/NAME; each TEST_CASE is a ctest, of `make thorough` if it has that tag.
function(railbook_tests name)
  cmake_parse_arguments(arg "" "FOLDER" "NEEDS;USES" ${ARGN})
  if(NOT arg_FOLDER)
    set(arg_FOLDER lib/${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${arg_FOLDER}/*.cpp)
  if(NOT sources OR NOT RAILBOOK_TESTS)
    return()
  endif()
  list(TRANSFORM arg_NEEDS PREPEND railbook_)
  add_executable(test_${name} ${sources})
  set_target_properties(test_${name} PROPERTIES UNITY_BUILD OFF) # each file has its own cases of the same names
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE railbook_flags railbook_${name} ${arg_NEEDS}
                        ${arg_USES} catch_main)
  railbook_precompile(test_${name} test catch_main)
  add_dependencies(unit_tests test_${name})
  include(Catch)
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " TEST_SPEC "~[.]~[thorough]~[long]" PROPERTIES LABELS unit)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources}) # a tag that comes is seen
  foreach(tag thorough long)
    foreach(source ${sources})
      file(STRINGS ${source} found REGEX "\\[${tag}\\]" LIMIT_COUNT 1)
      if(found)
        catch_discover_tests(test_${name} TEST_PREFIX "${name}: " TEST_SPEC "[${tag}]~[.]" PROPERTIES LABELS unit-${tag})
        break()
      endif()
    endforeach()
  endforeach()
endfunction()

# railbook_chapter(NN-NAME [NEEDS libraries of lib/])
# The chapter program NAME in build/bin; a need that is not named is a link error.
# ctest runs it (every check must pass), or takes what `make reproduce` has left, and compares the figures with the golden
# set (tests/figures); under the label "thorough", again, without pictures, with other mathematics.
function(railbook_chapter chapter)
  cmake_parse_arguments(arg "" "" "NEEDS;USES" ${ARGN})
  string(REGEX REPLACE "^[0-9]+-" "" name ${chapter})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp study/*.cpp)
  list(TRANSFORM arg_NEEDS PREPEND railbook_)
  add_executable(${name} ${sources})
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
  target_compile_definitions(${name} PRIVATE
    RAILBOOK_CHAPTER="${chapter}" RAILBOOK_CHAPTER_DIR="${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE railbook_flags ${arg_NEEDS} ${arg_USES})
  railbook_precompile(${name} chapter fmt::fmt)
  if(EXISTS ${PROJECT_SOURCE_DIR}/chapters/${chapter}) # not the new one that a test makes
    add_dependencies(chapter_programs ${name})
    railbook_reproduce(${chapter} ${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY RAILBOOK_CHAPTERS ${name})
  if(EXISTS ${PROJECT_SOURCE_DIR}/figures/${chapter})
    set_property(GLOBAL APPEND PROPERTY RAILBOOK_CHAPTER_FOLDERS ${chapter})
  endif()
  if(NOT RAILBOOK_TESTS)
    return()
  endif()
  add_test(NAME "chapter: ${chapter} reproduces" COMMAND ${PROJECT_SOURCE_DIR}/tests/tools/chapter.sh ${PROJECT_BINARY_DIR} ${chapter}
           WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties("chapter: ${chapter} reproduces" PROPERTIES FIXTURES_SETUP ${chapter})
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/figures/${chapter})
    return() # none accepted yet; tests/meta does not let a chapter stay so
  endif()
  railbook_golden_test(${chapter} ${chapter} compare "")
  # The same as on another processor: the C library's mathematics without fused multiply-add gives other last digits.
  set(maths ${chapter}-maths)
  add_test(NAME "chapter: ${chapter} reproduces with other maths" COMMAND ${CMAKE_COMMAND} -E env
           GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-AVX512F,-FMA4 $<TARGET_FILE:${name}> reproduce --no-timings
           --no-figures --out ${PROJECT_BINARY_DIR}/ctest/${maths})
  set_tests_properties("chapter: ${chapter} reproduces with other maths" PROPERTIES FIXTURES_SETUP ${maths} LABELS thorough)
  railbook_golden_test(${chapter} ${maths} data " with other maths")
  set_property(TEST "figures: ${chapter} golden set with other maths" PROPERTY LABELS thorough)
  add_test(NAME "chapter: ${chapter} says the same with other maths" COMMAND same_text
           ${PROJECT_BINARY_DIR}/ctest/${chapter}/results/${chapter}.json
           ${PROJECT_BINARY_DIR}/ctest/${maths}/results/${chapter}.json)
  set_tests_properties("chapter: ${chapter} says the same with other maths" PROPERTIES
                       FIXTURES_REQUIRED "${chapter};${maths}" LABELS thorough)
endfunction()

# The golden test of the run in the folder `run` of build/ctest: compare, or data (without the pictures).
function(railbook_golden_test chapter run verb label)
  add_test(NAME "figures: ${chapter} golden set${label}" COMMAND figure_diff ${verb}
           ${PROJECT_BINARY_DIR}/ctest/${run} ${PROJECT_SOURCE_DIR}/figures/${chapter}
           ${PROJECT_SOURCE_DIR}/figures/environment.txt ${PROJECT_BINARY_DIR}/environment.txt)
  set_tests_properties("figures: ${chapter} golden set${label}" PROPERTIES FIXTURES_REQUIRED ${run})
endfunction()
