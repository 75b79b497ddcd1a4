#pragma once

// The sum.
inline int add(int a, int b) {
  return a + b;
}
