# Everything a fresh clone needs, in two commands: `make demo` and `make test`.
# Needed beforehand: Debian 12 (or newer) with Python 3.11 (or newer) and make.

PYTHON ?= python3
BIN := .venv/bin
OUT := out

# Nothing is written outside this folder: pip, fontconfig, matplotlib and the tools cache here.
export XDG_CACHE_HOME := $(CURDIR)/.cache
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PYTHON
# A process for each processor needs no threads besides: a third of what importing numpy takes.
export OPENBLAS_NUM_THREADS := 1
# Else every worker of every test compiles the program and the tests anew: a fifth of their time.
unexport PYTHONDONTWRITEBYTECODE

PIP_INSTALL = $(BIN)/python -m pip install --quiet --constraint constraints.txt

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
# Two installations at once would wait for each other's lock.
.NOTPARALLEL:

.PHONY: help
help: ## print this list
	@sed -n 's/^\([a-z]*\):.*## /\1|/p' $(MAKEFILE_LIST) \
	  | while IFS='|' read -r name text; do printf 'make %-9s %s\n' "$$name" "$$text"; done

.PHONY: demo
demo: .venv/run.stamp ## issue, grade and report a whole small course into out/
	$(BIN)/python -m gripcourse demo --out $(OUT)

.PHONY: serve
serve: demo ## students' pages and the instructor's desk, on what the demo made
	$(BIN)/gripcourse links --course $(OUT)/course --address http://127.0.0.1:8321 --out $(OUT)/links.csv
	$(BIN)/gripcourse serve --course $(OUT)/course --assignments $(OUT)/assignments --graded $(OUT)/graded

# All of them always run, so that one call shows everything; any failure is a failure of the whole.
LINT = $(BIN)/ruff check || status=$$?; $(BIN)/ruff format --check || status=$$?; \
  $(BIN)/mypy || status=$$?

# The types take one processor for long: the tests begin meanwhile, and what lint says comes last.
LINT_MEANWHILE = mkdir -p .cache; { status=0; $(LINT); exit $$status; } >.cache/lint.log 2>&1 & lint=$$!
LINT_RESULT = wait $$lint || status=$$?; cat .cache/lint.log; exit $$status

.PHONY: test
test: test-packages .venv/dev.stamp ## lint, types and all tests
	@status=0; $(LINT_MEANWHILE); \
	$(BIN)/python -m pytest -n auto --dist loadfile $(PYTEST_OPTIONS) || status=$$?; \
	$(LINT_RESULT)

.PHONY: check
check: .venv/dev.stamp ## lint, types and the tests of what changed; BASE=commit measures from there
	@status=0; $(LINT_MEANWHILE); tests=$$($(BIN)/python scripts/tests_of_changes.py $(BASE)) && \
	$(BIN)/python -m pytest -n auto --dist loadfile $(PYTEST_OPTIONS) $$tests || status=$$?; \
	$(LINT_RESULT)

.PHONY: coverage
coverage: test-packages .venv/dev.stamp ## all tests, and the lines that none of them runs
	$(BIN)/python -m pytest -n auto --dist loadfile --cov --cov-report=term-missing:skip-covered \
	  $(PYTEST_OPTIONS)

.PHONY: lint
lint: .venv/dev.stamp ## only lint and types
	@status=0; $(LINT); exit $$status

.PHONY: bench
bench: .venv/dev.stamp ## measure what the documentation states
	@for file in $(sort $(wildcard benchmarks/*.py)); do echo "# $$file"; $(BIN)/python "$$file" || exit; done

.PHONY: fuzz
fuzz: .venv/dev.stamp ## read 100 000 spoiled workbooks, twice; RUNS=… for another number, FIRST=… for others
	$(BIN)/python tests/hostile/fuzz.py $(or $(FIRST),3000) $(or $(RUNS),100000)
	$(BIN)/python tests/hostile/guided.py $(or $(FIRST),3000) $(or $(RUNS),100000)

# By a fuzzer that counts what ran, for the Python versions that it is made for; it is not in `test`.
.PHONY: hunt
hunt: .venv/fuzz.stamp ## look for files that fail any reader, led by what ran; SECONDS=… for each, READERS=…
	@for reader in $(or $(READERS),$$($(BIN)/python tests/hostile/readers.py)); do \
	  $(BIN)/python tests/hostile/covered.py "$$reader" -max_total_time=$(or $(SECONDS),300) \
	    -rss_limit_mb=3000 -timeout=120 -verbosity=0 || exit; done

.PHONY: gallery
gallery: demo | test-packages ## pictures of every kind of page, in docs/gallery/
	$(BIN)/python scripts/gallery.py $(OUT) docs/gallery
	$(BIN)/python scripts/gallery_server.py $(OUT) docs/gallery

.PHONY: docs
docs: .venv/docs.stamp | run-packages ## the documentation site in build/docs/; warnings are errors
	$(BIN)/python scripts/documentation.py build/docs

.PHONY: pot
pot: .venv/dev.stamp ## bring the catalogues of translations up to date with the sources
	$(BIN)/python scripts/messages.py update

.PHONY: clean
clean: ## remove everything that make made
	rm -rf .venv .cache .mypy_cache .pytest_cache .ruff_cache .hypothesis build dist $(OUT)
	find . -name __pycache__ -prune -exec rm -rf {} +

# The environment, in two layers. A stamp says that a layer fits pyproject.toml and constraints.txt.

.venv/run.stamp: pyproject.toml constraints.txt | run-packages
	@$(PYTHON) -c 'import sys; v = sys.version.split()[0]; sys.version_info >= (3, 11) or \
	  sys.exit(f"gripcourse needs Python 3.11 or newer, $(PYTHON) is {v}; set PYTHON=...")'
	@echo 'Installing Python packages into .venv: a minute or two, once'
	@$(PYTHON) -m venv .venv
	@$(PIP_INSTALL) pip
	@$(PIP_INSTALL) --build-constraint constraints.txt --editable '.[web,cluster,lti]'
	@touch $@

.venv/dev.stamp: .venv/run.stamp
	@$(PIP_INSTALL) --group dev --group docs
	@$(PIP_INSTALL) --no-deps --group axe
	@touch $@

.venv/fuzz.stamp: .venv/dev.stamp
	@$(PIP_INSTALL) --group fuzz
	@touch $@

.venv/docs.stamp: .venv/run.stamp
	@$(PIP_INSTALL) --group docs
	@touch $@

.PHONY: run-packages
run-packages:
	@scripts/system-packages run

.PHONY: test-packages
test-packages:
	@scripts/system-packages test
