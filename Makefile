# make trawl   settle the shipped midwater trawl: measures on screen, pictures and tables in out/
# make test    every test of the engine and of the package
# make bench   what settling costs, to bench/results/ (bench/README.md); NODES=... is the largest size
# make bench-tow  what a second of motion costs by scheme, to bench/results/
# make browser-test  the flume tank in headless Chromium; takes Node.js with npm, and Chromium
# make schema  the schema of plans, inst/schema, from its parts in tools/schema
# make schema-check  fails where it is not what the parts give
# make robust  how many of 500 variations of the trawl settle, to bench/results/
# All install whatever is missing first (tools/setup) and nothing when nothing is.

.PHONY: schema schema-check trawl test browser-test bench bench-tow robust
trawl:
	@tools/setup
	@exec/codend settle midwater_trawl --out out

test:
	@tools/setup --tests
	@Rscript tools/test.R

browser-test:
	@tools/setup --tests
	@cd tests/browser && npm install --no-audit --no-fund --no-package-lock --silent && node --test

NODES ?= 100000
bench:
	@tools/setup --tests
	@Rscript bench/bench.R $(NODES)

bench-tow:
	@tools/setup --tests
	@Rscript bench/motion.R

robust:
	@tools/setup --tests
	@Rscript bench/robust.R

schema:
	@Rscript tools/schema.R

schema-check:
	@Rscript tools/schema.R --check
