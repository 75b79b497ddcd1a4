// HDF5, and with it netCDF-4 and MATLAB 7.3.
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <railbook/containers/container.hpp>
#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::containers {
namespace {

constexpr std::size_t longest_text = 4096;                   // bytes of a cell
constexpr std::size_t most_cached = std::size_t{512} << 20;  // bytes, of a row of chunks
constexpr double most_packing = 1100;  // bytes of numbers to a byte of the file, by deflate

// The library's reason for the error that it has just met.
std::string reason() {
  std::string text;
  const auto keep = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
    if (error->desc != nullptr) *static_cast<std::string*>(to) = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep, &text);
  return text.empty() ? "" : ": " + units::printable(text, 200);
}

[[noreturn]] void damaged(const std::string& what) {
  throw InputError{what + " cannot be read" + reason()};
}

// An object of the library, closed with this one.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  operator hid_t() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// A file, with which way links are followed: never out of it.
struct File {
  std::filesystem::path name;
  Handle file, access;
  double size = 0;  // bytes

  Handle open(const std::string& path) const {
    return {H5Oopen(file, ("/" + path).c_str(), access), H5Oclose};
  }
};

// Reports for a link that leads to another file.
herr_t refuse_link(const char*, const char*, const char*, const char*, unsigned*, hid_t, void*) {
  return -1;
}

enum class Kind { f32, f64, i64, u64, text, pointer };

// Numbers or texts of one kind in a type of memory: a column, or `count` of them of an array.
struct Part {
  Kind kind = Kind::f64;
  std::size_t count = 1, size = 8, at = 0;  // size of one, place in an element, bytes
  std::string name = {};                    // of a member of a compound
};

// What an element of a data set or an attribute is in memory.
struct Element {
  Handle type;
  std::size_t size = 0;
  std::vector<Part> parts;
};

// A type of numbers or texts; no count and no valid type where it is neither.
std::pair<Handle, Part> scalar(hid_t type) {
  const std::size_t size = H5Tget_size(type);
  const auto native = [](hid_t id, Kind kind, std::size_t bytes) {
    return std::pair{Handle{H5Tcopy(id), H5Tclose}, Part{kind, 1, bytes}};
  };
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      if (size <= 4) return native(H5T_NATIVE_FLOAT, Kind::f32, 4);
      return native(H5T_NATIVE_DOUBLE, Kind::f64, 8);
    case H5T_ENUM:
    case H5T_INTEGER: {
      const Handle base{H5Tget_class(type) == H5T_ENUM ? H5Tget_super(type) : H5Tcopy(type),
                        H5Tclose};
      if (size > 8) break;
      if (H5Tget_sign(base) == H5T_SGN_NONE) return native(H5T_NATIVE_UINT64, Kind::u64, 8);
      return native(H5T_NATIVE_INT64, Kind::i64, 8);
    }
    case H5T_STRING: {
      const bool varies = H5Tis_variable_str(type) > 0;
      if (size > longest_text) break;
      Handle text{H5Tcopy(H5T_C_S1), H5Tclose};
      H5Tset_cset(text, H5Tget_cset(type));
      H5Tset_size(text, varies ? H5T_VARIABLE : size + 1);
      if (varies) return {std::move(text), Part{Kind::pointer, 1, sizeof(char*)}};
      return {std::move(text), Part{Kind::text, 1, size + 1}};
    }
    default:
      break;
  }
  return {Handle{-1, H5Tclose}, Part{}};
}

// The same, or an array of them.
std::pair<Handle, Part> part_of(hid_t type) {
  if (H5Tget_class(type) != H5T_ARRAY) return scalar(type);
  const Handle base{H5Tget_super(type), H5Tclose};
  auto [native, part] = scalar(base);
  hsize_t count = 0;
  if (!native.valid() || part.kind == Kind::pointer || H5Tget_array_ndims(type) != 1 ||
      H5Tget_array_dims2(type, &count) < 0 || count == 0 || count > most_columns)
    return {Handle{-1, H5Tclose}, Part{}};
  part.count = static_cast<std::size_t>(count);
  return {Handle{H5Tarray_create2(native, 1, &count), H5Tclose}, part};
}

// What can be read of the type; members of compounds that are neither numbers nor texts are left
// out.
std::optional<Element> element_of(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND) {
    auto [native, part] = part_of(type);
    if (!native.valid()) return std::nullopt;
    const std::size_t size = part.count * part.size;
    return Element{std::move(native), size, {part}};
  }
  std::vector<std::pair<Handle, Part>> members;
  std::size_t size = 0, columns = 0;
  const int count = std::min(H5Tget_nmembers(type), static_cast<int>(most_columns));
  for (int i = 0; i < count; ++i) {
    const auto index = static_cast<unsigned>(i);
    const Handle member{H5Tget_member_type(type, index), H5Tclose};
    auto [native, part] = part_of(member);
    columns += part.count;
    if (!native.valid() || columns > most_columns) continue;
    char* const name = H5Tget_member_name(type, index);
    if (name == nullptr) damaged("a compound");
    part.name = name;
    H5free_memory(name);
    part.at = size;
    size += part.count * part.size;
    members.emplace_back(std::move(native), std::move(part));
  }
  if (members.empty()) return std::nullopt;
  Element element{Handle{H5Tcreate(H5T_COMPOUND, size), H5Tclose}, size, {}};
  for (auto& [native, part] : members) {
    if (H5Tinsert(element.type, part.name.c_str(), part.at, native) < 0) damaged("a compound");
    element.parts.push_back(part);
  }
  return element;
}

template <class Number>
Number copied(const char* from) {
  Number value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// `count` values, each so many bytes behind the one before.
Values values_at(const char* from, Kind kind, std::size_t size, std::size_t count,
                 std::size_t step) {
  const auto each = [&](const auto& read) {
    std::vector<decltype(read(from))> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(read(from + i * step));
    return values;
  };
  switch (kind) {
    case Kind::f32:
      return each(copied<float>);
    case Kind::f64:
      return each(copied<double>);
    case Kind::i64:
      return each(copied<std::int64_t>);
    case Kind::u64:
      return each(copied<std::uint64_t>);
    case Kind::text:
      return each([&](const char* at) { return std::string(at, strnlen(at, size)); });
    default:
      return each([](const char* at) {
        const char* const text = copied<const char*>(at);
        return text == nullptr ? std::string{} : std::string(text, strnlen(text, longest_text));
      });
  }
}

// An attribute's values: none where it is not there or of another kind.
std::optional<Values> attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return std::nullopt;
  const Handle attribute{H5Aopen(object, name, H5P_DEFAULT), H5Aclose};
  if (!attribute.valid()) return std::nullopt;
  const Handle space{H5Aget_space(attribute), H5Sclose};
  const Handle type{H5Aget_type(attribute), H5Tclose};
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const auto element = element_of(type);
  if (!element || element->parts.size() != 1 || element->parts[0].count != 1 || count < 1 ||
      count > static_cast<hssize_t>(most_columns))
    return std::nullopt;
  std::vector<char> bytes(static_cast<std::size_t>(count) * element->size);
  if (H5Aread(attribute, element->type, bytes.data()) < 0) return std::nullopt;
  Values values = values_at(bytes.data(), element->parts[0].kind, element->size,
                            static_cast<std::size_t>(count), element->size);
  if (element->parts[0].kind == Kind::pointer)
    H5Dvlen_reclaim(element->type, space, H5P_DEFAULT, bytes.data());
  return values;
}

// The texts of the first of these attributes that has as many as there are columns, or one.
std::vector<std::string> texts(hid_t object, std::size_t columns,
                               const std::vector<const char*>& names) {
  for (const char* name : names) {
    const auto found = attribute(object, name);
    const auto* const text = found ? std::get_if<std::vector<std::string>>(&*found) : nullptr;
    if (text != nullptr && text->size() == columns) return *text;
  }
  return {};
}

// The first number of an attribute.
std::optional<double> number(hid_t object, const char* name) {
  const auto found = attribute(object, name);
  if (!found || std::holds_alternative<std::vector<std::string>>(*found)) return std::nullopt;
  return std::visit(
      [](const auto& values) {
        double value = 0;
        if constexpr (!std::is_same_v<decltype(values.front()), const std::string&>)
          value = static_cast<double>(values.front());
        return value;
      },
      *found);
}

// A data set that can be read.
struct Array {
  std::shared_ptr<const File> file;
  std::string path;
  Handle set, space;
  Element element;
  std::vector<hsize_t> extent;
  std::size_t rows = 1, columns = 1;
  std::size_t row_axis = 0, column_axis = 0;
  std::optional<double> fill = {}, missing = {}, scale = {}, offset = {};  // netCDF's
};

// netCDF's packed and lost values.
void unpack(const Array& array, Values& values) {
  if (!array.fill && !array.missing && !array.scale && !array.offset) return;
  std::vector<double> numbers;
  std::visit(
      [&](const auto& given) {
        if constexpr (!std::is_same_v<decltype(given), const std::vector<std::string>&>)
          for (const auto value : given) {
            const auto raw = static_cast<double>(value);
            const bool lost = raw == array.fill || raw == array.missing;
            numbers.push_back(lost ? std::numeric_limits<double>::quiet_NaN()
                                   : raw * array.scale.value_or(1) + array.offset.value_or(0));
          }
      },
      values);
  if (!std::holds_alternative<std::vector<std::string>>(values)) values = std::move(numbers);
}

std::vector<Values> read_rows(const Array& array, std::size_t first, std::size_t count) {
  const std::size_t rank = array.extent.size();
  std::vector<hsize_t> start(rank, 0), extent = array.extent;
  if (rank > 0) start[array.row_axis] = first, extent[array.row_axis] = count;
  const Handle memory{H5Screate_simple(static_cast<int>(rank), extent.data(), nullptr), H5Sclose};
  std::vector<char> bytes(count * array.columns * array.element.size);
  if (H5Sselect_hyperslab(array.space, H5S_SELECT_SET, start.data(), nullptr, extent.data(),
                          nullptr) < 0 ||
      H5Dread(array.set, array.element.type, memory, array.space, H5P_DEFAULT, bytes.data()) < 0)
    damaged("the data set \"" + units::printable(array.path) + "\"");
  const bool by_rows = array.columns == 1 || array.row_axis < array.column_axis;
  std::vector<Values> result;
  for (std::size_t column = 0; column < array.columns; ++column)
    for (const Part& part : array.element.parts)
      for (std::size_t i = 0; i < part.count; ++i) {
        const std::size_t before = by_rows ? column : column * count;
        const char* const from =
            bytes.data() + before * array.element.size + part.at + i * part.size;
        result.push_back(values_at(from, part.kind, part.size, count,
                                   array.element.size * (by_rows ? array.columns : 1)));
        unpack(array, result.back());
      }
  bool pointers = false;
  for (const Part& part : array.element.parts) pointers = pointers || part.kind == Kind::pointer;
  if (pointers) H5Dvlen_reclaim(array.element.type, memory, H5P_DEFAULT, bytes.data());
  return result;
}

// Why the bytes of a data set are not in the file as they should be; nothing where they are.
std::string trouble(const Array& array, hid_t creation) {
  if (H5Pget_external_count(creation) > 0 || H5Pget_layout(creation) == H5D_VIRTUAL)
    return "its numbers are in other files";
  for (int i = 0; i < H5Pget_nfilters(creation); ++i) {
    std::array<char, 64> name{};
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values,
                                               nullptr, name.size() - 1, name.data(), &config);
    if (filter < 0 || H5Zfilter_avail(filter) <= 0)
      return "packed by " + units::printable(std::string(name.data())) + ", filter " +
             std::to_string(filter) + "; h5repack -f GZIP=4 IN OUT packs it by gzip";
  }
  const Handle type{H5Dget_type(array.set), H5Tclose};
  const double bytes = static_cast<double>(array.rows) * static_cast<double>(array.columns) *
                       static_cast<double>(H5Tget_size(type));
  if (bytes > most_packing * array.file->size + 1e6)
    return "more numbers than so small a file can hold";
  return "";
}

// The data set opened again with room for the chunks that its rows are in.
void set_cache(Array& array, hid_t creation) {
  if (H5Pget_layout(creation) != H5D_CHUNKED) return;
  std::vector<hsize_t> chunk(array.extent.size());
  if (H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) < 0) return;
  const Handle type{H5Dget_type(array.set), H5Tclose};
  double bytes = static_cast<double>(H5Tget_size(type));
  for (std::size_t i = 0; i < chunk.size(); ++i) {
    const double whole = static_cast<double>(std::max<hsize_t>(chunk[i], 1));
    const double across = std::ceil(static_cast<double>(array.extent[i]) / whole);
    bytes *= i == array.row_axis ? whole : whole * across;
  }
  if (bytes > static_cast<double>(most_cached))
    throw InputError{"the data set \"" + units::printable(array.path) +
                     "\" has chunks of more than 512 MiB; h5repack -l CHUNK=4096 IN OUT makes "
                     "smaller ones"};
  const Handle access{H5Pcreate(H5P_DATASET_ACCESS), H5Pclose};
  H5Pset_chunk_cache(access, 521, std::max<std::size_t>(1 << 20, static_cast<std::size_t>(bytes)),
                     1);
  Handle again{H5Dopen2(array.file->file, ("/" + array.path).c_str(), access), H5Dclose};
  if (!again.valid()) damaged("the data set \"" + units::printable(array.path) + "\"");
  array.set = std::move(again);
}

// Walks through the groups of a file.
class Walk {
 public:
  Walk(std::shared_ptr<const File> file, Contents& contents)
      : file_(std::move(file)), contents_(contents) {}

  void group(const std::string& path, std::size_t depth) {
    const Handle group = file_->open(path);
    if (!group.valid()) damaged("the group \"/" + units::printable(path) + "\"");
    std::vector<std::string> names;
    const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* to) -> herr_t {
      auto& found = *static_cast<std::vector<std::string>*>(to);
      found.emplace_back(name);
      return found.size() > most_objects ? -1 : 0;
    };
    hsize_t at = 0;
    if (H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, &at, keep, &names) < 0) {
      if (names.size() > most_objects) too_many();
      damaged("the group \"/" + units::printable(path) + "\"");
    }
    for (const std::string& name : names) {
      if (name.starts_with('#')) continue;  // MATLAB's own
      if (++visited_ > most_objects) too_many();
      object(path, name, depth);
    }
  }

 private:
  [[noreturn]] static void too_many() {
    throw InputError{"it holds more than " + std::to_string(most_objects) + " objects"};
  }

  void unread(const std::string& path, const std::string& why) {
    if (contents_.unread.size() < 50) contents_.unread.push_back(path + " (" + why + ")");
  }

  void object(const std::string& group, const std::string& name, std::size_t depth) {
    const std::string path = group.empty() ? name : group + "/" + name;
    const Handle found = file_->open(path);
    if (!found.valid()) return unread(path, "damaged, or a link that leads out of the file");
    if (H5Iget_type(found) == H5I_GROUP && H5Aexists(found, "MATLAB_sparse") > 0)
      return unread(path, "a sparse matrix; full(...) makes it a full one");
    if (H5Iget_type(found) == H5I_GROUP) {
      if (depth < most_depth) this->group(path, depth + 1);
      return;
    }
    if (H5Iget_type(found) == H5I_DATASET) array(group, name, path);
  }

  void array(const std::string& group, const std::string& name, const std::string& path) {
    Handle set{H5Dopen2(file_->file, ("/" + path).c_str(), H5P_DEFAULT), H5Dclose};
    if (!set.valid()) return unread(path, "damaged");
    Handle space{H5Dget_space(set), H5Sclose};
    const Handle type{H5Dget_type(set), H5Tclose};
    const Handle creation{H5Dget_create_plist(set), H5Pclose};
    if (!space.valid() || !type.valid() || !creation.valid()) return unread(path, "damaged");
    const bool matlab = H5Aexists(set, "MATLAB_class") > 0;
    if (H5Aexists(set, "MATLAB_object_decode") > 0)
      return unread(path, "an object of MATLAB; table2struct(T, 'ToScalar', true) makes a struct");
    if (number(set, "MATLAB_empty").value_or(0) != 0) return;
    if (matlab && texts(set, 1, {"MATLAB_class"}) == std::vector<std::string>{"char"}) return;
    auto element = element_of(type);
    if (!element) return unread(path, "neither numbers nor texts");
    const int rank = H5Sget_simple_extent_ndims(space);
    std::vector<hsize_t> extent(static_cast<std::size_t>(std::max(rank, 0)));
    if (rank > 0) H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    Array array{file_, path, std::move(set), std::move(space), std::move(*element), extent};
    std::vector<std::size_t> long_axes;
    for (std::size_t i = 0; i < extent.size(); ++i) {
      if (extent[i] == 0) return;
      if (extent[i] > 1) long_axes.push_back(i);
    }
    if (long_axes.empty()) return;
    if (long_axes.size() > 2) return unread(path, std::to_string(long_axes.size()) + " dimensions");
    array.row_axis = matlab ? long_axes.back() : long_axes.front();
    array.rows = static_cast<std::size_t>(extent[array.row_axis]);
    if (long_axes.size() == 2) {
      array.column_axis = matlab ? long_axes.front() : long_axes.back();
      if (extent[array.column_axis] > most_columns)
        return unread(path, std::to_string(extent[array.column_axis]) + " columns");
      array.columns = static_cast<std::size_t>(extent[array.column_axis]);
    }
    if (array.columns * array.element.parts.size() > most_columns) return unread(path, "too wide");
    if (const std::string why = trouble(array, creation); !why.empty()) return unread(path, why);
    array.fill = number(array.set, "_FillValue");
    array.missing = number(array.set, "missing_value");
    array.scale = number(array.set, "scale_factor");
    array.offset = number(array.set, "add_offset");
    add(group, name, std::move(array));
  }

  void add(const std::string& group, const std::string& name, Array array) {
    DataSet set{group, name, array.rows, {}, {}};
    for (std::size_t column = 0; column < array.columns; ++column)
      for (const Part& part : array.element.parts)
        for (std::size_t i = 0; i < part.count; ++i) {
          std::string title = part.name.empty() ? name : part.name;
          if (array.columns > 1) title += "_" + std::to_string(column + 1);
          if (part.count > 1) title += "_" + std::to_string(i + 1);
          set.columns.push_back({title, ""});
        }
    const std::size_t width = set.columns.size();
    const auto titles =
        texts(array.set, width, {"columns", "column_names", "names", "headers", "labels"});
    for (std::size_t i = 0; i < titles.size() && width > 1; ++i) set.columns[i].name = titles[i];
    const std::vector<const char*> words{"units", "unit", "Units", "Unit", "UNITS", "UNIT"};
    auto units = texts(array.set, width, words);
    if (units.empty() && array.element.parts.size() == 1) {
      units = texts(array.set, 1, words);  // one for all columns
      if (!units.empty()) units.resize(width, units.front());
    }
    for (std::size_t i = 0; i < units.size(); ++i) set.columns[i].unit = units[i];
    const auto kept = std::make_shared<Array>(std::move(array));
    set.read = [kept, cached = false](std::size_t first, std::size_t count) mutable {
      if (!std::exchange(cached, true)) {
        const Handle creation{H5Dget_create_plist(kept->set), H5Pclose};
        set_cache(*kept, creation);
      }
      return read_rows(*kept, first, count);
    };
    contents_.sets.push_back(std::move(set));
  }

  std::shared_ptr<const File> file_;
  Contents& contents_;
  std::size_t visited_ = 0;
};

}  // namespace

Contents hdf5_contents(const std::filesystem::path& name) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  H5PLset_loading_state(0);  // a file names no code to be loaded
  Handle file{H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
  if (!file.valid()) damaged("the HDF5 file");
  Handle access{H5Pcreate(H5P_LINK_ACCESS), H5Pclose};
  H5Pset_elink_cb(access, refuse_link, nullptr);
  const auto opened =
      std::make_shared<File>(File{name, std::move(file), std::move(access),
                                  static_cast<double>(std::filesystem::file_size(name))});
  Contents contents;
  Walk{opened, contents}.group("", 0);
  return contents;
}

}  // namespace railbook::containers
