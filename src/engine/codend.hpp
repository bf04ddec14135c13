// The engine as a library: all that a program needs that reads or builds models, settles them, asks what
// acts on them and moves them in time. Needs C++17 and Eigen 3.4, and no R.
//
//   make -C tests/engine library     builds tests/engine/build/optimised/libcodend.a
//   c++ -std=c++17 -I src/engine -isystem /usr/include/eigen3 program.cpp libcodend.a -pthread
//
// A model is filled field by field, then Model::prepare() called, or read from any source of named
// arrays (read_fields(), with the checks of every array); an Assembly over it is what settle(),
// evaluate() and March work with. tests/engine/programs/settle_file.cpp is a whole program. A gear is read
// in the same way, built, settled and measured; then its model is marched for ten seconds in the conditions
// that it is settled in:
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
//   codend::MarchControl control;
//   control.adaptive = true;
//   const auto steps = codend::scheme_named("bdf2").make(assembly, {0.01}, start, start.x);
//   codend::March march(assembly, *steps, conditions, control, {start, start});
//   march.to(10);
//
// SI units. x aft, y to starboard, z up, 0 at the surface. What makes no sense throws InputError.
// Functions keep no state between calls: models in different threads are independent.
#pragma once

#include "base/error.hpp"
#include "base/field_table.hpp"
#include "base/fields.hpp"
#include "base/read_fields.hpp"
#include "base/text_source.hpp"
#include "gear/lattice.hpp"
#include "march/march.hpp"
#include "march/scheduled_conditions.hpp"
#include "march/schemes.hpp"
#include "measure/measures.hpp"
#include "measure/near_gear.hpp"
#include "measure/settled_gear.hpp"
#include "model/assembly.hpp"
#include "model/evaluate.hpp"
#include "model/model.hpp"
#include "solve/layout.hpp"
#include "solve/settle.hpp"
