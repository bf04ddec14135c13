// A model with an analytical solution to measure every time scheme.
#pragma once

#include "filled_model.hpp"

namespace codend {

// 1 kg (node 1) between two bars, both taut within 0.5 m of the middle: a linear spring of 100 N/m
// along x, hence 10 rad/s. In vacuum; starts 0.1 m from the middle.
struct Oscillator : FilledModel {
  Oscillator() {
    material(50.0);
    for (const double place : {-1.5, 0.1, 1.5}) node({place, 0.0, 0.0}, place != 0.1);
    model.mass[1] = 1.0;
    for (const int one : {0, 1}) bar(one, one + 1, 1.0, 0);
    model.prepare();
  }
};

}  // namespace codend
