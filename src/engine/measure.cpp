// Written by tools/makevars.sh; do not edit.
// clang-format off
#include "measure/filled_bag.cpp"
#include "measure/frame.cpp"
#include "measure/measure_errors.cpp"
#include "measure/measured_gear.cpp"
#include "measure/measures.cpp"
#include "measure/meshes.cpp"
#include "measure/near_gear.cpp"
#include "measure/settled_gear.cpp"
