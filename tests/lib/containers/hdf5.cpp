// HDF5 files, written here by the library itself.
#include <hdf5.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include <railbook/containers/container.hpp>
#include <railbook/records/record_file.hpp>
#include <railbook/table/csv.hpp>
#include <railbook/units/input_error.hpp>

#include "support/temporary_folder.hpp"

using namespace railbook;
using Catch::Matchers::Contains;

namespace {

// A file that is being written; what is made in it is closed with it.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& name) {
    const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    file = H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
    H5Pclose(access);
    links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    REQUIRE(file >= 0);
  }
  ~Writer() {
    H5Pclose(links);
    H5Fclose(file);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // A data set of any type, packed in chunks if asked for.
  hid_t set(const std::string& path, hid_t stored, hid_t memory, const std::vector<hsize_t>& extent,
            const void* data, const std::vector<hsize_t>& chunk = {}) {
    const hid_t space = H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    if (!chunk.empty()) {
      H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
      H5Pset_shuffle(creation);
      H5Pset_deflate(creation, 6);
    }
    const hid_t set = H5Dcreate2(file, path.c_str(), stored, space, links, creation, H5P_DEFAULT);
    REQUIRE(set >= 0);
    if (data != nullptr) REQUIRE(H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    H5Sclose(space);
    H5Pclose(creation);
    return set;
  }
  hid_t doubles(const std::string& path, const std::vector<double>& values,
                const std::vector<hsize_t>& extent = {}, const std::vector<hsize_t>& chunk = {}) {
    return set(path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
               extent.empty() ? std::vector<hsize_t>{values.size()} : extent, values.data(), chunk);
  }
  static void text(hid_t object, const char* name, const std::vector<std::string>& values) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 16);
    const hsize_t count = values.size();
    const hid_t space =
        values.size() == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &count, nullptr);
    std::string bytes;
    for (std::string value : values) bytes += (value.resize(16), value);
    const hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(H5Awrite(attribute, type, bytes.data()) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
  }
  static void number(hid_t object, const char* name, double value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t attribute =
        H5Acreate2(object, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
  }

  hid_t file = -1, links = -1;
};

std::string text_of(const std::filesystem::path& file, const std::string& wanted = "") {
  std::string text;
  containers::write_table(containers::contents_of(file), wanted,
                          [&](const std::string& piece) { text += piece; });
  return text;
}

std::vector<double> ramp(std::size_t count, double step) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = step * static_cast<double>(i);
  return values;
}

}  // namespace

TEST_CASE("hdf5: vectors of one length in a group are a table, with their units") {
  const TemporaryFolder folder("hdf5");
  const auto file = folder.path / "a.h5";
  {
    Writer w(file);
    Writer::text(w.doubles("/run/distance", {0, 0.1, 0.3}), "units", {"m"});
    Writer::text(w.doubles("/run/left", {1.5, std::nan(""), -2e-7}), "Unit", {"mm"});
    const std::int32_t counts[] = {-1, 2147483647, 3};
    Writer::text(w.set("/run/n", H5T_STD_I32BE, H5T_NATIVE_INT32, {3}, counts), "unit",
                 {"no unit"});
    const double fs = 1000;
    w.set("/run/fs", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {1}, &fs);  // no table: one number
  }
  const char* const table =
      "distance [m],left [mm],n\n0,1.5,-1\n0.1,nan,2147483647\n0.3,-2e-07,3\n";
  CHECK(text_of(file) == table);
  CHECK(text_of(file, "/run/") == table);
  CHECK(text_of(file, "run/n, /run/distance") == "n,distance [m]\n-1,0\n2147483647,0.1\n3,0.3\n");
  CHECK_THROWS_WITH(text_of(file, "runs"),
                    Contains("no data set \"runs\"; there are: run (3 columns of 3)"));
}

TEST_CASE("hdf5: matrices, by rows or as MATLAB has them, give a column each") {
  const TemporaryFolder folder("hdf5 matrix");
  const auto file = folder.path / "a.h5";
  // 3 x 2 in chunks of 2 x 1 that do not fit, and the same the other way round.
  for (const bool matlab : {false, true}) {
    {
      Writer w(file);
      const std::vector<double> by_rows{1, 2, 3, 4, 5, 6}, by_columns{1, 3, 5, 2, 4, 6};
      const hid_t set =
          w.doubles("/x", matlab ? by_columns : by_rows,
                    matlab ? std::vector<hsize_t>{2, 3} : std::vector<hsize_t>{3, 2}, {2, 1});
      if (matlab) Writer::text(set, "MATLAB_class", {"double"});
      Writer::text(set, "units", {"mm", "in"});
    }
    CHECK(text_of(file) == "x_1 [mm],x_2 [in]\n1,2\n3,4\n5,6\n");
  }
}

TEST_CASE("hdf5: compounds give a column a member; texts and arrays in them too") {
  struct Row {
    double at;
    char rail[6];
    float pair[2];
  };
  const TemporaryFolder folder("hdf5 compound");
  const auto file = folder.path / "a.h5";
  {
    Writer w(file);
    const hid_t rail = H5Tcopy(H5T_C_S1);
    H5Tset_size(rail, 6);
    const hsize_t two = 2;
    const hid_t pair = H5Tarray_create2(H5T_NATIVE_FLOAT, 1, &two);
    const hid_t row = H5Tcreate(H5T_COMPOUND, sizeof(Row));
    H5Tinsert(row, "at", HOFFSET(Row, at), H5T_NATIVE_DOUBLE);
    H5Tinsert(row, "rail", HOFFSET(Row, rail), rail);
    H5Tinsert(row, "pair", HOFFSET(Row, pair), pair);
    const Row rows[] = {{0.25, "left", {0.1F, 1e30F}}, {0.5, "a,\"b", {-99.99F, 0}}};
    w.set("/t", row, row, {2}, rows);
    H5Tclose(row);
    H5Tclose(pair);
    H5Tclose(rail);
  }
  // Numbers of single precision as short as they are read back the same.
  CHECK(text_of(file) == "at,rail,pair_1,pair_2\n0.25,left,0.1,1e+30\n0.5,\"a,\"\"b\",-99.99,0\n");
}

TEST_CASE("hdf5: packed values of netCDF come out as they were") {
  const TemporaryFolder folder("hdf5 packed");
  const auto file = folder.path / "a.nc";
  {
    Writer w(file);
    const std::int16_t packed[] = {10, -32767, 30};
    const hid_t set = w.set("/z", H5T_STD_I16LE, H5T_NATIVE_INT16, {3}, packed);
    Writer::number(set, "scale_factor", 0.5);
    Writer::number(set, "add_offset", 100);
    Writer::number(set, "_FillValue", -32767);
  }
  CHECK(text_of(file) == "z\n105\nnan\n115\n");
}

TEST_CASE("hdf5: several tables are listed, and lengths that differ are refused") {
  const TemporaryFolder folder("hdf5 several");
  const auto file = folder.path / "a.h5";
  {
    Writer w(file);
    w.doubles("/run/1/x", {1, 2});
    w.doubles("/run/2/x", {1, 2, 3});
    w.doubles("/run/2/y", {1, 2, 3, 4});
    w.doubles("/cube", ramp(8, 1), {2, 2, 2});
  }
  CHECK_THROWS_WITH(text_of(file), Contains("several tables") && Contains("--dataset") &&
                                       Contains("run/1 (1 column of 2); run/2/x (1 column of 3)") &&
                                       Contains("not read: cube (3 dimensions)"));
  CHECK_THROWS_WITH(text_of(file, "run/2"), Contains("several lengths"));
  CHECK_THROWS_WITH(text_of(file, "run/1,run/2/y"), Contains("have 2 and 4 rows"));
  CHECK(text_of(file, "run/2/y") == "y\n1\n2\n3\n4\n");
  {
    Writer w(file);
    Writer::text(w.doubles("/channels/level_l/data", {1, 2}), "Unit", {"Millimeter"});
    Writer::text(w.doubles("/channels/level_r/data", {3, 4}), "Unit", {"Millimeter"});
  }
  CHECK(text_of(file, "channels/level_l,channels/level_r") ==
        "level_l/data [Millimeter],level_r/data [Millimeter]\n1,3\n2,4\n");
}

TEST_CASE("hdf5: no number comes from another file, nor from a filter that is not there") {
  const TemporaryFolder folder("hdf5 hostile");
  const auto file = folder.path / "a.h5", other = folder.path / "other.h5";
  {
    Writer w(other);
    w.doubles("/secret", {1, 2, 3});
  }
  folder.write("raw.bin", std::string(24, 'x'));
  {
    Writer w(file);
    H5Lcreate_external(other.c_str(), "/secret", w.file, "link", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_external(other.c_str(), "/", w.file, "all", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/all/secret", w.file, "soft", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/soft2", w.file, "soft2", H5P_DEFAULT, H5P_DEFAULT);  // to itself
    const hsize_t three = 3;
    const hid_t space = H5Screate_simple(1, &three, nullptr);
    const hid_t outside = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(outside, (folder.path / "raw.bin").c_str(), 0, 24);
    H5Dcreate2(w.file, "outside", H5T_IEEE_F64LE, space, H5P_DEFAULT, outside, H5P_DEFAULT);
    const hid_t composed = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_virtual(composed, space, other.c_str(), "/secret", space);
    H5Dcreate2(w.file, "virtual", H5T_IEEE_F64LE, space, H5P_DEFAULT, composed, H5P_DEFAULT);
    const hid_t packed = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(packed, 1, &three);
    H5Pset_filter(packed, 32015, H5Z_FLAG_OPTIONAL, 0, nullptr);
    H5Dcreate2(w.file, "zstd", H5T_IEEE_F64LE, space, H5P_DEFAULT, packed, H5P_DEFAULT);
  }
  try {
    text_of(file);
    FAIL("read");
  } catch (const InputError& error) {
    const std::string why = error.what();
    CHECK_THAT(why, Contains("all (damaged, or a link that leads out of the file)"));
    CHECK_THAT(why, Contains("link (damaged, or a link that leads out of the file)"));
    CHECK_THAT(why, Contains("soft (damaged"));
    CHECK_THAT(why, Contains("outside (its numbers are in other files)"));
    CHECK_THAT(why, Contains("virtual (its numbers are in other files)"));
    CHECK_THAT(why, Contains("filter 32015; h5repack"));
  }
}

TEST_CASE("hdf5: more numbers than the file can hold, or too large chunks, are refused") {
  const TemporaryFolder folder("hdf5 huge");
  const auto file = folder.path / "a.h5";
  {
    Writer w(file);
    w.set("/x", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {hsize_t{1} << 50}, nullptr, {1024});
    w.set("/y", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, {hsize_t{1} << 62, 1 << 20}, nullptr, {1024, 1});
  }
  CHECK_THROWS_WITH(text_of(file), Contains("x (more numbers than so small a file can hold)") &&
                                       Contains("y (1048576 columns)"));
}

TEST_CASE("hdf5: a record is read through the program, as the command does") {
  const TemporaryFolder folder("hdf5 record");
  const auto file = folder.path / "a.h5";
  std::vector<double> places = ramp(40000, 0.25), left(40000);
  for (std::size_t i = 0; i < left.size(); ++i)
    left[i] = std::sin(0.1 * static_cast<double>(i)) + 1e-3 * std::cos(7.0 * double(i));
  left[777] = std::nan("");
  {
    Writer w(file);
    Writer::text(w.doubles("/run/distance", places, {}, {4096}), "units", {"m"});
    Writer::text(w.doubles("/run/left", left, {}, {1000}), "units", {"mm"});
    w.doubles("/other/z", {1, 2});
  }
  std::vector<double> heights;
  records::RecordFile source;
  source.file = file;
  source.column = "left";
  source.dataset = "run";
  source.bridge = 0;
  const auto record = records::read_record(
      source, [&](std::span<const double> piece, const records::RecordStream&) {
        heights.insert(heights.end(), piece.begin(), piece.end());
      });
  REQUIRE(heights.size() == left.size());
  for (std::size_t i = 0; i < left.size(); ++i)
    if (i != 777) REQUIRE(heights[i] == left[i] * 1e-3);
  CHECK(std::isnan(heights[777]));
  CHECK(record->missing() == 1);
  CHECK(record->spacing() == Approx(0.25));
  const auto refused = [&](const table::TextOptions& options, const char* why) {
    CHECK_THROWS_WITH((table::CsvReader{file, options}), Contains("a.h5\": ") && Contains(why));
  };
  refused({}, "several tables");
  refused({.dataset = "ruin"}, "no data set \"ruin\"");
  refused({.skip = 1}, "none of --skip");
  refused({.encoding = "cp1252"}, "none of --skip");
  refused({.sheet = "1"}, "no workbook");
  CHECK_THROWS_WITH((table::CsvReader{folder.write("a.csv", "a,b\n1,2\n"), {.dataset = "x"}}),
                    Contains("no HDF5 or MAT file; allowed: no --dataset"));
}

TEST_CASE("property: whatever byte of an HDF5 file is changed, it is read or refused") {
  const TemporaryFolder folder("hdf5 damage");
  const auto file = folder.path / "a.h5";
  {
    Writer w(file);
    Writer::text(w.doubles("/run/x", ramp(50, 0.25), {}, {16}), "units", {"m"});
    w.doubles("/run/z", ramp(50, 1.5));
  }
  const std::string good = folder.read("a.h5");
  for (std::size_t i = 8; i < good.size(); i += 41) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << i % 8));
    const auto name = folder.write("bad.h5", bad);
    try {
      table::CsvReader reader(name, {.dataset = "run"});
      while (reader.next()) {
      }
    } catch (const InputError&) {
    }
  }
  for (std::size_t size = 8; size < good.size(); size += 301) {
    const auto name = folder.write("bad.h5", good.substr(0, size));
    CHECK_THROWS_AS(table::CsvReader(name, {.dataset = "run"}), InputError);
  }
}
