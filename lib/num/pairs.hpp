// Two numbers at once, in an order that is the same on every processor.
#pragma once

#include <cstring>

namespace railbook::num {

using Pair = double __attribute__((vector_size(16)));
using PairMask = decltype(Pair{} < Pair{});

inline Pair pair_at(const double* at) {
  Pair pair;
  std::memcpy(&pair, at, sizeof pair);
  return pair;
}
inline void store(Pair pair, double* at) {
  std::memcpy(at, &pair, sizeof pair);
}

inline Pair both(double value) {
  return Pair{value, value};
}
inline Pair absolute(Pair pair) {
  return reinterpret_cast<Pair>(reinterpret_cast<PairMask>(pair) & 0x7fffffffffffffff);
}
inline Pair only(PairMask mask, Pair pair) {  // elsewhere 0
  return reinterpret_cast<Pair>(reinterpret_cast<PairMask>(pair) & mask);
}
inline PairMask is_number(Pair pair) {  // which comparisons must be, or they raise a flag
  return pair == pair;
}
inline bool any(PairMask mask) {
  return (mask[0] | mask[1]) != 0;
}

// Of numbers.
inline Pair smaller(Pair a, Pair b) {
  return a < b ? a : b;
}
inline Pair larger(Pair a, Pair b) {
  return a > b ? a : b;
}

}  // namespace railbook::num
