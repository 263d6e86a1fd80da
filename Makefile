# Two commands do everything: `make demo` and `make test`. Each first builds or extends the virtual environment as far as it needs.

SHELL := bash
.SHELLFLAGS := -euo pipefail -c

VENV ?= .venv
JOBS ?= 3 # one more than two cores: tests also wait, for processes that they start
BIN := $(VENV)/bin
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && { echo $$p; break; }; done)
MADE_FROM := pyproject.toml .ci/constraints.txt
LATER := not whole and not browser and not client and not term and not fast
comma := ,
FOR_DEMO := nbgrader,isolation,proofs
FOR_TEST := $(FOR_DEMO),dask,pdf,test

# One stamp for each group of packages; each group is put on top of the one before it.
DEMO := $(VENV)/.has-demo
TEST := $(VENV)/.has-test
ALL := $(VENV)/.has-all
LINT := $(VENV)/.has-lint

# pip's own lines, one for each package found and one for each downloaded; what is already there is not worth a line.
define install
	@echo "== $(1)"
	@$(BIN)/python -m pip --disable-pip-version-check install --progress-bar off --constraint .ci/constraints.txt $(2) \
		| { grep --line-buffered --invert-match -e 'already satisfied' -e '\.metadata' -e '^Looking in' || true; }
endef

.PHONY: setup demo test test-long test-all lint messages site clean

setup: $(DEMO)
	@echo "== done: $(BIN)/corollary --help"

$(BIN)/python:
	@test -n "$(PYTHON)" || { echo "Corollary needs Python 3.11 or newer; none was found (apt install python3 python3-venv)"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { echo "$(PYTHON) cannot make virtual environments; apt install python3-venv"; exit 1; }
	@echo "== a virtual environment in $(VENV), with $$($(PYTHON) --version)"
	@$(PYTHON) -m venv $(VENV)

$(DEMO): $(MADE_FROM) | $(BIN)/python
	$(call install,what builds the package,hatchling editables)
	$(call install,Corollary with nbgrader$(comma) isolation and proofs (about 130 packages$(comma) 190 MB),--no-build-isolation --editable '.[$(FOR_DEMO)]')
	@touch $@

$(TEST): $(DEMO)
	$(call install,what the tests need,--no-build-isolation --editable '.[$(FOR_TEST)]')
	@touch $@

$(ALL): $(TEST)
	$(call install,what drives a browser$(comma) builds the site and compiles steps,--no-build-isolation --editable '.[$(FOR_TEST)$(comma)browser$(comma)site$(comma)fast]')
	@touch $@

$(LINT): $(TEST)
	$(call install,the linters,--no-build-isolation --editable '.[lint]')
	@touch $@

demo: $(DEMO)
	@$(BIN)/corollary demo demo

# The tests a change is tried with, in under eight minutes on two cores; `make test-long` has those that it leaves out: the long ones and
# those with a browser, a client or compiled steps; `make test-all` has both.
test: $(TEST)
	@$(BIN)/python -m pytest -n $(JOBS) --dist loadfile -m "$(LATER)"

# A page that a loaded machine draws too late is opened once more; nothing else gets a second try.
AGAIN := --reruns 1 --only-rerun '[Tt]imeout:? [0-9]+ ?ms'

test-long: $(ALL)
	@$(BIN)/python -m pytest -n $(JOBS) --dist loadfile $(AGAIN) -m "not ($(LATER))"

test-all: $(ALL)
	@$(BIN)/python -m pytest -n $(JOBS) --dist loadfile $(AGAIN)

lint: $(LINT)
	@$(BIN)/ruff check src tests solutions benchmarks examples
	@$(BIN)/ruff format --check src tests solutions benchmarks examples
	@$(BIN)/pyright --pythonpath $(BIN)/python

# The documentation as a site to read offline, with a gallery of every problem, in site/.
site: export NO_MKDOCS_2_WARNING = 1
site: $(ALL)
	@banks=$$(mktemp -d) && trap "rm -rf $$banks" EXIT \
	&& $(BIN)/python -m pip --disable-pip-version-check install --quiet --no-deps --no-build-isolation --target "$$banks" ./examples/banks/*/ \
	&& PYTHONPATH="$$banks" $(BIN)/mkdocs build --quiet && echo "site/index.html"

# The texts that students read, one template for each room.
messages: $(TEST)
	@$(BIN)/python .ci/messages.py

clean:
	rm -rf $(VENV) demo dist site .pytest_cache .ruff_cache
