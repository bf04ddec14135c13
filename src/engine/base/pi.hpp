// Pi, which C++17 does not define.
#pragma once

namespace codend {

constexpr double pi = 3.14159265358979323846;

}  // namespace codend
