// Numbers in the messages of this folder: eight digits, whatever the size.
#pragma once

#include <cstdio>
#include <string>

namespace railbook::units {

inline std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", value);
  return text;
}

}  // namespace railbook::units
