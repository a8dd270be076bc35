# Run `make demo` or `make test` on a fresh machine: each sets up what it needs in .venv and ./target, without root.
# A second run does no set-up work: stamps in .venv remember what is installed and built.

PYTHON ?= python3
OUT ?= out
# A wheel to install instead of building, which needs no Rust: `make demo WHEEL=nearfar-….whl`.
WHEEL ?=
# Minutes that `make attack` takes, and seconds that `make fuzz` takes for each target.
ATTACK_MINUTES ?= 60
FUZZ_SECONDS ?= 120

# The commit before the change, for `make test-changed`: .ci/landed holds the newest one that .ci/run has passed on.
BASE ?= $(shell cat .ci/landed 2>/dev/null)

bin := .venv/bin
rust_sources := $(shell find rust -name '*.rs' -o -name Cargo.toml) Cargo.toml Cargo.lock
# Python compiles a module when it is first imported; pip would compile all of them.
pip := $(bin)/python -m pip install --quiet --disable-pip-version-check --no-compile
# Not empty if Rust differs from BASE, or may: its lints and its tests compile it twice more.
rust_changed = $(shell git merge-base --is-ancestor $(BASE) HEAD 2>/dev/null && git diff --quiet $(BASE) -- $(rust_parts) && test -z "$$(git ls-files --others --exclude-standard $(rust_parts))" || echo yes)
rust_parts := rust fuzz Cargo.toml Cargo.lock rustfmt.toml Makefile
# With this variable set, each program that a test starts compiles all that it imports again.
unexport PYTHONDONTWRITEBYTECODE
# Much of compiling takes one core, which leaves the other one to pip and the linters.
MAKEFLAGS += -j3
# pyo3's build script asks for the interpreter; one answer for maturin and cargo keeps them from rebuilding in turns.
export PYO3_PYTHON := $(CURDIR)/$(bin)/python

.PHONY: help demo page test check test-slow test-changed test-third lint lint-rust lint-python lint-fuzz lint-web test-rust test-adapters bench notebooks stress attack fuzz mutations setup clean
.DELETE_ON_ERROR:

# List the targets.
help:
	@awk '/^# /{text = substr($$0, 3)} /^[a-z]+:/{sub(":.*", ""); if (text) printf "%-10s %s\n", $$0, text} !/^# /{text = ""}' Makefile

# The main job on the procedural city: near.glb, far.exr, pictures, load curve and a report in out/demo.
demo: .venv/built
	mkdir -p $(OUT)
	$(bin)/nearfar reduce -i city -o $(OUT)/demo

# Formatting, lints and types of Python and of the page, and tests; `make test-slow` runs those that take seconds each.
test: lint-python lint-web .venv/built .venv/test
	$(bin)/python -m pytest -n auto --dist worksteal

# The same, and lints and tests of Rust if it differs from BASE.
check: test $(if $(rust_changed),lint-rust test-rust)

# Tests that take seconds each: whole programs, notebooks, real scenes, other programs' readers and exporters. `make test` leaves them out.
test-slow: .venv/built .venv/test .venv/readers .venv/exporters .venv/web
	$(bin)/python -m pytest -n auto --dist worksteal -m "slow and not stress"

# The slow tests of the stages that changed since BASE, and of those that use them.
test-changed: .venv/built .venv/test .venv/readers .venv/exporters .venv/web $(if $(rust_changed),lint-fuzz test-adapters)
	$(bin)/python -m tests.slow changed $(BASE)

# One third of the other slow tests: the next one with each commit.
test-third: .venv/built .venv/test .venv/readers .venv/exporters .venv/web
	$(bin)/python -m tests.slow third $(BASE)

# Formatting, lints and types only.
lint: lint-rust lint-python lint-web

# In the debug profile, whose folder the build of the package does not lock.
lint-rust: .venv/made
	cargo fmt --all --check
	cargo clippy --quiet --workspace --all-targets -- -D warnings

# Types come from stubs, so that nothing need be built: it runs while the build leaves a core free.
lint-python: .venv/test
	$(bin)/ruff format --check --quiet .
	$(bin)/ruff check --quiet .
	$(bin)/mypy

# Types of the page's sources, where npm is there.
lint-web: .venv/web
	@if [ -d web/node_modules ]; then cd web && npx tsc --noEmit; fi

# A workspace of its own, which takes half a minute and seldom changes: `make test` leaves it out.
lint-fuzz:
	cargo fmt --all --check --manifest-path fuzz/Cargo.toml
	RUSTFLAGS='--cfg fuzzing' cargo clippy --quiet --all-targets --manifest-path fuzz/Cargo.toml -- -D warnings

# Of the core and the server, in the linters' profile and after them: building the package leaves a core free for most of its time.
# Without optimization, because compiling takes longer than all tests do.
test-rust: lint-rust
	CARGO_INCREMENTAL=0 cargo test --quiet -p nearfar-core -p nearfar-serve --lib

# Rust tests on graphics adapters, whose crates take minutes to compile; `make test` draws on adapters from Python.
test-adapters:
	CARGO_INCREMENTAL=0 cargo test --quiet -p nearfar-gpu --lib

# Run time against error for every kernel and its peers, as tables in out/bench.
bench: .venv/built .venv/bench
	$(bin)/python scripts/bench.py $(OUT)/bench

# Run the notebooks and keep them with their pictures in out/notebooks.
notebooks: .venv/built .venv/test
	$(bin)/python scripts/notebooks.py $(OUT)/notebooks

# Large sizes and many random cases: the whole of Tokyo, tens of millions of triangles, thousands of examples.
stress: .venv/built .venv/test .venv/readers .venv/exporters .venv/web
	cargo test --release --quiet --workspace -- --include-ignored
	NEARFAR_HYPOTHESIS=thorough $(bin)/python -m pytest -m "stress or not stress"

# Hostile files, arguments, signals, kills and full disks for an hour; its table and findings are in out/attack.
attack: .venv/built .venv/test
	$(bin)/python -m tests.attack --minutes $(ATTACK_MINUTES) --out $(OUT)/attack

# Random bytes and numbers for the core's decoders and kernels and for the server; needs nightly Rust and cargo-fuzz.
fuzz: lint-fuzz
	@if ! cargo +nightly fuzz --version > /dev/null 2>&1; then \
		echo "fuzz: skipped; 'rustup toolchain install nightly' and 'cargo install cargo-fuzz' make it run"; \
	else for target in $$(cargo +nightly fuzz list); do \
		mkdir -p fuzz/found/$$target fuzz/corpus/$$target; \
		cargo +nightly fuzz run $$target fuzz/found/$$target fuzz/corpus/$$target -- \
			-max_total_time=$(FUZZ_SECONDS) -rss_limit_mb=4096 -timeout=10 || exit 1; \
	done; fi

# Seed faults and find out whether the tests of their stages catch them: 40 minutes of a core; its table is in out/mutations.
mutations: .venv/built .venv/test .venv/web .venv/readers
	$(bin)/python -m scripts.mutations --out $(OUT)/mutations

# Make .venv and build, without running anything.
setup: .venv/built .venv/test

# Remove what was built, installed and written.
clean:
	rm -rf .venv target $(OUT) python/nearfar/_core.abi3.so tests/readers/node_modules tests/exporters/node_modules web/node_modules web/build

# The environment itself, once cargo is known to be there.
.venv/made:
	$(PYTHON) -c 'import sys; sys.exit("nearfar: Python 3.11 or newer is needed, found " + sys.version.split()[0] if sys.version_info < (3, 11) else 0)'
	$(if $(WHEEL),,$(PYTHON) scripts/nearfar_build.py)
	$(PYTHON) -m venv .venv
	touch $@

# Packages for nearfar and its demo.
.venv/base: .venv/made pyproject.toml scripts/requirements.py
	$(bin)/python scripts/requirements.py lod plot > .venv/base.txt
	$(pip) -r .venv/base.txt
	touch $@

# Tools of the tests and notebooks. pyrender pins a PyOpenGL that cannot be loaded: it comes without its requirements.
.venv/test: .venv/base
	$(bin)/python scripts/requirements.py lod orthoview stream cluster plot notebook test crosscheck > .venv/test.txt
	$(pip) -r .venv/test.txt
	$(pip) --no-deps pyrender==0.1.45
	touch $@

# Readers of glTF, 3D Tiles and Zarr from npm; without it the tests that run them skip.
.venv/readers: .venv/made tests/readers/package.json tests/readers/package-lock.json
	@if command -v npm > /dev/null; then \
		npm ci --prefix tests/readers --ignore-scripts --no-audit --no-fund --loglevel=error && touch $@; \
	else echo "readers: skipped; they need npm (scripts/system-packages.sh)"; fi

# Exporters of glTF from npm; without it the tests of their files skip.
.venv/exporters: .venv/made tests/exporters/package.json tests/exporters/package-lock.json
	@if command -v npm > /dev/null; then \
		npm ci --prefix tests/exporters --ignore-scripts --no-audit --no-fund --loglevel=error && touch $@; \
	else echo "exporters: skipped; they need npm (scripts/system-packages.sh)"; fi

# Tools that build and check the page; the package holds the built page, so that nobody else needs it.
.venv/web: .venv/made web/package.json web/package-lock.json
	@if command -v npm > /dev/null; then \
		npm ci --prefix web --ignore-scripts --no-audit --no-fund --loglevel=error && touch $@; \
	else echo "web: skipped; it needs npm (scripts/system-packages.sh)"; fi

# Build the page that `nearfar view` shows into the package.
page: .venv/web
	cd web && npx tsc --noEmit && node build.mjs

# Peers that only the benchmarks compare with.
.venv/bench: .venv/test
	$(bin)/python scripts/requirements.py bench > .venv/bench.txt
	$(pip) -r .venv/bench.txt
	touch $@

# The package: a wheel if one is given, else the extension is built in release and placed in python/nearfar, so that
# editing Python needs no new build.
.venv/built: .venv/base $(rust_sources) scripts/nearfar_build.py
	$(pip) --no-deps $(or $(WHEEL),--no-build-isolation --editable .)
	touch $@
