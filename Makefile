# make         set up what is needed and build every output
# make test    set up and test everything
# make test-fast   the tests that take less than a minute together: no compilers, no browser, no large inputs
# make proofs  the long proofs as a whole, of which the tests have a share: every device, version, fault and mutant
# make test-night  all tests and whole proofs with other random inputs each time, and twenty times as many of them
# make fuzz    fuzz the C headers of all devices at the same time, for a minute each
# make fuzz-bytes  fuzz the generated Python and JavaScript: coverage-guided for SECONDS=60 for each device, damaged frames, random bytes
# make mutants  put slips into the specs of the devices, one at a time, and count which checks, proofs, manuals and vectors notice
# make fuzz-specs   compare all codecs on random devices for a minute, or SECONDS=600; what they disagree on becomes a case
# make fuzz-lists   rewrite random exports as people keep lists for a minute, or SECONDS=600, and look for facts that come back wrong in silence
# make frozen  ask every codec about more than a million inputs and compare with the recorded digests; ACCEPT=yes records them
# make fuzz-texts  put hostile texts into every text of devices for a minute, or SECONDS=600, and parse all outputs
# make mutants-compiler  change single places of the compiler, and count which mutants recorded outputs and tests notice
# make queries  compare the queries of a telegram with the reference on a million random telegrams
# make plants  run the blocks for controllers for a million random scans each, against simulated devices and models of manuals
# make edits   build after 2,000 random edits in a process that remembers, and compare with builds that do not
# make plc-sizes  write docs/plc-sizes.md: code and data of the function blocks on a Cortex-M3
# make capabilities  verify every line of docs/capabilities.md about keys, of which the tests verify a share
# make accept  rewrite the tests' expectations, with RULE=code those of one rule; read the difference before you commit it
# make soak    kill builds at random moments, and strike faults at every operation on files, for some minutes
# make soak-device  let 24 hours of random requests and faults pass for each simulated device
# make dist    build the wheel and the sdist into dist/
# make sbom    write dist/sbom.json, the bill of materials of what an installation holds, as CycloneDX
# make docs-site  write the site of docs/ to build/site
# make extension  pack the extension for Visual Studio Code, build/fieldspec.vsix
# make bench   measure, and write docs/benchmarks.md
# make pins    choose new versions of the dependencies
# make clean   remove what make has set up
PYTHON ?= python3

VENV := .venv
BIN := $(VENV)/$(if $(filter Windows_NT,$(OS)),Scripts,bin)
PIP := $(BIN)/python -m pip --disable-pip-version-check
PINS := requirements/dev.txt
INSTALLED := $(VENV)/.installed
BENCH := benchmarks/.venv
PEERS := benchmarks/tools
INSTALLED_PEERS := $(BENCH)/.installed
TOOLS := tests/tools/node_modules/.package-lock.json
NPM := $(shell command -v npm 2>/dev/null)
UV := uv==0.13.8

SBOM := build/sbom
FUZZER := build/fuzz/environment
INSTALLED_FUZZER := $(FUZZER)/.installed
NOISE := 2000000
WRITER := build/docs/environment
INSTALLED_WRITER := $(WRITER)/.installed

.PHONY: build bytecode test test-fast proofs test-night fuzz fuzz-bytes mutants mutants-compiler fuzz-specs fuzz-lists frozen fuzz-texts queries plants edits plc-sizes capabilities accept soak soak-device dist sbom docs-site extension bench pins clean

build: $(INSTALLED) bytecode
	$(BIN)/fieldspec build

# Without npm the tests of editors are skipped; where CI is set, they fail.
test: $(INSTALLED) bytecode $(if $(NPM),$(TOOLS))
	$(BIN)/ruff check .
	$(BIN)/mypy --num-workers 2
	$(BIN)/pytest

test-fast: $(INSTALLED) bytecode
	$(BIN)/pytest --fast

proofs: $(INSTALLED) bytecode $(if $(NPM),$(TOOLS))
	FIELDSPEC_PROOFS=all $(BIN)/pytest -m proof

test-night: $(INSTALLED) bytecode $(if $(NPM),$(TOOLS))
	FIELDSPEC_PROOFS=all FIELDSPEC_EXAMPLES=20 $(BIN)/pytest --hypothesis-profile=random

# The tests start the command many times. Where Python may not write bytecode by itself, each start takes three times as
# long without this.
bytecode: $(INSTALLED)
	$(BIN)/python -m compileall -q -x '[/\\]test_\w+[.]py$$' codegen generated/python tests

fuzz: $(INSTALLED)
	$(BIN)/python tests/c_output/fuzz.py

# The fuzzer has an environment of its own, which needs Linux or macOS and a Python for which atheris has wheels.
fuzz-bytes: build $(INSTALLED_FUZZER)
	$(FUZZER)/bin/python tests/hostile_bytes/fuzz.py $(or $(SECONDS),60)
	$(BIN)/python tests/hostile_bytes/noise.py
	set -e; for device in ck10 esc11 hiwin-e tc100; do \
	  node --expose-gc tests/hostile_bytes/noise.mjs generated $$device $(NOISE); done

mutants: $(INSTALLED)
	$(BIN)/python tests/mutants.py $(or $(EACH),40) $(or $(SEED),1)

fuzz-specs: $(INSTALLED)
	$(BIN)/python tests/random_devices/fuzz.py $(or $(SECONDS),60) $(SEED)

fuzz-lists: $(INSTALLED)
	$(BIN)/python tests/rewritten_lists.py $(or $(SECONDS),60) $(or $(SEED),1)

frozen: $(INSTALLED)
	FIELDSPEC_FROZEN=all $(BIN)/pytest -n 2 $(if $(ACCEPT),--accept) tests/frozen

fuzz-texts: $(INSTALLED) $(if $(NPM),$(TOOLS))
	$(BIN)/python tests/hostile_texts/fuzz.py $(or $(SECONDS),60) $(or $(SEED),1)

mutants-compiler: $(INSTALLED)
	$(BIN)/python tests/compiler_judges.py $(or $(EACH),12) $(or $(SEED),1) $(FOLDERS)

soak: $(INSTALLED)
	$(BIN)/python tests/interruptions.py 200 1
	FIELDSPEC_PROOFS=all $(BIN)/pytest tests/test_faults.py tests/test_interruptions.py

soak-device: $(INSTALLED)
	FIELDSPEC_PROOFS=all FIELDSPEC_SOAK_HOURS=24 $(BIN)/pytest tests/device/test_soak.py

dist: $(INSTALLED)
	rm -rf dist
	$(BIN)/python -m hatchling build -d dist

# An environment with nothing but the wheel and what it needs; the tool that looks into it has one of its own.
sbom: dist
	rm -rf $(SBOM)
	$(PYTHON) -m venv $(SBOM)/tool
	$(PYTHON) -m venv --without-pip $(SBOM)/environment
	$(SBOM)/tool/$(notdir $(BIN))/python -m pip --disable-pip-version-check install --quiet --require-hashes --requirement requirements/sbom.txt
	$(SBOM)/tool/$(notdir $(BIN))/python -m pip --disable-pip-version-check --python $(SBOM)/environment install --quiet dist/*.whl
	$(SBOM)/tool/$(notdir $(BIN))/cyclonedx-py environment --output-reproducible --pyproject pyproject.toml \
	  --output-file dist/sbom.json $(SBOM)/environment

capabilities: $(INSTALLED)
	FIELDSPEC_CAPABILITIES=all $(BIN)/pytest -n 3 tests/test_capabilities.py

queries: $(INSTALLED)
	FIELDSPEC_TELEGRAMS=1000000 $(BIN)/pytest -n 2 tests/queries_output/test_queries_of_records.py -k telegrams

edits: $(INSTALLED)
	FIELDSPEC_PROOFS=all FIELDSPEC_EXAMPLES=250 $(BIN)/pytest -n 2 tests/test_builds_with_memory.py

plants: $(INSTALLED)
	FIELDSPEC_PROOFS=all FIELDSPEC_RANDOM_STEPS=1000000 $(BIN)/pytest -n 3 tests/plc_output/test_device_blocks.py tests/plc_output/test_simulated_blocks.py tests/plc_output/test_blocks_at_random.py -k whatever_happens

# Needs matiec, gcc-arm-none-eabi and libnewlib-arm-none-eabi.
plc-sizes: $(INSTALLED)
	$(BIN)/python benchmarks/plc_size.py

accept: $(INSTALLED)
	$(BIN)/pytest --accept $(if $(RULE),tests/test_cases.py tests/test_changes.py tests/test_rules.py -k "$(RULE) or page_of_")

# The peers have an environment of their own.
bench: $(INSTALLED_PEERS) $(if $(NPM),$(PEERS)/node_modules/.package-lock.json)
	$(BENCH)/$(notdir $(BIN))/python benchmarks/run.py $(ONLY)

# Every broken link, and every page that no other one leads to, ends it.
docs-site: build $(INSTALLED_WRITER)
	$(WRITER)/bin/python -m sphinx --fail-on-warning --keep-going --quiet -b html docs build/site

extension: extension/node_modules/.package-lock.json
	mkdir -p build
	cd extension && npm run --silent package

pins: $(INSTALLED)
	$(PIP) install --quiet $(UV)
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.10 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  --extra dev pyproject.toml --output-file $(PINS)
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.10 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  --constraint $(PINS) pyproject.toml requirements/run.in --output-file requirements/run.txt
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.11 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  pyproject.toml benchmarks/requirements.in --output-file requirements/bench.txt
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.10 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  requirements/sbom.in --output-file requirements/sbom.txt
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.11 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  requirements/fuzz.in --output-file requirements/fuzz.txt
	$(BIN)/uv pip compile --quiet --upgrade --universal --python-version 3.11 --generate-hashes \
	  --no-emit-index-url --no-emit-find-links --custom-compile-command "make pins" \
	  requirements/docs.in --output-file requirements/docs.txt

clean:
	rm -rf $(VENV) $(BENCH) $(PEERS)/node_modules tests/tools/node_modules extension/node_modules build dist .mypy_cache .pytest_cache .ruff_cache .hypothesis

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 10))' || \
	  { echo "$(PYTHON) is missing or older than 3.10; name a newer one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "$(PYTHON) cannot make virtual environments; install python3-venv (as root: apt-get install python3-venv)" >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)

$(INSTALLED): $(PINS) pyproject.toml codegen/fieldspec/__init__.py | $(BIN)/python
	$(PIP) install --quiet --require-hashes --requirement $(PINS)
	$(PIP) install --quiet --no-build-isolation --no-deps --editable .
	@touch $@

$(TOOLS): tests/tools/package.json tests/tools/package-lock.json
	cd tests/tools && npm ci --no-audit --no-fund
	@touch $@

$(INSTALLED_PEERS): requirements/bench.txt pyproject.toml
	$(PYTHON) -m venv $(BENCH)
	$(BENCH)/$(notdir $(BIN))/python -m pip --disable-pip-version-check install --quiet --require-hashes --requirement $<
	$(BENCH)/$(notdir $(BIN))/python -m pip --disable-pip-version-check install --quiet --no-build-isolation --no-deps --editable .
	@touch $@

$(INSTALLED_FUZZER): requirements/fuzz.txt
	$(PYTHON) -m venv $(FUZZER)
	$(FUZZER)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes --requirement $<
	@touch $@

$(INSTALLED_WRITER): requirements/docs.txt
	$(PYTHON) -m venv $(WRITER)
	$(WRITER)/bin/python -m pip --disable-pip-version-check install --quiet --require-hashes --requirement $<
	@touch $@

extension/node_modules/.package-lock.json: extension/package.json extension/package-lock.json
	cd extension && npm ci --no-audit --no-fund
	@touch $@

$(PEERS)/node_modules/.package-lock.json: $(PEERS)/package.json $(PEERS)/package-lock.json
	cd $(PEERS) && npm ci --no-audit --no-fund
	@touch $@
