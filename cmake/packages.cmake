# Third-party libraries, found once here; a library or chapter names only the ones it uses.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(PNG REQUIRED)
find_package(Threads REQUIRED)
find_package(Catch2 2.13 REQUIRED)
pkg_check_modules(gsl REQUIRED IMPORTED_TARGET gsl)
pkg_check_modules(fftw REQUIRED IMPORTED_TARGET fftw3)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)
find_program(GNUPLOT gnuplot REQUIRED)
find_program(PANDOC pandoc REQUIRED)

# Catch2's own main, compiled once and shared by every test program.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/catch_main.cpp
     CONTENT "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n" @ONLY)
add_library(catch_main STATIC ${CMAKE_BINARY_DIR}/catch_main.cpp)
target_link_libraries(catch_main PUBLIC Catch2::Catch2)
