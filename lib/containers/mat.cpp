// MATLAB's files of version 4 and 5 to 7.
#include <matio.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <railbook/containers/container.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::containers {
namespace {

using Mat = std::shared_ptr<mat_t>;
using Variable = std::shared_ptr<matvar_t>;

// Column `of` of a matrix whose values are Numbers, in the type that holds them.
template <class As, class Number>
Values column_of(const matvar_t& v, std::size_t first, std::size_t count) {
  const auto* const from = static_cast<const Number*>(v.data) + first;
  return std::vector<As>(from, from + count);
}

Values values_of(const matvar_t& v, std::size_t first, std::size_t count) {
  switch (v.data_type) {
    case MAT_T_DOUBLE:
      return column_of<double, double>(v, first, count);
    case MAT_T_SINGLE:
      return column_of<float, float>(v, first, count);
    case MAT_T_INT8:
      return column_of<std::int64_t, std::int8_t>(v, first, count);
    case MAT_T_UINT8:
      return column_of<std::int64_t, std::uint8_t>(v, first, count);
    case MAT_T_INT16:
      return column_of<std::int64_t, std::int16_t>(v, first, count);
    case MAT_T_UINT16:
      return column_of<std::int64_t, std::uint16_t>(v, first, count);
    case MAT_T_INT32:
      return column_of<std::int64_t, std::int32_t>(v, first, count);
    case MAT_T_UINT32:
      return column_of<std::int64_t, std::uint32_t>(v, first, count);
    case MAT_T_INT64:
      return column_of<std::int64_t, std::int64_t>(v, first, count);
    case MAT_T_UINT64:
      return column_of<std::uint64_t, std::uint64_t>(v, first, count);
    default:
      throw InputError{"its numbers are of an unknown type"};
  }
}

// What a class is that holds no full matrix of real numbers; nothing where it does.
std::string trouble(const matvar_t& v) {
  if (v.isComplex != 0) return "complex";
  switch (v.class_type) {
    case MAT_C_CELL:
      return "a cell array";
    case MAT_C_SPARSE:
      return "a sparse matrix; full(...) makes it a full one";
    case MAT_C_OBJECT:
    case MAT_C_OPAQUE:
      return "an object of MATLAB; table2struct(T, 'ToScalar', true) makes a struct of a table";
    case MAT_C_FUNCTION:
      return "a function";
    case MAT_C_STRUCT:
      return "an array of structs";
    default:
      return v.rank > 2 ? std::to_string(v.rank) + " dimensions" : "";
  }
}

class Reader {
 public:
  Reader(Mat mat, Contents& contents) : mat_(std::move(mat)), contents_(contents) {}

  // `whole` keeps the variable that v is, or is a part of.
  void add(const std::string& group, matvar_t* v, const std::string& name, const Variable& whole,
           std::size_t depth) {
    const std::string path = group.empty() ? name : group + "/" + name;
    if (v->class_type == MAT_C_EMPTY || v->class_type == MAT_C_CHAR || v->dims == nullptr) return;
    std::size_t length = 1;
    for (int i = 0; i < v->rank; ++i)
      if (v->dims[i] == 0 || __builtin_mul_overflow(length, v->dims[i], &length)) return;
    if (v->class_type == MAT_C_STRUCT && length == 1) {
      const unsigned fields = Mat_VarGetNumberOfFields(v);
      char* const* const names = Mat_VarGetStructFieldnames(v);
      for (unsigned i = 0; depth < most_depth && names != nullptr && i < fields; ++i)
        if (matvar_t* const field = Mat_VarGetStructFieldByIndex(v, i, 0); field != nullptr)
          add(path, field, names[i], whole, depth + 1);
      return;
    }
    if (const std::string why = trouble(*v); !why.empty()) {
      if (contents_.unread.size() < 50) contents_.unread.push_back(path + " (" + why + ")");
      return;
    }
    if (length == 1) return;
    const bool vector = v->rank < 2 || v->dims[0] == 1 || v->dims[1] == 1;
    const std::size_t rows = vector ? length : v->dims[0], columns = length / rows;
    if (columns > most_columns) {
      contents_.unread.push_back(path + " (" + std::to_string(columns) + " columns)");
      return;
    }
    if (contents_.sets.size() >= most_objects)
      throw InputError{"it holds more than " + std::to_string(most_objects) + " arrays"};
    DataSet set{group, name, rows, {}, {}};
    for (std::size_t i = 0; i < columns; ++i)
      set.columns.push_back({columns > 1 ? name + "_" + std::to_string(i + 1) : name, ""});
    set.read = [mat = mat_, whole, v, rows, columns, path](std::size_t first, std::size_t count) {
      const bool there = v->data != nullptr || Mat_VarReadDataAll(mat.get(), v) == 0;
      if (!there || v->data == nullptr || v->data_size <= 0 ||
          v->nbytes / static_cast<std::size_t>(v->data_size) < rows * columns)
        throw InputError{"the variable \"" + units::printable(path) +
                         "\" cannot be read: it is damaged, or larger than 2 GiB (save it by "
                         "-v7.3)"};
      std::vector<Values> values;
      for (std::size_t i = 0; i < columns; ++i)
        values.push_back(values_of(*v, i * rows + first, count));
      return values;
    };
    contents_.sets.push_back(std::move(set));
  }

 private:
  Mat mat_;
  Contents& contents_;
};

// Version 5 to 7 is a row of elements with their lengths; the library takes one that is cut off for
// the end of the file.
void require_whole(const std::filesystem::path& file) {
  constexpr std::uint32_t compressed = 15;
  const std::uintmax_t size = std::filesystem::file_size(file);
  std::ifstream in{file, std::ios::binary};
  std::array<char, 128> header{};
  in.read(header.data(), std::ssize(header));
  const std::string_view order{header.data() + 126, 2};
  if (order != "IM" && order != "MI") return;
  for (std::uintmax_t at = header.size(); at < size;) {
    std::array<std::uint32_t, 2> tag{};  // type and bytes
    in.seekg(static_cast<std::streamoff>(at));
    in.read(reinterpret_cast<char*>(tag.data()), sizeof tag);
    if (order == "MI")
      for (std::uint32_t& word : tag) word = __builtin_bswap32(word);
    at += sizeof tag + tag[1] + (tag[0] == compressed ? 0 : -tag[1] % 8);
    if (!in || at > size) throw InputError{"the MAT file is cut off, or damaged"};
  }
}

}  // namespace

Contents mat_contents(const std::filesystem::path& file) {
  Mat_LogInitFunc("containers", [](int, auto*) {});
  const Mat mat{Mat_Open(file.c_str(), MAT_ACC_RDONLY), [](mat_t* m) {
                  if (m != nullptr) Mat_Close(m);
                }};
  if (!mat || Mat_GetVersion(mat.get()) == MAT_FT_MAT73)
    throw InputError{"it is no MAT file, or a damaged one"};
  require_whole(file);
  Contents contents;
  Reader reader{mat, contents};
  while (matvar_t* const v = Mat_VarReadNextInfo(mat.get())) {
    const Variable variable{v, Mat_VarFree};
    if (v->name != nullptr) reader.add("", v, v->name, variable, 0);
  }
  return contents;
}

}  // namespace railbook::containers
