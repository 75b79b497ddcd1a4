#include <railbook/tool/summary.hpp>

#include <catch2/catch.hpp>
#include <limits>

#include <railbook/units/input_error.hpp>

using namespace railbook;
using Catch::Matchers::Contains;

TEST_CASE("unit: a summary keeps numbers, texts, absences and doubts apart") {
  tool::Summary s("an answer");
  s.add("force_N", "force", 2.5, "N", "about");
  s.add("theory", "theory", "nan");
  s.absent("peak_Pa", "peak pressure", "no contact");
  s.warn("coarse", "two cells");
  s.add("place", "place", "Zürich");
  s.add("v", "speed", tool::Estimate{144.5387123, 0.0213456}, "ft/s");
  s.add("w", "width", tool::Estimate{2, std::numeric_limits<double>::infinity()}, "m", "rough");
  s.add_to_json("part_m", 0.25, "m");
  const std::string json = s.json();
  CHECK_THAT(json, Contains("\"force_N\": 2.5") && Contains("\"theory\": \"nan\""));
  CHECK_THAT(json, Contains("\"peak_Pa\": null") && Contains("\"peak_Pa\": \"no contact\""));
  CHECK_THAT(json, Contains("\"coarse\": \"two cells\"") && Contains("Zürich"));
  CHECK_THAT(json, Contains("\"v\": 144.5387123") && Contains("\"v\": 0.0213456"));
  CHECK_THAT(json, Contains("\"w\": null") && Contains("error not known; rough"));
  CHECK_THAT(json, Contains("\"part_m\": 0.25") && Contains("\"part_m\": \"m\""));
}

TEST_CASE("unit: a summary refuses a number that is none, by its name") {
  tool::Summary s("an answer");
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(s.add("a_m", "length", infinity, "m"), InputError);
  CHECK_THROWS_WITH(s.add("a_m", "length", -infinity, "m"),
                    Contains("length (a_m)") && Contains("infinite"));
  CHECK_THROWS_WITH(s.add("a_m", "  length", std::numeric_limits<double>::quiet_NaN(), "m"),
                    Contains("length (a_m): the result is not a number"));
  CHECK_THROWS_WITH(s.add("a_m", "", infinity, "m"), Contains("a_m (a_m)"));
  CHECK_THROWS_WITH(s.add("a_m", "  ", infinity, "m"), Contains("a_m"));
  s.add("b_m", "largest", std::numeric_limits<double>::max(), "m");
}
