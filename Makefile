# Two commands do everything: `make demo` and `make test`. Both build the virtual environment first when it is missing or stale.

VENV ?= .venv
EXTRAS ?= nbgrader,isolation,dask,dev
BIN := $(VENV)/bin
STAMP := $(VENV)/.ready
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && { echo $$p; break; }; done)
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet

.PHONY: setup demo test lint clean

setup: $(STAMP)

$(STAMP): pyproject.toml .ci/constraints.txt
	@test -n "$(PYTHON)" || { echo "Corollary needs Python 3.11 or newer; none was found (apt install python3 python3-venv)"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { echo "$(PYTHON) cannot make virtual environments; apt install python3-venv"; exit 1; }
	@echo "setting up $(VENV) with $$($(PYTHON) --version); the first time this takes a minute or two"
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) install --constraint .ci/constraints.txt hatchling editables
	@$(PIP) install --constraint .ci/constraints.txt --no-build-isolation --editable ".[$(EXTRAS)]"
	@touch $(STAMP)

demo: $(STAMP)
	@$(BIN)/corollary demo demo

test: $(STAMP)
	@$(BIN)/python -m pytest -n 2 --dist loadfile

lint: $(STAMP)
	@$(BIN)/ruff check src tests solutions benchmarks
	@$(BIN)/pyright --pythonpath $(BIN)/python

clean:
	rm -rf $(VENV) demo dist .pytest_cache .ruff_cache
