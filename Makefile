# make figures        install what is missing, build, compute and draw every figure (build/figures)
# make figure2 ...    one figure
# make error-vs-runtime  error against run time, beside other methods (under a minute)
# make test           the same packages and build, then every test
# make check          the key numbers: paper, computed, error, verdict
# make readme         the README's table of key numbers, from the same source as make check
# make test-sanitize  the tests under the address and undefined-behaviour sanitizers
# make random-scenes  20,000 ordinary and 20,000 extreme scenes, every property checked (minutes)
# make fuzz           the command line and the table readers under libFuzzer, seconds=60 (needs clang)
# make benchmarks     micro-benchmarks of the steps of the pipeline (needs libbenchmark-dev)
# make pictures       copy the drawn figures to figures/pictures, where the README shows them
# make reference      recompute the 50-digit event tables in reference/ (minutes)
# make format         clang-format on every source
# make clean          remove build/

figures := figure2 figure3 figure4 figure5 multi_sliding bifurcations exit_boundary table1 comparison stability
jobs    := $(shell nproc 2>/dev/null || echo 1)

.PHONY: benchmarks figures $(figures) error-vs-runtime test check readme pictures random-scenes fuzz test-sanitize reference format clean help packages build

help:
	@sed -n 's/^# //p' Makefile

figures: $(figures) error-vs-runtime

$(figures): build
	@build/bin/$@ --output build/figures
	@gnuplot -e "data='build/figures'" figures/$@.gp
	@echo "drawn: build/figures/$@.png"

error-vs-runtime: build
	@OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 build/bin/error_vs_runtime --output build/figures
	@gnuplot -e "data='build/figures'" figures/error_vs_runtime.gp
	@echo "drawn: build/figures/error_vs_runtime.png"

test: build
	@ctest --test-dir build --output-on-failure -j $(jobs)

check: build
	@build/bin/check

# The rows go between the two markers; nothing else of the file changes.
readme: build
	@build/bin/check --markdown >build/key_numbers.md
	@sed -e '/<!-- make readme: begin -->/,/<!-- make readme: end -->/{//!d}' \
	  -e '/<!-- make readme: begin -->/r build/key_numbers.md' README.md >build/README.md
	@cp build/README.md README.md

test-sanitize: packages
	@cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=Debug -DVIBRO_IMPACT_SANITIZE=ON >build/sanitize.log 2>&1 || { cat build/sanitize.log; exit 2; }
	@cmake --build build/sanitize --target test_programs -j $(jobs)
	@ctest --test-dir build/sanitize --output-on-failure -j $(jobs)

benchmarks: packages
	@mkdir -p build
	@cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >build/configure.log || { cat build/configure.log; exit 2; }
	@cmake --build build --target benchmarks -j $(jobs) >build/benchmarks.log 2>&1 || { \
	  grep -q "No rule to make target" build/benchmarks.log && echo "make benchmarks needs Google Benchmark (Debian package libbenchmark-dev)" >&2 || cat build/benchmarks.log; exit 2; }
	@build/bin/benchmarks

random-scenes: build
	@build/bin/random_scenes_test 20000

seconds := 60
fuzz: packages
	@command -v clang++ >/dev/null || { echo "make fuzz needs clang++ (Debian package clang)" >&2; exit 2; }
	@mkdir -p build/fuzz/corpus build/fuzz/found
	@cmake -S . -B build/fuzz -DCMAKE_CXX_COMPILER=clang++ -DVIBRO_IMPACT_FUZZ=ON >build/fuzz.log 2>&1 || { cat build/fuzz.log; exit 2; }
	@cmake --build build/fuzz -j $(jobs)
	@build/fuzz/bin/fuzz_options -max_total_time=$(seconds) -timeout=10 -max_len=600 -print_final_stats=1 \
	  -dict=tests/fuzz_options.dict -artifact_prefix=build/fuzz/found/ build/fuzz/corpus tests/fuzz_inputs

pictures: figures
	@mkdir -p figures/pictures
	@cp $(figures:%=build/figures/%.png) build/figures/error_vs_runtime.png figures/pictures/

reference: build
	@cmake --build build --target reference-generate
	@for scene in figure2 figure4a figure4b figure5a figure5b figure5c; do \
	  build/bin/reference-generate $$scene reference/$${scene}_events.csv || exit 2; done
	@for table in key_numbers located; do \
	  build/bin/reference-generate $$table reference/$$table.csv || exit 2; done
	@build/bin/reference-generate extremes reference/extreme_events.csv
	@for part in states events; do \
	  build/bin/reference-generate work_precision_$$part reference/work_precision_$$part.csv || exit 2; done

build: packages
	@mkdir -p build
	@cmake -S . -B build -DCMAKE_BUILD_TYPE=Release >build/configure.log || { cat build/configure.log; exit 2; }
	@cmake --build build -j $(jobs)

packages:
	@mkdir -p build
	@.ci/packages

format:
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

clean:
	@rm -rf build
