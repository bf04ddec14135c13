#!/usr/bin/env bash
# Checks the sources of the engine. Fails if
# - src/Makevars does not match the files in src/;
# - the engine includes R or contains a fishing term;
# - includes break the order of the folders or form a cycle;
# - a header does not compile on its own.
#
#   tools/check-engine.sh
#
# CXX: compiler, default g++.
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

# A folder includes only itself and earlier folders. The last entry holds codend.hpp.
order=(base elements model gear solve motion measure .)
place() { for k in "${!order[@]}"; do [ "${order[$k]}" = "$1" ] && echo "$k"; done; }

# Terms of the structure are allowed: netting, twine, knot, mesh, rope.
fishing='trawl|otter|seine|vessel|winch|warp|gillnet|longline|fish|catch_(w|p|v|f)|crew|codline|haul'

found=$(sources | xargs grep -nE '#include *[<"](R|Rinternals|Rmath|R_ext|cpp11|Rcpp)[./>"h]')
[ -z "$found" ] || complain "The engine includes R:"$'\n'"$found"
# Exceptions: titles of publications, and names of measures, which plans use.
found=$(sources | xargs grep -niE "$fishing" | grep -vE 'measure/measure_kinds.hpp|MeasureKind::catch_|Fish Farms|fish farms|Fish\. Res\.|Midwater Trawl')
[ -z "$found" ] || complain "The engine contains fishing terms:"$'\n'"$found"

pairs=$(mktemp)
trap 'rm -f "$pairs"' EXIT
while read -r file; do
  folder=$(basename "$(dirname "$file")")
  own=$(place "$folder")
  [ -n "$own" ] || { complain "$file is outside the known folders: ${order[*]}"; continue; }
  while read -r included; do
    path=$(realpath -m --relative-to=. "$(dirname "$file")/$included")
    [ -f "$path" ] || { complain "$file includes $included, which is not in the engine"; continue; }
    theirs=$(place "$(basename "$(dirname "$path")")")
    [ "${theirs:-99}" -le "$own" ] || complain "$file includes $path of a later folder"
    echo "${file#./} $path"
  done < <(sed -n 's/^ *#include "\(.*\)".*/\1/p' "$file")
done < <(sources) >"$pairs"
tsort "$pairs" >/dev/null 2>&1 || complain "Headers include each other in a cycle: $(tsort "$pairs" 2>&1 >/dev/null | tr '\n' ' ')"

eigen=/usr/include/eigen3
[ -d "$eigen" ] || eigen=$(Rscript -e 'cat(system.file("include", package = "RcppEigen"))')
# A source file must include its own header first, which shows that the header compiles on its own.
# The other headers are compiled together, because compiling each takes minutes. Headers of later folders
# come first, so that a missing include of an earlier folder is an error.
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
