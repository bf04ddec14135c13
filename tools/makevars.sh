#!/usr/bin/env bash
# Writes src/Makevars and, for each folder of the engine, src/engine/FOLDER.cpp.
#   tools/makevars.sh            run it after adding, moving or removing a file in src/
#   tools/makevars.sh --check    fails if these files are outdated
#
# Each folder of the engine is compiled as one unit, which takes a third of the time of separate files.
# Kernel files are compiled separately, because they target several processors.
#
# Packages must not use features of GNU make (wildcards, included dependency files), so src/Makevars
# lists all objects. Every object depends on every header: an edited header recompiles everything, and
# no outdated object is linked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../src"

folders() { (cd engine && printf '%s\n' */ | tr -d /); }

# Prints the sources of one unit.
sources_in() {
  (cd engine && find "$1" -name '*.cpp' ! -name '*kernels*' | LC_ALL=C sort)
}

unit() {
  printf '// Written by tools/makevars.sh; do not edit.\n// clang-format off\n'
  sources_in "$1" | sed 's/.*/#include "&"/'
}

# Prints "NAME =" and the lines of standard input as one make variable or rule.
list() {
  printf '%s' "$1"
  while IFS= read -r line; do printf ' \\\n  %s' "$line"; done
  printf '\n'
}

makevars() {
  cat <<'END'
# Written by tools/makevars.sh; do not edit.
CXX_STD = CXX17
PKG_CXXFLAGS = -pthread $(CXX_VISIBILITY)
PKG_LIBS = -pthread

END
  { ls -- *.cpp engine/*/*kernels*.cpp; for folder in $(folders); do echo "engine/$folder.cpp"; done; } |
    LC_ALL=C sort | sed 's|\.cpp$|.o|' | list 'OBJECTS ='
  echo
  find . \( -name '*.h' -o -name '*.hpp' -o -name '*.inl' \) | LC_ALL=C sort | sed 's|^\./||' |
    list 'HEADERS ='
  cat <<'END'

all: $(SHLIB)
$(OBJECTS): $(HEADERS)
END
  for folder in $(folders); do
    sources_in "$folder" | sed 's|^|engine/|' | list "engine/$folder.o:"
  done
}

# put FILE: compares standard input with the file, or writes the file.
wrong=0
if [ "${1:-}" = --check ]; then
  put() { diff -u "$1" - >&2 || wrong=1; }
else
  put() { cat >"$1.new" && mv "$1.new" "$1"; }
fi
makevars | put Makevars
for folder in $(folders); do unit "$folder" | put "engine/$folder.cpp"; done
[ "$wrong" = 0 ] || echo "Generated files in src are outdated: run tools/makevars.sh" >&2
exit "$wrong"
