// Written by tools/makevars.sh; do not edit.
#include "base/text_source.cpp"
#include "base/waves.cpp"
