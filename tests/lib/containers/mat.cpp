// MATLAB's files of each version, written here by libmatio.
#include <matio.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include <railbook/containers/container.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

std::string text_of(const std::filesystem::path& file, const std::string& wanted = "") {
  std::string text;
  containers::write_table(containers::contents_of(file), wanted,
                          [&](const std::string& piece) { text += piece; });
  return text;
}

template <class Number>
matvar_t* matrix(const char* name, matio_classes kind, matio_types type, std::size_t rows,
                 std::size_t columns, std::vector<Number> values) {
  std::array<std::size_t, 2> extent{rows, columns};
  return Mat_VarCreate(name, kind, type, 2, extent.data(), values.data(), 0);
}

matvar_t* doubles(const char* name, std::size_t rows, std::size_t columns,
                  std::vector<double> values) {
  return matrix(name, MAT_C_DOUBLE, MAT_T_DOUBLE, rows, columns, std::move(values));
}

void write(const std::filesystem::path& file, mat_ft version, matio_compression packed,
           const std::vector<matvar_t*>& variables) {
  mat_t* const mat = Mat_CreateVer(file.c_str(), nullptr, version);
  REQUIRE(mat != nullptr);
  for (matvar_t* v : variables) {
    REQUIRE(Mat_VarWrite(mat, v, packed) == 0);
    Mat_VarFree(v);
  }
  Mat_Close(mat);
}

}  // namespace

TEST_CASE("mat: vectors and matrices of each version are a table") {
  const TemporaryFolder folder("mat");
  const auto file = folder.path / "a.mat";
  const std::pair<mat_ft, matio_compression> ways[] = {{MAT_FT_MAT4, MAT_COMPRESSION_NONE},
                                                       {MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                                                       {MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                                                       {MAT_FT_MAT73, MAT_COMPRESSION_NONE},
                                                       {MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}};
  for (const auto& [version, packed] : ways) {
    CAPTURE(version, packed);
    write(file, version, packed,
          {doubles("distance_m", 3, 1, {0, 0.25, 0.5}), doubles("level_mm", 1, 3, {1, -2.5, 1e-9}),
           doubles("rail_mm", 3, 2, {1, 2, 3, 4, 5, 6}), doubles("fs", 1, 1, {1000})});
    const std::string text = text_of(file);
    CHECK(text ==
          "distance_m,level_mm,rail_mm_1,rail_mm_2\n0,1,1,4\n0.25,-2.5,2,5\n0.5,1e-09,3,6\n");
    // Through the program, as the command reads it.
    table::CsvReader reader(file, {.dataset = "level_mm,distance_m"});
    REQUIRE(reader.next());
    CHECK(reader.number(0) == 1);
    CHECK(reader.number(1) == 0);
  }
}

TEST_CASE("mat: numbers of each width, and structs by their names") {
  const TemporaryFolder folder("mat struct");
  const auto file = folder.path / "a.mat";
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT73}) {
    CAPTURE(version);
    const std::array<const char*, 3> fields{"x", "y", "text"};
    std::array<std::size_t, 2> one{1, 1}, size{1, 5};
    matvar_t* const run =
        Mat_VarCreateStruct("run", 2, one.data(), const_cast<const char**>(fields.data()), 3);
    Mat_VarSetStructFieldByName(
        run, "x", 0, matrix<std::int16_t>(nullptr, MAT_C_INT16, MAT_T_INT16, 2, 1, {-7, 300}));
    Mat_VarSetStructFieldByName(
        run, "y", 0, matrix<float>(nullptr, MAT_C_SINGLE, MAT_T_SINGLE, 2, 1, {0.1F, 2.5F}));
    std::string name = "hello";
    Mat_VarSetStructFieldByName(
        run, "text", 0,
        Mat_VarCreate(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, size.data(), name.data(), 0));
    write(file, version, MAT_COMPRESSION_ZLIB,
          {run, matrix<std::uint64_t>("big", MAT_C_UINT64, MAT_T_UINT64, 3, 1,
                                      {1, 18446744073709551615ULL, 3})});
    CHECK(text_of(file, "run") == "x,y\n-7,0.1\n300,2.5\n");
    CHECK(text_of(file, "run.y") == "y\n0.1\n2.5\n");
    CHECK(text_of(file, "big") == "big\n1\n18446744073709551615\n3\n");
    CHECK_THROWS_WITH(text_of(file), Contains("big (1 column of 3); run (2 columns of 2)"));
  }
}

TEST_CASE("mat: what is no full matrix of real numbers is named") {
  const TemporaryFolder folder("mat unread");
  const auto file = folder.path / "a.mat";
  std::array<std::size_t, 2> extent{2, 1};
  std::array<double, 2> re{1, 2}, im{3, 4};
  mat_complex_split_t both{re.data(), im.data()};
  matvar_t* const complex =
      Mat_VarCreate("z", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, extent.data(), &both, MAT_F_COMPLEX);
  std::array<matvar_t*, 2> cells{doubles(nullptr, 1, 1, {1}), doubles(nullptr, 1, 1, {2})};
  matvar_t* const cell =
      Mat_VarCreate("c", MAT_C_CELL, MAT_T_CELL, 2, extent.data(), cells.data(), 0);
  std::array<std::size_t, 3> cube{2, 2, 2};
  std::vector<double> eight(8, 1.0);
  matvar_t* const block =
      Mat_VarCreate("b", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, cube.data(), eight.data(), 0);
  write(file, MAT_FT_MAT5, MAT_COMPRESSION_NONE, {complex, cell, block});
  CHECK_THROWS_WITH(text_of(file), Contains("no array of numbers with two rows") &&
                                       Contains("z (complex), c (a cell array), b (3 dimensions)"));
}

TEST_CASE("property: whatever byte of a MAT file is changed, it is read or refused") {
  const TemporaryFolder folder("mat damage");
  const auto file = folder.path / "a.mat";
  std::vector<double> values(40);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.1 * static_cast<double>(i);
  for (const mat_ft version : {MAT_FT_MAT4, MAT_FT_MAT5}) {
    write(file, version, version == MAT_FT_MAT5 ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE,
          {doubles("x", 40, 1, values), doubles("y", 20, 2, values)});
    const std::string good = folder.read("a.mat");
    CHECK_NOTHROW(table::CsvReader(file, {.dataset = "x"}));
    for (std::size_t cut = 1; version == MAT_FT_MAT5 && cut < good.size() - 128; cut += 7) {
      const auto bad = folder.write("cut.mat", good.substr(0, good.size() - cut));
      CHECK_THROWS_WITH(table::CsvReader(bad, {.dataset = "x"}), Contains("cut off"));
    }
    for (std::size_t i = 0; i < good.size(); i += 17) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ (1 << i % 8));
      try {
        table::CsvReader reader(folder.write("bad.mat", bad), {.dataset = "x"});
        while (reader.next()) {
        }
      } catch (const InputError&) {
      }
    }
  }
}
