// Written by tools/makevars.sh; do not edit.
// clang-format off
#include "base/text_source.cpp"
#include "base/waves.cpp"
