// A guard for a test: no invalid operation and no division by zero until its end.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include <railbook/num/fp_flags.hpp>

struct NoFpFault {
  NoFpFault() = default;
  ~NoFpFault() { CHECK(std::string(flags.raised()).empty()); }
  NoFpFault(const NoFpFault&) = delete;
  NoFpFault& operator=(const NoFpFault&) = delete;
  railbook::num::FpFlags flags;
};
