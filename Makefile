# make trawl   settle the shipped midwater trawl: measures on screen, pictures and tables in out/
#
# make install  codend with its vignettes: vignette("measures", "codend"); computes them, in minutes
#
# make test    every test of the engine and of the package
# make fast    the engine's tests and the quick ones of the package, in under two minutes
# make lint    the lanes of continuous integration that take seconds
# make fuzz    plans, files, models and messages that nobody would write; SECONDS=... and SEED=...
# make sanitize-threads  the engine's tests under the thread sanitizer
# make fuzz-engine  models of the engine damaged at random, under the sanitizers; COUNT=... and SEED=...
# make coverage  which lines of R and C++ the tests run, PART=R or PART=C++ of one; takes the R package covr
# make check   R CMD check --as-cran of the package as it would be published; any note is a failure
# make ci      every lane of continuous integration (tools/lanes.csv); out/lanes/ has their output
# make lane LANE=NAME  one lane, or several: LANE="style cost"
# make ratchet  stores the present values of the lanes that compare with stored ones (tests/ratchets)
# make gallery writes all pictures of gears and of the tank, and gallery/scenes.csv with the scenes
#              that they show; look at each picture
#
# make soak    ten users of the flume tank for an hour, or MINUTES=..., USERS=...; takes Node.js 20
#
# make bench   what settling costs, to bench/results/ (bench/README.md); NODES=... is the largest size
# make bench-loops  what a change of a settled gear takes, to bench/results/
# make bench-tow  what a second of motion costs by scheme, to bench/results/
# make netting  what netting's lattice leaves: against known answers, between lattices, and cost
# make errors  whether the errors of measures hold, to bench/results/; ERRORS="gears=100 nodes=1500"
# make forge   how many gears drawn at random settle, to bench/results/; COUNT=... SEED=... NODES=...
#              NETTING=... LAW=... KIND=...
# make robust  how many of 500 variations of the trawl settle, to bench/results/
#
# make validate  codend beside closed forms, flume tests and hauls: validation/book.md
#
# make wasm    the engine as WebAssembly, into inst/share, for pages that share() writes, and codend with it
#
# make site    help, guides, pictures and living gears as a site, into site/, by pkgdown without the
#              network; makes wasm first
#
# make docs    results that README, guides and help quote, from the files that hold them
#
# make schema  the schema of plans, inst/schema, from its parts in tools/schema
# make schema-check  fails where it is not what the parts give
# make schema-test  shipped plans, right ones and wrong ones by two standard validators; takes Node.js
#              with npm, and Python with jsonschema and PyYAML
# All but these two install whatever is missing first (tools/setup) and nothing when nothing is.

.PHONY: docs trawl install test fast lint fuzz fuzz-engine sanitize-threads coverage check ci lane \
  ratchet gallery guides knitted soak bench bench-loops bench-tow netting errors forge robust \
  validate condition wasm site schema schema-check
trawl:
	@tools/setup
	@exec/codend settle midwater_trawl --out out

install:
	@tools/setup --guides

test:
	@tools/setup --tests
	@Rscript tools/ci.R engine package-s package-f package-m package-g package-a package-v

fast:
	@tools/setup --tests
	@tools/test-engine run
	@Rscript tools/test.R fast

lint:
	@tools/setup --ci
	@Rscript tools/ci.R style layers format engine-files wasm schema help-index generated words \
	  docs prose

ci:
	@tools/setup --ci
	@Rscript tools/ci.R

lane:
	@tools/setup --ci
	@Rscript tools/ci.R $(LANE)

ratchet:
	@tools/setup --ci
	@for script in tests/ratchets/*.R; do Rscript $$script --accept || exit 1; done

# A process that asks for more memory than it should gets none.
SECONDS ?= 3600
SEED ?= 1000000
fuzz:
	@tools/setup --tests
	@ulimit -v 6000000; exec Rscript tests/fuzz/run.R $(SECONDS) $(SEED)

COUNT ?= 100000
fuzz-engine:
	@tools/setup --tests
	@$(MAKE) -C tests/engine $@ COUNT=$(COUNT) SEED=$(SEED)

sanitize-threads:
	@tools/setup --tests
	@$(MAKE) -C tests/engine $@

coverage:
	@tools/setup --tests
	@Rscript tools/coverage.R $(PART)

check:
	@tools/setup --ci
	@Rscript tools/ci.R check

gallery:
	@tools/setup --ci
	@cd tests/browser && node gallery.js && node pictures.js
	@Rscript tools/check-gallery.R --accept

# The guides with results in place of code, which the lanes check and site both use: one of them
# knits while the other waits.
guides:
	@mkdir -p out/guides
	@flock out/guides.lock $(MAKE) -s knitted \
	  INSTALLED=$$(Rscript -e 'cat(system.file("sources.mark", package = "codend"))')

knitted: $(patsubst vignettes/%,out/guides/%,$(wildcard vignettes/*.Rmd))
out/guides/%.Rmd: vignettes/%.Rmd $(INSTALLED)
	@Rscript --vanilla tools/knit-guide.R $< $@

MINUTES ?= 60
USERS ?= 10
soak:
	@tools/setup --tests
	@node --experimental-websocket --no-warnings tests/browser/soak.js $(MINUTES) $(USERS)

NODES ?= 100000
bench:
	@tools/setup --tests
	@Rscript bench/bench.R $(NODES)

bench-loops:
	@tools/setup --tests
	@Rscript bench/loops.R $(or $(NODES),10000) $(EARLIER)

bench-tow:
	@tools/setup --tests
	@Rscript bench/motion.R

SECTIONS ?=
netting:
	@tools/setup --tests
	@Rscript bench/netting.R $(SECTIONS)

errors:
	@tools/setup --tests
	@Rscript bench/errors.R $(ERRORS)

forge: COUNT = 300
forge: SEED = 1
forge:
	@tools/setup
	@Rscript bench/settle-forge.R count=$(COUNT) seed=$(SEED) nodes=$(or $(NODES),1500) netting=$(NETTING) \
	  law=$(LAW) kind=$(KIND)

robust:
	@tools/setup --tests
	@Rscript bench/robust.R

validate:
	@tools/setup --tests
	@Rscript validation/openings.R
	@Rscript validation/book.R

condition:
	@tools/setup --tests
	@Rscript validation/condition.R $(if $(FIT),--fit)

wasm:
	@tools/setup --wasm

site: wasm
	@tools/setup --site
	@Rscript tools/site.R

docs:
	@Rscript tools/docs.R

schema:
	@Rscript tools/schema.R

schema-check:
	@Rscript tools/schema.R --check

schema-test: schema-check
	@cd tests/schema && npm install --no-audit --no-fund --no-package-lock --silent && node --test
	@python3 tests/schema/validate.py
