#include <cctype>
#include <vector>

#include "quality/column_names.hpp"

namespace railbook::quality_tool {
namespace {

// Its words in small letters, letters and digits apart but for d0 to d3; what stands in brackets is
// the unit.
std::vector<std::string> words_of(const std::string& header) {
  std::vector<std::string> words;
  std::string word;
  const auto end = [&] {
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < header.size() && header[i] != '[' && header[i] != '('; ++i) {
    const auto c = static_cast<unsigned char>(header[i]);
    if (std::isalnum(c) == 0) {
      end();
      continue;
    }
    const bool digit = std::isdigit(c) != 0;
    const bool band = digit && word == "d";
    if (!word.empty() && !band &&
        digit != (std::isdigit(static_cast<unsigned char>(word.back())) != 0))
      end();
    word += static_cast<char>(std::tolower(c));
  }
  end();
  return words;
}

}  // namespace

std::optional<std::string> band_in_name(const std::string& header) {
  for (const std::string& word : words_of(header))
    if (word.size() == 2 && word[0] == 'd' && word[1] >= '0' && word[1] <= '3')
      return "D" + word.substr(1);
  return std::nullopt;
}

std::optional<int> high_pass_in_name(const std::string& header) {
  const std::vector<std::string> words = words_of(header);
  for (std::size_t i = 1; i < words.size(); ++i)
    if (words[i] == "m" && (words[i - 1] == "35" || words[i - 1] == "70"))
      return words[i - 1] == "35" ? 35 : 70;
  return std::nullopt;
}

bool is_offset_by_name(const std::string& header) {
  if (high_pass_in_name(header)) return false;
  const std::vector<std::string> words = words_of(header);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string before = i > 0 ? words[i - 1] : "";
    if (word == "mco" || word == "midchord" || word == "chord" || word.starts_with("versine") ||
        word.starts_with("midord") || (before == "mid" && word.starts_with("ord")))
      return true;
    if (word == "31" || word == "62" || word == "124") return true;
    const bool unit = word == "ft" || word == "foot" || word == "feet" || word == "m";
    if (unit && before.size() >= 2 && before.find_first_not_of("0123456789") == std::string::npos)
      return true;
  }
  return false;
}

}  // namespace railbook::quality_tool
