#include <catch2/catch.hpp>
#include <limits>

#include <railbook/contact/bodies.hpp>
#include <railbook/units/input_error.hpp>

using namespace railbook;
using namespace railbook::contact;

TEST_CASE("input: bodies that make no contact problem are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Profile bowl{Eigen::VectorXd::LinSpaced(9, -1, 1),
                     Eigen::VectorXd::LinSpaced(9, -1, 1).array().square()};
  const Body wheel{.radius_x = -3, .radius_y = 0.5};
  CHECK_THROWS_WITH(join_bodies({.radius_x = 0}, wheel), Catch::Contains("radius"));
  CHECK_THROWS_WITH(join_bodies({.radius_x = nan}, wheel), Catch::Contains("radius"));
  CHECK_THROWS_AS(join_bodies({.radius_x = 4, .radius_y = 1}, wheel),
                  InputError);  // too flat for the hollow
  CHECK_THROWS_WITH(join_bodies({.profile = bowl}, {}), Catch::Contains("along the rail"));
  CHECK_THROWS_WITH(join_bodies({.profile = bowl, .radius_y = 1}, wheel, 0.1),
                    Catch::Contains("angle"));
  Profile bad = bowl;
  bad.depth[3] = nan;
  CHECK_THROWS_WITH(join_bodies({.profile = bad, .radius_y = 1}, {}), Catch::Contains("point 4"));
  bad = bowl;
  bad.x[4] = bad.x[3];
  CHECK_THROWS_WITH(join_bodies({.profile = bad, .radius_y = 1}, {}), Catch::Contains("rise"));
  bad = bowl;
  bad.depth[3] = 1e308;
  CHECK_THROWS_WITH(join_bodies({.profile = bad, .radius_y = 1}, {}),
                    Catch::Contains("allowed: -1e+06 m to 1e+06 m"));
  CHECK_THROWS_WITH(join_bodies({.radius_x = 1e-300}, wheel), Catch::Contains("allowed"));
  CHECK_THROWS_WITH(join_bodies({.radius_x = 1e300}, wheel), Catch::Contains("allowed"));
  bad = {bowl.x.head(4), bowl.depth.head(4)};
  CHECK_THROWS_WITH(join_bodies({.profile = bad, .radius_y = 1}, {}),
                    Catch::Contains("at least 5"));
  Profile ramp{bowl.x, bowl.x};
  CHECK_THROWS_WITH(join_bodies({.profile = ramp, .radius_y = 1}, {}),
                    Catch::Contains("end of the profile"));
  Profile far{bowl.x.array() + 5, bowl.depth};
  CHECK_THROWS_WITH(join_bodies({.profile = bowl, .radius_y = 1}, {.profile = far}),
                    Catch::Contains("in common"));
}
