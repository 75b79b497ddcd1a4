// The Manchester contact benchmark, case A: S1002 on UIC60 at 1:40, 20 kN, 2 m/s, friction 0.3, G =
// 82 GPa, nu = 0.28. Inputs and results of case A2.2 are of CONTACT's example (E. Vollebregt and J.
// J. Kalker, open-source version, mbench_a22_left and mbench_a22_right); lengths mm, um, forces N,
// moments N mm, pressures MPa.
#pragma once

#include <array>

#include <railbook/wheel_contact/wheel.hpp>

namespace railbook::tests {

// Pose of the wheelset at y = 0, 1, ... 10 mm, with 2.4 mrad of yaw a millimetre.
struct BenchmarkPose {
  double roll_urad, angular_velocity;
};
inline constexpr std::array<BenchmarkPose, 11> benchmark_poses{{{0, 4.3481181},
                                                                {-50.49, 4.3465752},
                                                                {-112.80, 4.3459197},
                                                                {-180.30, 4.3451503},
                                                                {-255.70, 4.3440930},
                                                                {-355.40, 4.3353637},
                                                                {-627.20, 4.3293718},
                                                                {-6393.00, 4.2635629},
                                                                {-8606.00, 4.2534857},
                                                                {-10101.13, 4.2477561},
                                                                {-11264.31, 4.2436375}}};

struct BenchmarkWheel {
  double z, y_r, y_w, delta, xi, eta, phi, normal, fx, fs, mz, approach,
      p_max;  // xi, eta in 1e-3; phi in 1e-5/mm
};
inline constexpr std::array<BenchmarkWheel, 11> benchmark_left{{
    {0.1981, 8.6600, -1.8726, 0.0290, -0.05665, 0, -6.302, 9997, 0.2783, 253.6, 4605, 15.96, 338.3},
    {0.1840, 5.2886, -6.2694, 0.0176, -0.6297, 2.4, -3.848, 10050, 829.2, -2893, 376.0, 19.46,
     423.9},
    {0.1530, 4.0270, -8.5660, 0.0134, -0.8651, 4.798, -2.947, 10040, 546.3, -2961, 143.4, 20.54,
     465.9},
    {0.1145, 3.2967, -10.3382, 0.0110, -1.103, 7.197, -2.432, 10030, 460.5, -2974, 80.74, 21.28,
     498.8},
    {0.0680, 2.8681, -11.8167, 0.0096, -1.399, 9.594, -2.138, 10030, 436.6, -2977, 54.89, 21.85,
     527.2},
    {0.0019, 2.6368, -13.1136, 0.0088, -3.462, 11.98, -1.99, 10030, 837.8, -2889, 48.32, 22.32,
     552.8},
    {-0.1957, 2.5116, -14.3878, 0.0084, -4.901, 14.37, -1.957, 10020, 973.1, -2845, 41.57, 22.78,
     578.5},
    {-4.5803, 1.9234, -18.6704, 0.0064, -20.35, 16.63, -2.761, 10010, 2327, -1900, 45.23, 24.12,
     666.7},
    {-6.2606, 2.3103, -20.3458, 0.0077, -22.81, 18.99, -3.511, 10020, 2310, -1921, 40.02, 24.58,
     701.1},
    {-7.3913, 2.8403, -21.5501, 0.0095, -24.25, 21.35, -4.21, 10020, 2257, -1985, 34.39, 24.89,
     725.3},
    {-8.2662, 3.4351, -22.5401, 0.0115, -25.32, 23.71, -4.883, 10020, 2196, -2054, 32.16, 25.11,
     744.0},
}};
inline constexpr std::array<BenchmarkWheel, 11> benchmark_right{{
    {0.1981, -8.6600, 1.8726, -0.0290, -0.05665, 0, 6.302, 9997, 0.2783, -253.6, -4605, 15.96,
     338.3},
    {0.1839, -18.5418, -9.0305, -0.0696, 0.6943, 2.407, 15.1, 9827, -814.3, -2832, -227.9, 24.48,
     741.3},
    {0.1529, -19.6178, -11.1296, -0.0806, 0.8752, 4.818, 17.46, 9799, -517.3, -2893, -37.57, 24.80,
     744.8},
    {0.1143, -20.5627, -13.0963, -0.0923, 1.052, 7.235, 19.98, 9774, -417.5, -2902, -23.90, 24.39,
     713.2},
    {0.0676, -21.7944, -15.3505, -0.1078, 1.276, 9.662, 23.3, 9745, -379.6, -2898, -24.06, 23.70,
     664.4},
    {0.0015, -33.4470, -28.0471, -0.2905, 4.174, 12.55, 61.88, 9619, -763.3, -2738, -826.6, 27.19,
     1556},
    {-0.1961, -35.3954, -31.1222, -0.4176, 5.077, 15.8, 87.44, 9709, -880.0, -2775, 59.67, 27.28,
     1149},
    {-4.5809, -41.4881, -41.1389, -1.0634, 19.49, 34.57, 183.8, 14030, -2079, -3644, -654.2, 35.63,
     2622},
    {-6.2615, -40.7010, -42.3894, -0.9501, 21.27, 33, 170.1, 12720, -2070, -3195, -516.1, 34.94,
     2634},
    {-7.3919, -40.0422, -43.4346, -0.8676, 22.66, 33.41, 158.8, 11970, -2014, -2963, -411.9, 34.47,
     2640},
    {-8.2668, -39.4446, -44.3815, -0.7992, 23.78, 34.45, 148.6, 11440, -1947, -2820, -333.7, 34.11,
     2643},
}};

inline constexpr double benchmark_rail_origin = 760.5326;  // mm from the middle of the track

inline const wheel_contact::ProfilePair& benchmark_pair() {
  static const auto pair = wheel_contact::s1002_on_60e1(1.0 / 40, profiles::Rail60::benchmark);
  return pair;
}
inline wheel_contact::Pose benchmark_pose(std::size_t i) {
  const double y = static_cast<double>(i);
  return {1e-3 * y, 2.4e-3 * y, 1e-6 * benchmark_poses[i].roll_urad};
}
inline wheel_contact::WheelInput benchmark_wish(std::size_t i) {
  wheel_contact::WheelInput input;
  input.load = 10e3, input.speed = 2, input.angular_velocity = benchmark_poses[i].angular_velocity;
  input.wheel = input.rail = {2 * 82e9 * 1.28, 0.28};
  return input;
}

}  // namespace railbook::tests
