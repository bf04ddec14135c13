#pragma once

#include <string>

#include "../model/model.hpp"
#include "schedule.hpp"

namespace codend {

// Throws InputError with the name of the field if a curve has no piece, its arrays differ in
// length, its times do not increase, or a number is not finite.
void check_curve(const Curve& curve, const std::string& field);

// Throws InputError with the field, such as "schedule.growing[2].rest" (counted from 1), if array
// lengths differ or a number is NaN or infinite where it must be finite.
void check_schedule(const Schedule& schedule);

// Also checks all indices of nodes, points and elements against the model.
void check_schedule(const Schedule& schedule, const Model& model);

}  // namespace codend
