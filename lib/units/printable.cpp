#include "units/printable.hpp"

#include <algorithm>
#include <cstdio>

namespace railbook::units {
namespace {

// Bytes of the UTF-8 character at the start of `text` that a terminal only draws; 0 for anything else.
std::size_t drawn(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  if (first == 0xc2 && byte(1) < 0xa0) return 0;  // the control characters of ISO 8859
  // Marks that turn the direction of writing (U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069).
  if (first == 0xe2 && byte(1) == 0x80 &&
      (byte(2) == 0x8e || byte(2) == 0x8f || (byte(2) >= 0xa8 && byte(2) <= 0xae)))
    return 0;
  if (first == 0xe2 && byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9) return 0;
  return size;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t size = drawn(text.substr(i, 4));
    if (i + std::max<std::size_t>(size, 1) > most)
      return shown + "... (" + std::to_string(text.size()) + " bytes)";
    if (size > 0) {
      shown += text.substr(i, size);
      i += size;
    } else {
      char escape[5];
      std::snprintf(escape, sizeof escape, "\\x%02x", static_cast<unsigned char>(text[i++]));
      shown += escape;
    }
  }
  return shown;
}

}  // namespace railbook::units
