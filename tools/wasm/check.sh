#!/bin/sh
# Fails where inst/share/engine.wasm is there and was made of other sources than these.
cd "$(dirname "$0")/../.."
[ -f inst/share/engine.wasm ] || exit 0
[ "$(cat inst/share/engine.sum)" = "$(tools/wasm/sum.sh)" ] && exit 0
echo "inst/share/engine.wasm was made of other sources: make wasm"
exit 1
