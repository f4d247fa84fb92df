# make demo         run the application with a simulated glove and camera
# make test         linters and tests, with the type checker and import contracts in parallel (their
#                   output is printed last); tests on real recordings read data/ or the folder in
#                   GLOVETRACK_DATA, and are skipped if it does not exist; those of the firmware need
#                   its compiler and a chip simulator (system packages), and are skipped without them
# make test-long    the tests that make test leaves out: marked "long", each takes seconds to minutes
# make lint         linters, spelling, type checker and import contracts, without the tests
# make firmware     build the glove's firmware and its simulator; prints their sizes
# make openxr-layer compile the OpenXR API layer, which gives the hand to any OpenXR application
# make screenshots  images of the window for the documentation
# make translations list the window's texts for translators (resources/translations)
# make docs         the documentation as a static site, build/site/index.html
# make package      dist/glovetrack, the program with its own Python, and packages of it
# make wheel        dist/glovetrack-*.whl with the compiled kernels, for this Python and system
# make bench        measure speed and accuracy against the goals, into bench.json; ten minutes for the app
# make bench-peers  install MediaPipe Hands for it in a separate environment (it requires numpy 1)
# make kernels      compile kernels that were changed, as make demo, make test and the window's start also do
# make lock         regenerate requirements.lock in a fresh environment
# make clean        remove build outputs, measurements and the virtual environment
#
# Each target installs its requirements: .venv from requirements.lock (make demo) or
# requirements-test.lock, and system packages (with apt-get as root; otherwise it prints the command).

VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
INSTALLED_FOR_TESTS := $(VENV)/.installed-for-tests
READY := $(VENV)/.ready
READY_FOR_TESTS := $(VENV)/.ready-for-tests
KERNEL_SOURCES := $(shell grep -rl --include='*.py' '^@kernel' app extensions tracker)
SCREEN := $(or $(DISPLAY),$(WAYLAND_DISPLAY),$(filter Darwin,$(shell uname -s)))
OFFSCREEN := QT_QPA_PLATFORM=offscreen
FIRMWARE_BUILD := build/firmware
PEERS := build/peers
# Tests wait for processes, disks and devices: one extra worker keeps all cores in use.
WORKERS := $(shell expr $$(getconf _NPROCESSORS_ONLN) + 1)
# Tests start hundreds of processes. Many container images disable bytecode caching, in which case
# each process would recompile every module.
KEPT := PYTHONDONTWRITEBYTECODE=
PYTEST = $(KEPT) $(OFFSCREEN) $(BIN)/pytest -n $(WORKERS) --dist worksteal --durations=30
TYPES := $(BIN)/mypy && $(BIN)/lint-imports

.PHONY: demo test test-long lint firmware openxr-layer screenshots translations docs package wheel bench bench-peers kernels lock clean
.DELETE_ON_ERROR:

demo: $(READY)
ifneq ($(SCREEN),)
	$(BIN)/glovetrack demo
else
	$(OFFSCREEN) $(BIN)/python -m app --demo --headless-report 30 --out demo --force
endif

test: $(READY_FOR_TESTS)
	packaging/system_libraries.sh firmware-tests openxr-tests
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	packaging/prose.sh $(VENV)
	@mkdir -p build
	{ $(TYPES); } >build/types.txt 2>&1 & types=$$!; \
	$(PYTEST) -m "not long"; tests=$$?; \
	wait $$types; checked=$$?; cat build/types.txt; exit $$((tests + checked))

test-long: $(READY_FOR_TESTS)
	packaging/system_libraries.sh firmware-tests openxr-tests
	$(PYTEST) -m long

lint: $(READY_FOR_TESTS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	packaging/prose.sh $(VENV)
	$(TYPES)

firmware:
	packaging/system_libraries.sh firmware
	$(MAKE) -C resources/firmware BUILD=$(abspath $(FIRMWARE_BUILD)) all size

openxr-layer: $(READY)
	packaging/openxr_layer.sh $(VENV)

screenshots: $(READY_FOR_TESTS)
	$(OFFSCREEN) $(BIN)/python -m app.tools.screenshots --out docs/screenshots
	$(OFFSCREEN) $(BIN)/python -m app.tools.animation --out docs/screenshots/tracking.gif
	$(BIN)/python -m extensions.sheets.pictures --out docs/screenshots

translations: $(READY)
	$(OFFSCREEN) $(BIN)/python -m app.tools.translations

docs: $(READY_FOR_TESTS)
	packaging/site.sh $(BIN)/python build/site

package: $(READY_FOR_TESTS)
	packaging/bundle.sh $(VENV) dist
	if command -v dpkg-deb >/dev/null; then packaging/debian.sh dist; fi

wheel: $(READY_FOR_TESTS)
	packaging/wheel.sh $(VENV) dist

bench: $(READY_FOR_TESTS)
	-$(MAKE) --no-print-directory bench-peers
	$(OFFSCREEN) $(BIN)/python -m tests.benchmarks --json bench.json

bench-peers: $(PEERS)/.ready

$(PEERS)/.ready:
	python3.11 -m venv $(PEERS)
	$(PEERS)/bin/pip install --quiet 'mediapipe==0.10.21' 'numpy<2'
	touch $@

kernels: $(READY_FOR_TESTS)
	packaging/kernels.sh $(VENV)

lock:
	packaging/lock.sh

clean:
	rm -rf build dist demo bench bench.json $(VENV) *.egg-info
	rm -rf .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis
	rm -f tracker/kernels/_compiled* tracker/kernels/_dispatch* extensions/openxr/layer/*glovetrack_openxr.*
	find app extensions glovetrack tracker resources tests -name __pycache__ -prune -exec rm -rf {} +

SET_UP := pyproject.toml packaging/environment.sh packaging/system_libraries.sh \
	$(addprefix tracker/kernels/,build.py aot.py target.py toolchain.py dispatch.c runtime.c module.c)

$(INSTALLED): requirements.lock $(SET_UP)
	packaging/system_libraries.sh app
	packaging/environment.sh $(VENV)
	touch $@

$(INSTALLED_FOR_TESTS): requirements-test.lock $(SET_UP)
	packaging/system_libraries.sh app
	packaging/environment.sh $(VENV) test
	touch $@ $(INSTALLED)

$(READY): $(INSTALLED) $(KERNEL_SOURCES)
	packaging/kernels.sh $(VENV) --for-demo $(if $(SCREEN),--shown)
	touch $@

$(READY_FOR_TESTS): $(INSTALLED_FOR_TESTS) $(KERNEL_SOURCES)
	packaging/kernels.sh $(VENV)
	touch $@ $(READY)
