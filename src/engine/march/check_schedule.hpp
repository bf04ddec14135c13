// Whether a schedule makes sense, before anything is computed by it.
#pragma once

#include <string>

#include "../model/model.hpp"
#include "schedule.hpp"

namespace codend {

// Throws InputError with the field, whose name begins as told, where a curve has no piece, its arrays do
// not fit together, its times do not grow or a number is not finite.
void check_curve(const Curve& curve, const std::string& field);

// Throws InputError with the field, counted from 1 (such as "schedule.groups[2].rest"), where lengths of
// arrays do not fit together, or a number is none or infinite where it must not be.
void check_schedule(const Schedule& schedule);

// The same, and whether all places are those of nodes, points and elements of the model.
void check_schedule(const Schedule& schedule, const Model& model);

}  // namespace codend
