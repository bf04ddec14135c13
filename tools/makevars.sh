#!/usr/bin/env bash
# Writes src/Makevars from the source files that there are.
#   tools/makevars.sh            after a file in src/ has been added, moved or removed
#   tools/makevars.sh --check    says nothing and succeeds if src/Makevars is in step
# R takes sources in folders only as a list of objects, and packages may not rely on what only GNU
# make offers (wildcards, included dependency files). So every object depends on every header: one
# header's edit compiles everything again, and no object of an older header is ever linked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../src"

makevars() {
  cat <<'END'
# Written by tools/makevars.sh; do not edit.
CXX_STD = CXX17
PKG_CXXFLAGS = -pthread $(CXX_VISIBILITY)
PKG_LIBS = -pthread

END
  printf 'OBJECTS ='
  find . -name '*.cpp' | LC_ALL=C sort | sed 's|^\./|  |; s|\.cpp$|.o|' |
    while IFS= read -r line; do printf ' \\\n%s' "$line"; done
  printf '\n\nHEADERS ='
  find . \( -name '*.h' -o -name '*.hpp' -o -name '*.inl' \) | LC_ALL=C sort | sed 's|^\./|  |' |
    while IFS= read -r line; do printf ' \\\n%s' "$line"; done
  cat <<'END'


all: $(SHLIB)
$(OBJECTS): $(HEADERS)
END
}

if [ "${1:-}" = --check ]; then
  if ! makevars | diff -u Makevars - >&2; then
    echo "src/Makevars is out of step with the files: run tools/makevars.sh" >&2
    exit 1
  fi
else
  makevars >Makevars.new
  mv Makevars.new Makevars
fi
