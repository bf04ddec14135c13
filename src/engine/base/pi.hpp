// Ratio of a circle's circumference to its diameter, which C++17 does not name.
#pragma once

namespace codend {

constexpr double pi = 3.14159265358979323846;

}  // namespace codend
