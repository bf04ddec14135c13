#!/usr/bin/env bash
# Fails where src/Makevars is out of step with the files in src/, or where the engine includes R, has
# a word of fishing, includes against the order of its folders or in a circle, or has a header that
# does not compile before all others.
#   tools/check-engine.sh
# CXX: the compiler, g++ unless set.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/makevars.sh --check || wrong=1
wrong=${wrong:-0}
cd src/engine
complain() {
  echo "$1" >&2
  wrong=1
}
sources() { find . -name '*.hpp' -o -name '*.cpp' -o -name '*.inl' | LC_ALL=C sort; }

# A folder includes only itself and those before it; the last is the engine's own, with codend.hpp.
order=(base elements model gear solve march measure .)
place() { for k in "${!order[@]}"; do [ "${order[$k]}" = "$1" ] && echo "$k"; done; }

# Netting, twine, knot, mesh and rope are structural and allowed.
fishing='trawl|otter|seine|vessel|winch|warp|gillnet|longline|fish|catch_(w|p|v|f)|crew|codline|haul'

found=$(sources | xargs grep -nE '#include *[<"](R|Rinternals|Rmath|R_ext|cpp11|Rcpp)[./>"h]')
[ -z "$found" ] || complain "The engine includes R:"$'\n'"$found"
# Titles of publications are quoted as they are, and measures have the names that plans have.
found=$(sources | xargs grep -niE "$fishing" | grep -vE 'measure/measure_kinds.hpp|MeasureKind::catch_|Fish Farms|fish farms|Fish\. Res\.|Midwater Trawl')
[ -z "$found" ] || complain "The engine has words of fishing:"$'\n'"$found"

pairs=$(mktemp)
trap 'rm -f "$pairs"' EXIT
while read -r file; do
  folder=$(basename "$(dirname "$file")")
  own=$(place "$folder")
  [ -n "$own" ] || { complain "$file is in none of the folders: ${order[*]}"; continue; }
  while read -r included; do
    path=$(realpath -m --relative-to=. "$(dirname "$file")/$included")
    [ -f "$path" ] || { complain "$file includes $included, which is not in the engine"; continue; }
    theirs=$(place "$(basename "$(dirname "$path")")")
    [ "${theirs:-99}" -le "$own" ] || complain "$file includes $path, of a folder above its own"
    echo "${file#./} $path"
  done < <(sed -n 's/^ *#include "\(.*\)".*/\1/p' "$file")
done < <(sources) >"$pairs"
tsort "$pairs" >/dev/null 2>&1 || complain "Headers include each other in a circle: $(tsort "$pairs" 2>&1 >/dev/null | tr '\n' ' ')"

eigen=/usr/include/eigen3
[ -d "$eigen" ] || eigen=$(Rscript -e 'cat(system.file("include", package = "RcppEigen"))')
# A header with a source is the source's first include, which shows that it needs no other before it.
# The rest, one by one, would take minutes: they are compiled together, those of the last folder first, so
# that what a header needs of a folder before its own is not there unless it includes it.
alone=()
for folder in "${order[@]}"; do
  while read -r header; do
    source=${header%.hpp}.cpp
    if [ "$folder" = . ]; then
      alone+=("$header")  # includes the others
    elif [ ! -f "$source" ]; then
      alone=("$header" "${alone[@]}")
    elif ! grep -m1 '^#include' "$source" | grep -qF "\"$(basename "$header")\""; then
      complain "$source does not include $(basename "$header") first"
    fi
  done < <(find "$folder" -maxdepth 1 -name '*.hpp' | LC_ALL=C sort -r)
done
said=$(printf '#include "%s"\n' "${alone[@]}" |
  ${CXX:-g++} -std=gnu++17 -fsyntax-only -I. -isystem "$eigen" -x c++ - 2>&1) ||
  complain "Headers do not compile:"$'\n'"$(head -20 <<<"$said")"
exit "$wrong"
