// Options of the grid solver with so many cells.
#pragma once

#include "contact/cg_fft.hpp"

inline railbook::contact::CgFftOptions cells(Eigen::Index nx, Eigen::Index ny) {
  railbook::contact::CgFftOptions options;
  options.nx = nx;
  options.ny = ny;
  return options;
}
