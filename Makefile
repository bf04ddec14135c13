# make trawl   settle the shipped midwater trawl: measures on screen, pictures and tables in out/
# make test    every test of the engine and of the package
# Both install whatever is missing first (tools/setup) and nothing when nothing is.

.PHONY: trawl test
trawl:
	@tools/setup
	@exec/codend settle midwater_trawl --out out

test:
	@tools/setup --tests
	@Rscript tools/test.R
