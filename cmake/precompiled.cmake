# Headers that most files of a kind include, compiled once a kind: half of the compilation time of a clean build.
# Off, every file must still compile by its own includes (the preset for Clang does so).
option(RAILBOOK_PCH "Precompile the headers that most files include" ON)

set(railbook_pch_lib <Eigen/Core> <algorithm> <cmath> <functional> <string> <vector>)
set(railbook_pch_text ${railbook_pch_lib})
set(railbook_pch_chapter ${railbook_pch_lib} <filesystem> <memory> <fmt/format.h> <railbook/report/chapter.hpp>)
set(railbook_pch_tool ${railbook_pch_lib} <filesystem> <memory> <optional> <fmt/format.h> <railbook/tool/summary.hpp>)
set(railbook_pch_test ${railbook_pch_lib} <catch2/catch.hpp>)

# railbook_precompile(TARGET KIND [targets whose headers they are]): KIND is lib, text, chapter, tool or test.
function(railbook_precompile target kind)
  # What computes nothing takes less time to run than to optimize. A precompiled header brings the level it was compiled
  # with to all that use it (GCC 12), whatever their own flags say: hence a kind of its own.
  if(RAILBOOK_SANITIZE AND NOT kind STREQUAL lib)
    set(unoptimized -O0)
  elseif(kind STREQUAL text)
    set(unoptimized $<$<CONFIG:Release>:-O1>)
  endif()
  target_compile_options(${target} PRIVATE ${unoptimized})
  if(NOT RAILBOOK_PCH)
    return()
  endif()
  if(NOT TARGET railbook_precompiled_${kind})
    set(empty ${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp)
    file(CONFIGURE OUTPUT ${empty} CONTENT "\n" @ONLY)
    add_library(railbook_precompiled_${kind} OBJECT ${empty})
    target_link_libraries(railbook_precompiled_${kind} PRIVATE railbook_flags Eigen3::Eigen ${ARGN})
    target_compile_options(railbook_precompiled_${kind} PRIVATE ${unoptimized})
    target_precompile_headers(railbook_precompiled_${kind} PRIVATE ${railbook_pch_${kind}})
  endif()
  target_precompile_headers(${target} REUSE_FROM railbook_precompiled_${kind})
endfunction()
