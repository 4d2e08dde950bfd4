# `make run` needs Python >= 3.11 alone; `make test` brings Node and Chromium where they are missing.
# With Node on the machine, `make run` packs the page into a few files before.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
INSTALL := python -m pip install --quiet --disable-pip-version-check
WORKERS ?= 2
PYTEST := pytest --dist worksteal --numprocesses $(WORKERS)
BROWSERS := chromium chromium-browser google-chrome-stable google-chrome

# Recipes use the project's own tools first, whatever environment is activated.
export PATH := $(CURDIR)/$(BIN):$(CURDIR)/node_modules/.bin:$(PATH)

.NOTPARALLEL:
.PHONY: help run pack test format lint types unit browser fuzz bench lock audit lowest vendor readme pictures icons chromium shell glslang clean
.DEFAULT_GOAL := help

help: ## list the targets
	@grep -E '^[a-z]+:.*##' Makefile | sed -E 's/:.*## /\t/' | expand -t 12

run: $(VENV)/run.stamp pack ## serve on 127.0.0.1:8000 (FRESNEL_HOST and FRESNEL_PORT change it)
	@$(BIN)/fresnel-explorer serve

# Without Node, or where its packages cannot be had, the page comes module by module and is the same.
NODE := node -e 'process.exit(+(parseInt(process.versions.node) < 20))' 2>/dev/null && npm --version >/dev/null 2>&1
NPM := npm ci --ignore-scripts --no-audit --no-fund
pack: ## pack the page into a few files, where Node >= 20 is on the machine
	@if $(NODE) && { [ -d node_modules/rolldown ] || $(NPM) --omit=dev --silent; } && node tools/pack.mjs; then :; \
	else echo "the page is not packed, and comes module by module" >&2; fi

test: lint types unit browser ## check everything, as .ci/run does

format: $(VENV)/test.stamp node_modules/stamp ## rewrite the sources in the project's format
	ruff format
	ruff check --fix
	biome check --write

lint: $(VENV)/test.stamp node_modules/stamp ## formats and lint rules: Python, then JavaScript and CSS
	ruff format --check
	ruff check
	biome check --error-on-warnings

types: $(VENV)/test.stamp node_modules/stamp ## static types: Python, then JavaScript
	mypy
	tsc

unit: $(VENV)/test.stamp node_modules/stamp glslang ## every test that needs no browser
	node --test tests/js/*.test.js
	$(PYTEST) tests --ignore tests/browser

# In a pytest of its own: after Playwright's synchronous API no test in the process can use asyncio.run.
browser: $(VENV)/test.stamp node_modules/stamp shell chromium ## the tests in Chromium
	$(PYTEST) tests/browser

fuzz: $(VENV)/test.stamp ## send 100,000 generated requests, as many through nginx, read 200,000 generated files, and say what came back, in some 80 minutes
	FUZZ_REQUESTS=100000 FUZZ_EXAMPLES=300 pytest tests/fuzz -s --ignore tests/fuzz/test_reading.py
	FUZZ_THROUGH_NGINX=1 FUZZ_REQUESTS=100000 pytest tests/fuzz/test_requests.py -s
	FUZZ_READS=200000 pytest tests/fuzz/test_reading.py -s

bench: $(VENV)/test.stamp chromium ## measure what the project claims about its speed
	python -m benchmarks

COMPILE := uv pip compile --no-config --universal --python-version 3.11 --generate-hashes --no-header --no-emit-index-url --quiet

lock: $(BIN)/python ## recompute the hash-locked requirement files from pyproject.toml
	$(INSTALL) uv
	$(COMPILE) pyproject.toml --group build -o requirements.lock
	$(COMPILE) pyproject.toml --extra arrow --extra cluster --group build --group test -c requirements.lock -o requirements-test.lock
	$(COMPILE) --group node -o requirements-node.lock

# Strict: what could not be looked up is no better than what was found wanting.
audit: $(BIN)/python ## look the locked dependencies up among the known vulnerabilities
	$(INSTALL) pip-audit
	$(BIN)/pip-audit --strict --require-hashes --disable-pip -r requirements.lock

# The lower ends of the ranges in pyproject.toml; the lock files are their upper ends.
LOWEST := .venv-lowest
lowest: $(BIN)/python ## run the tests that need no browser with the lowest versions that are allowed
	$(INSTALL) uv
	$(BIN)/uv venv --no-config --quiet --clear --python $(BIN)/python $(LOWEST)
	$(BIN)/uv pip install --no-config --quiet --python $(LOWEST)/bin/python --resolution lowest-direct \
	  -r pyproject.toml --extra arrow --extra cluster --extra figures --group build --group test
	$(BIN)/uv pip install --no-config --quiet --python $(LOWEST)/bin/python --no-deps --no-build-isolation -e .
	PATH="$(CURDIR)/$(LOWEST)/bin:$$PATH" $(PYTEST) tests --ignore tests/browser

vendor: $(VENV)/test.stamp node_modules/stamp ## refill static/vendor from the npm packages
	python tools/vendor.py

readme: $(VENV)/test.stamp ## rewrite the tables in README.md that are made from the code
	python tools/readme.py

pictures: $(VENV)/test.stamp chromium ## take the README's pictures from the running page
	python tools/pictures.py

icons: $(VENV)/test.stamp chromium ## draw the page's icons from its mark
	python -m tools.icons

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	  || { echo "Python >= 3.11 is needed; name it so: make run PYTHON=/path/to/python3.12" >&2; exit 1; }
	@$(PYTHON) -m venv $(VENV) || { rm -rf $(VENV); exit 1; }

# The stamps are as old as the last install, which is repeated when a lock file is newer.
$(VENV)/run.stamp: requirements.lock pyproject.toml | $(BIN)/python
	$(INSTALL) --require-hashes -r requirements.lock
	$(INSTALL) --no-deps --no-build-isolation -e .
	@touch $@

$(VENV)/test.stamp: requirements-test.lock $(VENV)/run.stamp
	$(INSTALL) --require-hashes -r requirements-test.lock
	@touch $@

node_modules/stamp: package-lock.json requirements-node.lock | $(BIN)/python
	@$(NODE) \
	  || $(INSTALL) --require-hashes -r requirements-node.lock
	$(NPM)
	@touch $@

# By apt where there is none of these and apt may be used; elsewhere what needs them skips, and fails in CI.
chromium:
	$(call apt,chromium,"$$CHROME_PATH" $(BROWSERS))

# Chromium without windows opens a page at half the cost; where it is not to be had, Chromium does as well.
shell:
	$(call apt,chromium-headless-shell,"$$CHROME_PATH" chromium-headless-shell)

glslang:
	$(call apt,glslang-tools,glslangValidator)

define apt
@for program in $(2); do command -v "$$program" >/dev/null && exit 0; done; \
command -v apt-get >/dev/null || exit 0; \
if [ "$$(id -u)" = 0 ]; then root=; elif sudo -n true 2>/dev/null; then root=sudo; else exit 0; fi; \
$$root apt-get update && $$root apt-get install -y --no-install-recommends $(1) \
  || echo "$(1) could not be installed" >&2
endef

clean: ## remove everything that make made
	rm -rf $(VENV) $(LOWEST) node_modules .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -prune -exec rm -rf {} +
