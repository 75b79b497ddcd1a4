// Texts drawn at random, and whether what reads them refuses.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <railbook/num/random_stream.hpp>
#include <railbook/units/input_error.hpp>

namespace railbook::tests {

// A whole number from 0 to n - 1.
inline std::size_t below(num::RandomStream& draw, std::size_t n) {
  return std::min(n - 1, static_cast<std::size_t>(draw(0, static_cast<double>(n))));
}

// A decimal number as people and programs write it, of up to 38 digits and 1e-360 to 1e360 in size.
inline std::string figures(num::RandomStream& draw) {
  std::string text = std::array{"", "-", "+"}[below(draw, 3)];
  const std::size_t whole = below(draw, 20), part = below(draw, 20) + (whole == 0 ? 1 : 0);
  for (std::size_t i = 0; i < whole; ++i) text += static_cast<char>('0' + below(draw, 10));
  if (part > 0) text += '.';
  for (std::size_t i = 0; i < part; ++i) text += static_cast<char>('0' + below(draw, 10));
  if (draw(0, 1) < 0.7) {
    const int power =
        static_cast<int>(std::round(draw(0, 1) < 0.5 ? draw(-340, 340) : draw(-9, 9)));
    text += (draw(0, 1) < 0.5 ? "e" : "E") + std::to_string(power);
  }
  return text;
}

template <class Read>
bool refuses(Read read) {
  try {
    read();
  } catch (const InputError&) {
    return true;
  }
  return false;
}

}  // namespace railbook::tests
