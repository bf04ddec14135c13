#!/usr/bin/env bash
# Writes src/Makevars, and src/engine/FOLDER.cpp for each folder of the engine, from the source files
# that there are.
#   tools/makevars.sh            after a file in src/ has been added, moved or removed
#   tools/makevars.sh --check    says nothing and succeeds if these files are in step
# A folder of the engine is compiled as one unit, which takes a third of the time of its files one by
# one. Files of kernels stay alone: they are compiled for several processors.
# R takes sources in folders only as a list of objects, and packages may not rely on what only GNU
# make offers (wildcards, included dependency files). So every object depends on every header: one
# header's edit compiles everything again, and no object of an older header is ever linked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../src"

folders() { (cd engine && printf '%s\n' */ | tr -d /); }

# The sources in one unit.
sources_in() {
  (cd engine && find "$1" -name '*.cpp' ! -name '*kernels*' | LC_ALL=C sort)
}

unit() {
  printf '// Written by tools/makevars.sh; do not edit.\n// clang-format off\n'
  sources_in "$1" | sed 's/.*/#include "&"/'
}

# Prints "NAME =" and the lines of its standard input as one make variable or rule.
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

# Compares standard input with a file, or writes it to the file.
wrong=0
if [ "${1:-}" = --check ]; then
  put() { diff -u "$1" - >&2 || wrong=1; }
else
  put() { cat >"$1.new" && mv "$1.new" "$1"; }
fi
makevars | put Makevars
for folder in $(folders); do unit "$folder" | put "engine/$folder.cpp"; done
[ "$wrong" = 0 ] || echo "Generated files of src are out of step with the files: run tools/makevars.sh" >&2
exit "$wrong"
