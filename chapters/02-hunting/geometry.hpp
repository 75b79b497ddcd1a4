// The three pairs of wheel and rail as this chapter names them.
#pragma once

#include <array>

#include "wheelrail/paper_pairs.hpp"

namespace railbook::hunting {

struct NamedPair {
  const char* key;
  const char* name;
  const wheelrail::WheelsetOnTrack& (*pair)();
  const wheelrail::ConstraintFunctions& (*table)();
};

inline constexpr std::array<NamedPair, 3> paper_pairs{
    {{"new", "new wheel, worn rail", wheelrail::new_wheel_pair, wheelrail::new_wheel_table},
     {"cn", "CN profile A, new rail", wheelrail::cn_pair, wheelrail::cn_table},
     {"heumann", "modified Heumann, worn rail", wheelrail::heumann_pair,
      wheelrail::heumann_table}}};

}  // namespace railbook::hunting
