# make demo         the application on a simulated glove and camera
# make test         linters, all tests, and beside them the type checker and import contracts, whose
#                   words come last; tests on real recordings read data/ or the folder that
#                   GLOVETRACK_DATA names, and are skipped without it
# make lint         the same without the tests
# make firmware     the glove's firmware and its simulator; prints their sizes
# make screenshots  images of the window for the documentation
# make translations lists the window's words for translators (resources/translations)
# make docs         the documentation as a static site, build/site/index.html
# make package      dist/glovetrack, a program that needs no Python, and packages of it
# make wheel        dist/glovetrack-*.whl with the compiled kernels, for this Python and system
# make bench        speed and accuracy against the goals, into bench.json; ten minutes for the app
# make bench-peers  MediaPipe Hands for it, in an environment of its own (it wants numpy 1)
# make kernels      compiled kernels anew, after changes to them; until then numba compiles the changed
# make lock         requirements.lock anew, from a fresh environment
# make clean        removes what was built and measured, and the virtual environment
#
# Each sets up what it needs: .venv from requirements.lock (make demo) or requirements-test.lock, and
# system packages (by apt-get when run by root; otherwise it prints the line to run).

VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
READY_FOR_TESTS := $(VENV)/.ready-for-tests
SCREEN := $(or $(DISPLAY),$(WAYLAND_DISPLAY),$(filter Darwin,$(shell uname -s)))
OFFSCREEN := QT_QPA_PLATFORM=offscreen
FIRMWARE_BUILD := build/firmware
PEERS := build/peers
# Tests wait for processes, disks and devices: with one worker more no core is idle meanwhile.
WORKERS := $(shell expr $$(getconf _NPROCESSORS_ONLN) + 1)
# Tests start hundreds of processes, and each would compile every module anew where the environment
# forbids to keep what was compiled, as many images of containers do.
KEPT := PYTHONDONTWRITEBYTECODE=
TYPES := $(BIN)/mypy && $(BIN)/lint-imports

.PHONY: demo test lint firmware screenshots translations docs package wheel bench bench-peers kernels lock clean
.DELETE_ON_ERROR:

demo: $(READY)
ifneq ($(SCREEN),)
	$(BIN)/glovetrack demo
else
	$(OFFSCREEN) $(BIN)/python -m app --demo --headless-report 30 --out demo --force
endif

test: $(READY_FOR_TESTS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	@mkdir -p build
	{ $(TYPES); } >build/types.txt 2>&1 & types=$$!; \
	$(KEPT) $(OFFSCREEN) $(BIN)/pytest -n $(WORKERS) --dist worksteal --durations=30; tests=$$?; \
	wait $$types; checked=$$?; cat build/types.txt; exit $$((tests + checked))

lint: $(READY_FOR_TESTS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(TYPES)

firmware:
	packaging/system_libraries.sh firmware
	$(MAKE) -C resources/firmware BUILD=$(abspath $(FIRMWARE_BUILD)) all size

screenshots: $(READY_FOR_TESTS)
	$(OFFSCREEN) $(BIN)/python -m app.tools.screenshots --out docs/screenshots

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
	rm -f tracker/kernels/_compiled* tracker/kernels/_dispatch*
	find app glovetrack tracker resources tests -name __pycache__ -prune -exec rm -rf {} +

SET_UP := pyproject.toml packaging/environment.sh packaging/system_libraries.sh \
	tracker/kernels/build.py tracker/kernels/aot.py tracker/kernels/dispatch.c

$(READY): requirements.lock $(SET_UP)
	packaging/system_libraries.sh app
	packaging/environment.sh $(VENV)
	packaging/kernels.sh $(VENV) --for-demo $(if $(SCREEN),--shown)
	touch $@

$(READY_FOR_TESTS): requirements-test.lock $(SET_UP)
	packaging/system_libraries.sh app
	packaging/environment.sh $(VENV) test
	packaging/kernels.sh $(VENV)
	touch $@ $(READY)
