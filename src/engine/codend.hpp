// The engine as a library: reads and builds models, settles them, computes their forces and moves
// them in time. Needs C++17 and Eigen 3.4; it does not use R.
//
//   make -C tests/engine library     builds tests/engine/build/optimised/libcodend.a
//   c++ -std=c++17 -I src/engine -isystem /usr/include/eigen3 program.cpp libcodend.a -pthread
//
// Fill a model field by field and call Model::prepare(), or read it from named arrays with
// read_fields(), which checks every array. settle(), evaluate() and TimeIntegration work with an
// Assembly of the model. tests/engine/programs/settle_file.cpp is a complete program. Gears are read
// in the same way. This program builds, settles and measures a gear, then integrates its motion for
// ten seconds in the same conditions:
//
//   const auto numbers = codend::read_fields<codend::GearNumbers>(codend::TextSource(text));
//   const codend::GearSettling how;  // with some 1,500 nodes
//   const codend::SettledGear found = codend::settle_gear(numbers, how);
//   const std::vector<double> errors = codend::errors_of(numbers, how, found);
//   for (std::size_t k = 0; k < errors.size(); ++k) {
//     std::printf("%g +- %g\n", found.measures[k], errors[k]);
//   }
//   codend::Assembly assembly(found.gear.model);
//   const codend::Motion start = codend::at_rest(found.position);
//   codend::SteadyConditions conditions(found.gear.model.held, start);
//   codend::IntegrationControl control;
//   control.adaptive = true;
//   const auto steps = codend::scheme_named("tr_bdf2").make(assembly, {0.01}, start, start.x);
//   codend::TimeIntegration integration(assembly, *steps, conditions, control, {start, start});
//   integration.to(10);
//
// SI units. x aft, y to starboard, z up, 0 at the surface. Invalid input throws InputError.
// Functions keep no state between calls: models in different threads are independent.
#pragma once

#include "base/error.hpp"
#include "base/field_table.hpp"
#include "base/fields.hpp"
#include "base/read_fields.hpp"
#include "base/text_source.hpp"
#include "gear/mesh.hpp"
#include "measure/measures.hpp"
#include "measure/near_gear.hpp"
#include "measure/settled_gear.hpp"
#include "model/assembly.hpp"
#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "motion/scheduled_conditions.hpp"
#include "motion/schemes.hpp"
#include "motion/time_integration.hpp"
#include "solve/layout.hpp"
#include "solve/settle.hpp"
