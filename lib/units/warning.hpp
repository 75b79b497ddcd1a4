// What a user should know before trusting an answer.
#pragma once

#include <string>

namespace railbook::units {

// "stuck", "7000 samples in a row are equal ...". The key is for programs, the text for people.
struct Warning {
  std::string key, text;
  bool operator==(const Warning&) const = default;
};

}  // namespace railbook::units
