# Needs make and Python 3.11 or newer; everything else is installed into .venv.
# All paths are relative and tools run as modules, so that a space in the name of the
# directory does no harm. Works with GNU Make 3.81, which macOS ships.

CASE ?= cases/16v280.yaml
PYTHON ?=

CANDIDATES := $(if $(PYTHON),"$(PYTHON)",python3.13 python3.12 python3.11 python3)
PY := .venv/bin/python
# Compiling everything that is installed would add half to the wait. What a design
# imports is compiled here, even where PYTHONDONTWRITEBYTECODE keeps Python from
# writing what it compiles: each design would compile it anew, which takes a second.
INSTALL := $(PY) -m pip install --quiet --disable-pip-version-check --no-compile --editable
COMPILE := PYTHONDONTWRITEBYTECODE= $(PY) -c "import coupling_design.commands.app, \
	coupling_design.flow.design, coupling_design.report.files.chosen_case, \
	coupling_design.report.files.write, jinja2"

.PHONY: help design test test-slow lint format validation benchmark docs
.NOTPARALLEL:
.DELETE_ON_ERROR:

help:
	@echo "make design            design the coupling of $(CASE)"
	@echo "make design CASE=file  design the coupling of another case"
	@echo "make test              run the quick tests"
	@echo "make test-slow         run the full design flows"
	@echo "make validation        redo the paper's studies and write VALIDATION.md"
	@echo "make benchmark         measure the speed and write PERFORMANCE.md"
	@echo "make docs              build the documentation into site/"
	@echo "make lint              check style, types and project file"
	@echo "make format            put the code into the house style"

design: .venv/installed
	@$(PY) -m coupling_design "$(CASE)"

test: .venv/installed-test
	@$(PY) -m pytest -m "not slow"

# pytest returns 5 when no test carries the marker.
test-slow: .venv/installed-test
	@$(PY) -m pytest -m slow || test $$? -eq 5

validation: .venv/installed-studies
	@$(PY) -m studies.validation --case "$(CASE)"

benchmark: .venv/installed-benchmark
	@$(PY) -m benchmarks --write PERFORMANCE.md

docs: .venv/installed-docs
	@NO_MKDOCS_2_WARNING=1 $(PY) -m mkdocs build --strict --quiet
	@echo "Open site/index.html"

lint: .venv/installed-lint
	$(PY) -m ruff check
	$(PY) -m ruff format --check
	$(PY) -m mypy
	$(PY) -m validate_pyproject pyproject.toml

format: .venv/installed-lint
	$(PY) -m ruff check --fix
	$(PY) -m ruff format

.venv/installed: $(PY) pyproject.toml
	@echo "Installing the program into .venv ..." >&2
	@$(INSTALL) ".[html]"
	@$(COMPILE)
	@touch $@

.venv/installed-test: $(PY) pyproject.toml
	@echo "Installing the program and its test tools into .venv ..." >&2
	@$(INSTALL) ".[test]"
	@$(COMPILE)
	@touch .venv/installed $@

.venv/installed-studies: $(PY) pyproject.toml
	@echo "Installing the program and what its studies need into .venv ..." >&2
	@$(INSTALL) ".[test,studies]"
	@$(COMPILE)
	@touch .venv/installed .venv/installed-test $@

.venv/installed-benchmark: $(PY) pyproject.toml
	@echo "Installing the program and what its benchmarks need into .venv ..." >&2
	@$(INSTALL) ".[html,benchmark]"
	@$(COMPILE)
	@touch .venv/installed $@

.venv/installed-docs: $(PY) pyproject.toml
	@echo "Installing the program and what its documentation needs into .venv ..." >&2
	@$(INSTALL) ".[test,docs]"
	@$(COMPILE)
	@touch .venv/installed .venv/installed-test $@

.venv/installed-lint: $(PY) pyproject.toml
	@echo "Installing the program and its lint tools into .venv ..." >&2
	@$(INSTALL) ".[html,lint]"
	@$(COMPILE)
	@touch .venv/installed $@

$(PY):
	@bare=; \
	for python in $(CANDIDATES); do \
	    "$$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	        >/dev/null 2>&1 || continue; \
	    "$$python" -c 'import ensurepip, venv' >/dev/null 2>&1 \
	        || { bare="$$bare $$python"; continue; }; \
	    echo "Creating .venv with $$python ..." >&2; \
	    "$$python" -m venv --clear .venv && exit 0; \
	    rm -rf .venv; \
	    exit 1; \
	done; \
	if test -n "$$bare"; then \
	    echo "Found$$bare, but without the module venv or ensurepip." >&2; \
	    echo "Debian, Ubuntu: install the package python3-venv, then run make again." >&2; \
	else \
	    echo 'Found no Python 3.11 or newer among: $(CANDIDATES).' >&2; \
	    echo "Install one, or name it: make PYTHON=/path/to/python3 ..." >&2; \
	fi; \
	exit 1
