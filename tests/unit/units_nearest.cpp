// The word that may have been meant, against the distance by its definition.
#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <random>
#include <string>

#include "units/nearest.hpp"

using railbook::units::did_you_mean;

namespace {
// Left out, put in, changed or swapped, from the ends of both words.
std::size_t edits(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string a1 = a.substr(1), b1 = b.substr(1);
  std::size_t least = edits(a1, b1) + (a[0] == b[0] ? 0 : 1);
  least = std::min({least, edits(a1, b) + 1, edits(a, b1) + 1});
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    least = std::min(least, edits(a.substr(2), b.substr(2)) + 1);
  return least;
}
}  // namespace

TEST_CASE("unit: one word is meant when it takes at most a third of the letters to edit") {
  std::mt19937 random(7);
  int meant = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto word = [&] {
      std::string text(1 + random() % 6, ' ');
      for (char& c : text) c = static_cast<char>('a' + random() % 3);
      return text;
    };
    const std::string typed = word(), known = word();
    const std::size_t far = edits(typed, known);
    const bool near = far <= std::max<std::size_t>(1, typed.size() / 3) && far < known.size();
    CHECK((did_you_mean(typed, {known}) == (near ? "; did you mean \"" + known + "\"?" : "")));
    meant += near ? 1 : 0;
  }
  CHECK(meant > 300);
}

TEST_CASE("unit: the nearest of several, the first of equals, whatever the case, none of a page") {
  CHECK(did_you_mean("clasify", {"measure", "classify", "classified"}) ==
        "; did you mean \"classify\"?");
  CHECK(did_you_mean("bat", {"cat", "hat"}) == "; did you mean \"cat\"?");
  CHECK(did_you_mean("hertz", {"HERTZ", "herts"}) == "; did you mean \"HERTZ\"?");
  CHECK(did_you_mean("[{", {"{["}) == "; did you mean \"{[\"?");
  CHECK(did_you_mean("z@", {"zA", "zz"}) == "; did you mean \"zA\"?");
  CHECK(did_you_mean("a`", {"a@"}) == "; did you mean \"a@\"?");
  CHECK(did_you_mean("", {"a"}).empty());
  CHECK(did_you_mean("abc", {}).empty());
  const std::string longest(64, 'a'), longer(65, 'a');
  CHECK_FALSE(did_you_mean(longest, {std::string(63, 'a')}).empty());
  CHECK_FALSE(did_you_mean(std::string(63, 'a'), {longest}).empty());
  CHECK(did_you_mean(longer, {longest}).empty());
  CHECK(did_you_mean(longest, {longer}).empty());
}
