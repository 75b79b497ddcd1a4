// The word that may have been meant, where that is written otherwise or is one of many.
#include <railbook/units/nearest.hpp>

#include <catch2/catch.hpp>
#include <string>

using railbook::units::did_you_mean;

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
