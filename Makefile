# The front door. Each target is a line of cmake, ctest or a chapter program; `make help` lists them.

BUILD    := build
LEVEL    ?= quick
PRESET   ?= default
PREFIX   ?= /usr/local
JOBS     ?= $(shell nproc)
CHAPTERS := $(notdir $(patsubst %/,%,$(sort $(wildcard chapters/*/))))
chosen    = $(filter $(C)-% 0$(C)-%,$(CHAPTERS))
some      = $(if $(C),$(or $(chosen),$(error C is "$(C)"; allowed: the number of one of $(CHAPTERS))))
wants     = { command -v $(1) > /dev/null || { echo "$(1) is not installed; on Debian: sudo apt-get install $(1)"; exit 2; }; }
program   = $(patsubst $(firstword $(subst -, ,$(1)))-%,%,$(1))
SOURCES   = $(shell git ls-files '*.cpp' '*.hpp' ':!tests/book')

.PHONY: peers cost accept-cost headline accept-digits accept-commands accept-live new-chapter help doctor packages configure chapter-programs programs build install reproduce test thorough chapter figures accept-figures book bench format lint failed clean mutate coverage sanitize matrix fuzz

help:             ## this list
	@sed -n 's/^\([a-z-]*\):.*## /  make \1\t/p' $(MAKEFILE_LIST) | expand -t 24
	@echo; echo "  PRESET=developer makes warnings errors."
	@echo "  LEVEL=full lengthens Monte Carlo and refines references; chapters: $(CHAPTERS)"

doctor:           ## say which packages are missing and what the tools' versions are
	@cmake/packages.sh check
	@for t in g++ cmake ninja gnuplot pandoc; do printf '%-8s ' $$t; $$t --version | head -n 1; done

packages:
	@cmake/packages.sh install

configure: $(if $(filter reproduce test,$(MAKECMDGOALS)),packages)
	@cmake --preset $(PRESET) --log-level=WARNING -DRAILBOOK_LEVEL=$(LEVEL) -B $(BUILD)

chapter-programs: configure
	@cmake --build $(BUILD) --target chapter_programs

programs: configure
	@cmake --build $(BUILD) --target programs

build: configure  ## compile everything, tests as well
	@cmake --build $(BUILD)

install: configure ## the command `railbook` and its library into PREFIX (/usr/local); DESTDIR goes before it
	@cmake --build $(BUILD) --target railbook
	@cmake --install $(BUILD) --prefix "$(PREFIX)"

reproduce: chapter-programs ## everything: build, run the chapters that have changed (JOBS=n at a time), weave the book
	@rm -f $$(grep -sL '^ "only": \[\]' $(BUILD)/results/*.json) $$(grep -sL '^ "level": "$(LEVEL)"' $(BUILD)/results/*.json) # of runs by hand
	@cmake --build $(BUILD) --target reproduce -j $(JOBS) -- -k 0; status=$$?; \
	  [ $$status = 0 ] || { cmake --build $(BUILD) --target book; echo "NOT all good: see the messages above."; }; \
	  cat $(CHAPTERS:%=$(BUILD)/results/%.txt); echo "book: $(BUILD)/book/index.html"; exit $$status

test: build       ## run all tests but those of `make thorough`
	ctest --test-dir $(BUILD) --output-on-failure -LE 'thorough|long' -j $$(($(JOBS) + 1)) # some only wait

thorough:         ## after `make test`: what takes longest, another processor's mathematics, the book in a browser
	ctest --test-dir $(BUILD) --output-on-failure -L 'thorough|long' -FA . -j $$(($(JOBS) + 1))

chapter:          ## run one chapter, e.g. make chapter C=01
	@$(if $(some),,$(error C names no chapter; allowed: the number of one of $(CHAPTERS)))
	@$(MAKE) --no-print-directory chapter-programs
	$(BUILD)/bin/$(call program,$(chosen)) reproduce --level $(LEVEL) --out $(BUILD)

figures: chapter-programs ## draw every figure to PNG, in build/figures
	@for c in $(CHAPTERS); do $(BUILD)/bin/$${c#*-} reproduce --level $(LEVEL) --out $(BUILD) || exit 1; done

accept-figures: configure ## make today's figures the golden set, all or of chapter C=03 (commit it alone, and say why)
	@cmake --build $(BUILD) --target figure_diff $(foreach c,$(or $(some),$(CHAPTERS)),$(call program,$(c)))
	@cmake -DBUILD=$(CURDIR)/$(BUILD) "-DCHAPTERS=$(some)" -P cmake/accept_figures.cmake

new-chapter:      ## a chapter to start from: make new-chapter NN=08-name
	@cmake -DNN=$(NN) -P cmake/new_chapter/new_chapter.cmake

headline:         ## write the table of what became of each paper into README.md, from the chapters that have been run
	@cmake -DRESULTS=$(CURDIR)/$(BUILD)/results -P cmake/headline.cmake

accept-digits: chapter-programs ## write how many digits of each number hold in all modes of rounding (and RUNS) into tests/digits
	@cmake --build $(BUILD) --target digits
	@ACCEPT=1 tests/digits/modes.sh $(BUILD) tests/digits $$(find $(BUILD) -name digits -type f -perm -u+x) $(CHAPTERS)

accept-commands: programs ## write the commands' answers and pictures of today into docs/commands.md
	@tests/tools/commands.sh "$(CURDIR)" "$(CURDIR)/$(BUILD)/bin/railbook" --accept

accept-live:      ## compile the figures that compute in the reader's browser into book/live/module.js (Debian: emscripten, dpkg-dev)
	@book/live/wasm/accept.sh $(BUILD)/live-cache

book: chapter-programs ## weave the book from the chapters that have been run
	@cmake --build $(BUILD) --target book

bench: configure  ## the solvers beside the machine's limit, a plain way, and scipy where it is: build/bench.json
	@cmake --build $(BUILD) --target speed
	@$(firstword $(wildcard /usr/bin/python3) python3) tests/bench/peers.py $(BUILD)/peers.json 2> /dev/null || echo '{}' > $(BUILD)/peers.json
	@$(BUILD)/bin/speed $(BUILD)/bench.json $(BUILD)/peers.json

peers: configure  ## reading records and filters beside md5sum, std::from_chars, numpy and scipy (RUNS=7; minutes, 1 GB): tests/peers/ratios.csv
	@cmake --build $(BUILD) --target railbook from_chars
	@RUNS=$(or $(RUNS),7) $(firstword $(wildcard /usr/bin/python3) python3) tests/peers/peers.py $(BUILD)/bin/railbook $(BUILD)/bin/from_chars tests/peers/ratios.csv

format:           ## clang-format every source in place
	@$(call wants,clang-format)
	clang-format -i $(SOURCES)

lint: configure     ## clang-format (check only) and clang-tidy (Debian packages of those names)
	@$(call wants,clang-format) && $(call wants,clang-tidy)
	clang-format --dry-run --Werror $(SOURCES)
	@cmake --preset debug -B $(BUILD)/tidy -DRAILBOOK_PCH=OFF --log-level=WARNING > /dev/null # no headers and no flags of GCC
	clang-tidy -p $(BUILD)/tidy --quiet --extra-arg=-Wno-unknown-warning-option $(filter lib/%.cpp chapters/%.cpp,$(SOURCES))

mutate: PRESET = developer # every source by itself
mutate: build     ## faults of one line, a sample: how many the tests notice (FAULTS=100 SEED=1, NEAR=1 asks the nearest tests only; python3)
	@$(call wants,python3)
	tests/mutate/mutate.py --build $(BUILD) --faults $(or $(FAULTS),100) --seed $(or $(SEED),1) $(if $(NEAR),--near)

coverage: ## lines and branches that the tests of lib/ take, by folder (R="num contact" for some)
	tests/coverage.sh $(R)

cost accept-cost: build ## count the instructions of ten works with valgrind, and compare them with tests/cost/costs.csv; accept-cost writes it
	@tests/cost/cost.sh $(BUILD)/bin/railbook tools/examples tests/cost/costs.csv $(if $(filter cost,$@),compare,accept)

sanitize: ## the tests of lib/ and the chapters under the address and undefined-behaviour sanitizers
	tests/sanitize.sh

matrix: ## checks and prose the same text from GCC and Clang, -O0, -O2 and -O3, and another processor's mathematics
	tests/matrix.sh $(C)

fuzz:   ## libFuzzer on every parser, SECONDS=60 each (clang)
	tests/fuzz/fuzz.sh $(or $(SECONDS),60)

failed: build     ## run again only the tests that failed
	ctest --test-dir $(BUILD) --rerun-failed --output-on-failure

clean:            ## remove everything generated
	rm -rf $(BUILD)
