#include <railbook/table/detail/zip.hpp>

#include <zlib.h>

#include <algorithm>
#include <new>

#include <railbook/units/input_error.hpp>
#include <railbook/units/printable.hpp>

namespace railbook::table {
namespace {

[[noreturn]] void damaged_zip() {
  throw InputError{"the zip archive is damaged or cut off"};
}

// A number of 2 or 4 bytes, the lowest first.
std::size_t field(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at > bytes.size() || bytes.size() - at < count) damaged_zip();
  std::size_t value = 0;
  for (std::size_t i = count; i > 0; --i)
    value = 256 * value + static_cast<unsigned char>(bytes[at + i - 1]);
  return value;
}

}  // namespace

Zip::Zip(std::string_view archive) : archive_(archive) {
  const std::size_t end = archive.rfind("PK\x05\x06");
  if (end == archive.npos) damaged_zip();
  const std::size_t count = field(archive, end + 10, 2);
  std::size_t at = field(archive, end + 16, 4);
  for (std::size_t i = 0; i < count; ++i) {
    if (field(archive, at, 4) != 0x02014b50) damaged_zip();
    const std::size_t length = field(archive, at + 28, 2);
    if (archive.size() - at < 46 + length) damaged_zip();
    const std::string name{archive.substr(at + 46, length)};
    files_[name] = {field(archive, at + 10, 2), field(archive, at + 20, 4),
                    field(archive, at + 24, 4), field(archive, at + 42, 4),
                    field(archive, at + 8, 2) % 2 == 1};
    at += 46 + length + field(archive, at + 30, 2) + field(archive, at + 32, 2);
  }
}

std::string Zip::read(const std::string& name) {
  const auto found = files_.find(name);
  if (found == files_.end()) throw InputError{"the zip archive holds no " + units::printable(name)};
  const File& file = found->second;
  if (file.encrypted) throw InputError{"the zip archive is encrypted"};
  if (file.size > left_) throw InputError{"the zip archive unpacks to more than 512 MiB"};
  left_ -= file.size;
  const std::size_t begin =
      file.at + 30 + field(archive_, file.at + 26, 2) + field(archive_, file.at + 28, 2);
  if (begin > archive_.size() || archive_.size() - begin < file.packed) damaged_zip();
  const std::string_view packed = archive_.substr(begin, file.packed);
  if (file.method == 0) {
    if (file.size != file.packed) damaged_zip();
    return std::string{packed};
  }
  if (file.method != 8)
    throw InputError{"the zip archive is packed by another method than deflate"};
  // What it unpacks to is believed only as it comes.
  z_stream z{};
  if (inflateInit2(&z, -15) != Z_OK) throw std::bad_alloc();
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // zlib only reads it
  z.avail_in = static_cast<uInt>(packed.size());
  std::string text;
  int status = Z_OK;
  while (status == Z_OK && text.size() <= file.size) {
    const std::size_t before = text.size();
    text.resize(before + (std::size_t{1} << 16));
    z.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    z.avail_out = 1U << 16;
    status = inflate(&z, Z_NO_FLUSH);
    text.resize(text.size() - z.avail_out);
  }
  inflateEnd(&z);
  if (status != Z_STREAM_END || text.size() != file.size) damaged_zip();
  return text;
}

}  // namespace railbook::table
