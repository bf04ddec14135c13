# Shell in which tools/examples.R runs the shell code of a document (example.sh).
set -eu
PATH=$HOME/.local/bin:$PATH

# make and ssh are not run, but a target of make must exist.
make() { { local -; set +x; } 2>/dev/null; command make --dry-run -C "$ROOT" "$@" >/dev/null; }
ssh() { :; }

# Debian installs the readers of NetCDF for this Python.
python3() { /usr/bin/python3 "$@"; }

# Run the tank on a free port until its page has loaded.
codend() {
  { local -; set +x; } 2>/dev/null
  if [ "$1" != flume ]; then command codend "$@"; return; fi
  port=$(Rscript -e 'cat(httpuv::randomPort())')
  set -- "${@/3838/$port}"
  command codend "${@/\/srv\//}" &
  until { exec 3<>"/dev/tcp/127.0.0.1/$port"; } 2>/dev/null; do
    kill -0 $!
    sleep 0.2
  done
  printf 'GET / HTTP/1.0\r\n\r\n' >&3
  grep -q '^HTTP/1.1 200' <&3
  exec 3>&-
  kill $!
  wait $! || :
}

# Input files of the examples.
cat > boards.csv <<END
otter_boards.area
1.2 m2
1.6 m2
2 m2
END
cat > hauls.csv <<END
warps.length,Door
270,55
300,57
330,59
END
[ "$DOCUMENT" = vignettes/command-line.Rmd ] || ln -sf "$(Rscript -e 'cat(system.file("exec", "codend", package = "codend"))')" .local/bin/
Rscript -e 'suppressMessages(library(codend)); write_result(tow("towed_cable", until = 20), "tow.nc")'
mkdir -p tank

PS4='$DOCUMENT:$LINENO: '
set -x
. ./example.sh
