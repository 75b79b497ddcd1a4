#include <railbook/units/nearest.hpp>

#include <algorithm>

#include <railbook/units/printable.hpp>

namespace railbook::units {
namespace {

// Damerau and Levenshtein's distance, where no piece is edited twice; case does not count.
std::size_t distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const auto same = [&](std::size_t p, std::size_t q) { return lower(a[p]) == lower(b[q]); };
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same(i - 1, j - 1) ? 0U : 1U)});
      if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1))
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t longest = 64;
  if (word.empty() || word.size() > longest) return "";
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  const std::string* best = nullptr;
  for (const std::string& one : known) {
    if (one.size() > longest) continue;
    const std::size_t far = distance(word, one);
    if (far < least && far < one.size()) least = far, best = &one;
  }
  return best == nullptr ? "" : "; did you mean \"" + printable(*best) + "\"?";
}

}  // namespace railbook::units
