// Written by tools/makevars.sh; do not edit.
// clang-format off
#include "model/assembly.cpp"
#include "model/block_places.cpp"
#include "model/cell_list.cpp"
#include "model/evaluate.cpp"
#include "model/joined_mass.cpp"
#include "model/wake.cpp"
