#include <railbook/units/printable.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace railbook::units {
namespace {

// Bytes of the UTF-8 character at the start of `text` that a terminal only draws; 0 for anything
// else.
std::size_t drawn(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (size > text.size()) return 0;
  std::uint32_t point = first & (0x7fU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    point = point << 6 | (byte(i) & 0x3fU);
  }
  // Overlong forms, halves of UTF-16's pairs and what is beyond Unicode; first of all lone bytes of
  // a character's rest.
  constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
  if (first < 0xc0 || first > 0xf7 || point < least[size] || point > 0x10ffff) return 0;
  if (point >= 0xd800 && point <= 0xdfff) return 0;
  if (point < 0xa0) return 0;  // the control characters of ISO 8859
  // Line breaks and marks that turn the direction of writing (Unicode's Bidi_Control).
  if (point == 0x61c || point == 0x200e || point == 0x200f ||
      (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069))
    return 0;
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
