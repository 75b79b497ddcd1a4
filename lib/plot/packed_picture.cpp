#include <railbook/plot/packed_picture.hpp>

#include <zlib.h>

#include <cstdint>
#include <optional>

namespace railbook::plot {
namespace {

constexpr std::size_t signature = 8, around = 12;  // bytes; of a chunk those around its data

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

std::string bytes_of(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

const Bytef* bytes_in(std::string_view text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

// A chunk begins with the length of its data, and ends with a sum over its type and its data.
std::string chunk(const std::string& type, const std::string& data) {
  const std::string summed = type + data;
  const auto sum = crc32(0, bytes_in(summed), static_cast<uInt>(summed.size()));
  return bytes_of(static_cast<std::uint32_t>(data.size())) + summed +
         bytes_of(static_cast<std::uint32_t>(sum));
}

std::optional<std::string> unpacked(const std::string& packed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return std::nullopt;
  stream.next_in = const_cast<Bytef*>(bytes_in(packed));
  stream.avail_in = static_cast<uInt>(packed.size());
  std::string pixels;
  int status = Z_OK;
  while (status == Z_OK) {
    const std::size_t before = pixels.size();
    pixels.resize(before + (std::size_t{1} << 20));
    stream.next_out = reinterpret_cast<Bytef*>(pixels.data() + before);
    stream.avail_out = 1U << 20;
    status = inflate(&stream, Z_NO_FLUSH);
    pixels.resize(pixels.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END ? std::optional{pixels} : std::nullopt;
}

std::string packed(const std::string& pixels, int strategy) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15, 9, strategy) != Z_OK) return "";
  std::string result(deflateBound(&stream, static_cast<uLong>(pixels.size())), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_in(pixels));
  stream.avail_in = static_cast<uInt>(pixels.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int status = deflate(&stream, Z_FINISH);
  result.resize(status == Z_STREAM_END ? stream.total_out : 0);
  deflateEnd(&stream);
  return result;
}

}  // namespace

std::string packed_png(std::string_view png) {
  std::string before, data, after;
  std::size_t at = signature;
  while (at + around <= png.size()) {
    const std::size_t length = number_at(png, at);
    if (length > png.size() - at - around) break;
    if (png.substr(at + 4, 4) == "IDAT")
      data += png.substr(at + 8, length);
    else
      (data.empty() ? before : after) += png.substr(at, length + around);
    at += length + around;
  }
  const std::optional<std::string> pixels = unpacked(data);
  if (at != png.size() || !pixels) return std::string{png};
  std::string smallest{png};
  for (const int strategy : {Z_DEFAULT_STRATEGY, Z_FILTERED}) {
    const std::string again = packed(*pixels, strategy);
    const std::string candidate =
        std::string{png.substr(0, signature)} + before + chunk("IDAT", again) + after;
    if (!again.empty() && candidate.size() < smallest.size()) smallest = candidate;
  }
  return smallest;
}

}  // namespace railbook::plot
