// The engine as a library: all that a program needs that reads or builds models, settles them, asks what
// acts on them and moves them in time. Needs C++17 and Eigen 3.4, and no R.
//
//   make -C tests/engine library     builds tests/engine/build/optimised/libcodend.a
//   c++ -std=c++17 -I src/engine -isystem /usr/include/eigen3 program.cpp libcodend.a -pthread
//
// A model is filled field by field, then Model::prepare() called, or read from any source of named
// arrays (read_fields(), with the checks of every array); an Assembly over it is what settle(),
// evaluate() and March work with. tests/engine/programs/settle_file.cpp is a whole program. A gear is read
// in the same way, built, settled and measured (programs/settle_gear.cpp):
//
//   const auto numbers = codend::read_fields<codend::GearNumbers>(codend::TextSource(text));
//   codend::GearSettling how;
//   how.nodes = 1500;
//   const codend::SettledGear found = codend::settle_gear(numbers, how);
//   for (const double value : found.measures) std::printf("%.17g\n", value);
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
