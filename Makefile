# Users:
#   make trawl     settle the shipped midwater trawl; write pictures and tables to out/
#   make install   install codend with its vignettes; takes minutes
#
# Tests and checks:
#   make test      all tests of the engine and of the package
#   make fast      engine tests and quick package tests, in less than two minutes
#   make lint      lanes of continuous integration that take seconds
#   make check     R CMD check --as-cran of the published package; a note is a failure
#   make ci        all lanes of continuous integration (tools/lanes.csv); output in out/lanes/
#   make lane LANE="style cost"  single lanes
#   make ratchet   store the present values of lanes that compare with stored values (tests/ratchets)
#   make fuzz      random plans, files, models and messages; SECONDS=... SEED=...
#   make fuzz-engine  randomly damaged engine models, under the sanitizers; COUNT=... SEED=...
#   make sanitize-threads  engine tests under the thread sanitizer
#   make coverage  line coverage of the tests; PART=R or PART=C++ for one language; needs covr
#   make soak      ten users of the flume tank for an hour; MINUTES=... USERS=...; needs Node.js 20
#
# Measurements, results in bench/results/ (bench/README.md):
#   make bench     cost of settling; NODES=... is the largest size
#   make bench-loops  cost of changing a settled gear
#   make bench-tow    cost of one second of motion, by scheme
#   make netting   discretisation error of netting: known answers, mesh differences, cost
#   make errors    reliability of error estimates; ERRORS="gears=100 nodes=1500"
#   make tow-errors  check of the estimated errors of tows; ERRORS="count=24 nodes=300"
#   make random-gears  success rate of random gears; COUNT=... SEED=... NODES=... NETTING=... LAW=... KIND=...
#   make robust    success rate of 500 variations of the trawl
#   make robust-tows  failures of random tows; TOWS="count=500 minutes=1,20"
#   make validate  compare with analytical solutions, flume tests and hauls: validation/book.md
#   make condition  fit the model error of uncertainty() to measurements; FIT=1 reuses the last sensitivities
#
# Generated files:
#   make gallery   all pictures of gears and of the tank, and their scenes in gallery/scenes.csv
#   make web       the scripts of pages in inst/, from web/src; needs Node.js with npm
#   make wasm      the engine as WebAssembly in inst/share, for pages of share(); installs codend
#   make site      help, guides, pictures and live gears as a site in site/; runs make wasm first
#   make cheat-sheet  the guide "Cheat sheet" as one page: pkgdown/assets/codend-cheat-sheet.pdf
#   make docs      results that README, guides and help quote from result files
#   make schema    inst/schema and enumerations of the engine, from tools/schema and tables
#   make schema-check  fail if these files are outdated
#   make schema-test   check valid and invalid plans with two standard validators; needs Node.js with
#                  npm, and Python with jsonschema and PyYAML
#
# All targets except docs, schema and schema-check install missing dependencies first (tools/setup).

.PHONY: cheat-sheet docs trawl install test fast lint fuzz fuzz-engine sanitize-threads coverage check ci lane \
  ratchet gallery guides knitted soak bench bench-loops bench-tow netting errors tow-errors random-gears robust robust-tows \
  validate condition web wasm site schema schema-check
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
	@Rscript tools/ci.R style layers format engine-files web wasm schema help-index generated docs prose

ci:
	@tools/setup --ci
	@Rscript tools/ci.R

lane:
	@tools/setup --ci
	@Rscript tools/ci.R $(LANE)

ratchet:
	@tools/setup --ci
	@for script in tests/ratchets/*.R; do Rscript $$script --accept || exit 1; done

# Limit memory, so that a runaway process fails.
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

# Knits the guides for the lanes `check` and `site`. A lock makes one lane wait for the other.
guides:
	@mkdir -p out/guides/articles
	@flock out/guides.lock $(MAKE) -s knitted \
	  INSTALLED=$$(Rscript -e 'cat(system.file("sources.mark", package = "codend"))')

knitted: $(patsubst vignettes/%,out/guides/%,$(wildcard vignettes/*.Rmd vignettes/articles/*.Rmd))
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

tow-errors:
	@tools/setup
	@Rscript bench/tow-errors.R $(ERRORS)

random-gears: COUNT = 300
random-gears: SEED = 1
random-gears:
	@tools/setup
	@Rscript bench/settle-random-gears.R count=$(COUNT) seed=$(SEED) nodes=$(NODES) netting=$(NETTING) \
	  law=$(LAW) kind=$(KIND)

robust:
	@tools/setup --tests
	@Rscript bench/robust.R

robust-tows:
	@tools/setup
	@Rscript bench/robust-tows.R $(TOWS)

validate:
	@tools/setup --tests
	@Rscript validation/openings.R
	@Rscript validation/book.R

condition:
	@tools/setup --tests
	@Rscript validation/condition.R $(if $(FIT),--fit)
	@Rscript validation/heights.R

web:
	@tools/setup --ci
	@npm run --silent --prefix web build

wasm:
	@tools/setup --wasm

site: wasm
	@tools/setup --site
	@Rscript tools/site.R

cheat-sheet:
	@tools/setup --ci
	@tools/cheat-sheet

docs:
	@Rscript tools/docs.R

schema:
	@Rscript tools/schema.R

schema-check:
	@Rscript tools/schema.R --check

schema-test: schema-check
	@cd tests/schema && npm install --no-audit --no-fund --no-package-lock --silent && node --test
	@python3 tests/schema/validate.py
