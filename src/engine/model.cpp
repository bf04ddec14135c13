// Written by tools/makevars.sh; do not edit.
#include "model/assembly.cpp"
#include "model/block_places.cpp"
#include "model/cell_list.cpp"
#include "model/evaluate.cpp"
#include "model/joined_mass.cpp"
#include "model/wake.cpp"
