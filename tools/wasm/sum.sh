#!/bin/sh
# A sum of all that inst/share/engine.wasm is made of: the engine's sources, the page's and the flags.
set -e
cd "$(dirname "$0")/../.."
{
  find src/engine -name '*.[chi]pp' -o -name '*.inl' | LC_ALL=C sort
  echo tools/wasm/engine_page.cpp
  echo tools/wasm/Makefile
} | xargs cat | sha256sum | cut -d ' ' -f 1
