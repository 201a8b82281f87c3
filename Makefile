# make figures        install what is missing, build, and draw the paper (build/figures): Figures 2 to 5,
#                     error against run time, and the key numbers, checked
# make beyond         everything else that is drawn: stability, and what goes beyond the paper (minutes)
# make report         the reproduction report, one HTML page, from what these two have left
# make figure2 ...    one figure; also stability, figure3_followed, reconstruction, multi_sliding, bifurcations, exit_boundary,
#                     table1, atlas, curves, border_cascade, basins, long_chain
# make error-vs-runtime  error against run time, beside other methods (under a minute)
# make peers          install SUNDIALS and Siconos, and draw that with them in it
# make atlas-full     the (Omega, r) atlas at 2000 x 1500 points (20 minutes on two processors; ended, it goes on when called again)
# make build          the library and the scene runner, nothing else
# make test           build and run every test
# make check          every key number and published result: what agrees with the paper, differs from it, is not in it
# make readme         the tables of key numbers in README.md and reference/README.md, from the same source
# make test-sanitize  the tests under the address and undefined-behaviour sanitizers
# make random-scenes  60,000 scenes, ordinary, extreme and degenerate, every property checked (minutes)
# make fuzz           the command line and the table readers under libFuzzer, seconds=60 (needs clang)
# make benchmarks     micro-benchmarks of the steps of the pipeline (needs libbenchmark-dev)
# make compare        the tables drawn, against the run stored in the repository
# make store          draw everything and store that run instead
# make pictures       draw everything and copy it to figures/pictures, where the README shows it
# make docs           the public headers and a walk through one impact as HTML, build/docs/index.html
# make reference      recompute the 50-digit tables in reference/ (a quarter of an hour)
# make packages       install what is missing, and nothing else
# make format         clang-format on every source
# make dist           the source archive, build/vibro-impact-<version>.tar.gz
# make clean          remove build/

paper  := figure2 figure3 figure4 figure5 table1 exit_boundary multi_sliding reconstruction
beyond := stability figure3_followed bifurcations atlas curves border_cascade basins long_chain
jobs   := $(shell nproc 2>/dev/null || echo 1)
werror := OFF

.PHONY: benchmarks figures beyond $(paper) $(beyond) error-vs-runtime atlas-full test check readme pictures random-scenes fuzz test-sanitize report compare store docs peers reference format dist clean help packages build
.NOTPARALLEL:  # the targets share build/; each of them uses all processors
MAKEFLAGS += --no-print-directory

help:
	@sed -n '/^# make /,/^$$/s/^# //p' Makefile

# Every target installs the packages of its part (.ci/packages), configures build/, the same for
# all parts, and builds in it what it needs and no more. The figures do without MPI, the search for
# which takes longer than all else that is configured.
configured-%:
	@mkdir -p build
	@.ci/packages $*
	@cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DVIBRO_IMPACT_WERROR=$(werror) \
	  -DCMAKE_DISABLE_FIND_PACKAGE_MPI=$(if $(filter figures,$*),ON,OFF) >build/configure.log 2>&1 || { cat build/configure.log; exit 2; }

make_target = @cmake --build build -j $(jobs) --target

build: configured-runner
	@cmake --build build -j $(jobs)

figures: configured-figures
	$(make_target) paper_programs
	@$(MAKE) $(paper) error-vs-runtime
	@build/bin/check --tables build/figures >build/check.log || { cat build/check.log; exit 1; }
	@tail -n 1 build/check.log

# All are computed before the first is drawn: the atlas shows the curves, the curves the atlas.
beyond: configured-figures
	$(make_target) beyond_programs
	@$(MAKE) $(beyond:%=computed-%) $(beyond:%=drawn-%)

$(paper) $(beyond): %: computed-% drawn-%

computed-%: configured-figures
	$(make_target) $*
	@build/bin/$* --output build/figures

drawn-%: configured-figures
	@for kind in png pdf; do gnuplot -e "data='build/figures'; kind='$$kind'" $(wildcard figures/$*.gp figures/*/$*.gp) || exit; done
	@echo "drawn: build/figures/$*.png"

error-vs-runtime: configured-figures
	$(make_target) error_vs_runtime
	@OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 build/bin/error_vs_runtime --output build/figures
	@$(MAKE) drawn-error_vs_runtime

# What a fresh machine does not have; CMake looks for them again.
peers:
	@.ci/packages figures peers
	@rm -f build/CMakeCache.txt
	@$(MAKE) error-vs-runtime
atlas-full: configured-runner
	$(make_target) vibro-impact
	@mkdir -p build/figures
	@build/bin/vibro-impact sweep --vary omega=0.2:0.8:2000 --vary restitution=0:0.98:1500 --longest 200 \
	  --table build/figures/atlas_full.csv --resume

test: configured-tests
	$(make_target) test_programs
	@ctest --test-dir build --output-on-failure -j $(jobs)

check: configured-runner
	$(make_target) check
	@build/bin/check

# The rows go between the two markers; nothing else of the file changes.
readme: configured-runner
	$(make_target) check
	@build/bin/check --few >build/few.md
	@build/bin/check --markdown >build/markdown.md
	@set -e; for table in few:README.md markdown:reference/README.md; do \
	  sed -e '/<!-- make readme: begin -->/,/<!-- make readme: end -->/{//!d}' \
	    -e "/<!-- make readme: begin -->/r build/$${table%%:*}.md" $${table#*:} >build/filled.md; \
	  cp build/filled.md $${table#*:}; done

test-sanitize:
	@mkdir -p build
	@.ci/packages tests
	@cmake -S . -B build/sanitize -DCMAKE_BUILD_TYPE=Debug -DVIBRO_IMPACT_SANITIZE=ON >build/sanitize.log 2>&1 || { cat build/sanitize.log; exit 2; }
	@cmake --build build/sanitize --target test_programs -j $(jobs)
	@ctest --test-dir build/sanitize --output-on-failure -j $(jobs)

benchmarks: configured-tests
	$(make_target) benchmarks >build/benchmarks.log 2>&1 || { \
	  grep -q "No rule to make target" build/benchmarks.log && echo "make benchmarks needs Google Benchmark (Debian package libbenchmark-dev)" >&2 || cat build/benchmarks.log; exit 2; }
	@build/bin/benchmarks

random-scenes: configured-tests
	$(make_target) random_scenes_test
	@build/bin/random_scenes_test 20000

seconds := 60
fuzz:
	@command -v clang++ >/dev/null || { echo "make fuzz needs clang++ (Debian package clang)" >&2; exit 2; }
	@mkdir -p build/fuzz/corpus build/fuzz/found
	@.ci/packages runner
	@cmake -S . -B build/fuzz -DCMAKE_CXX_COMPILER=clang++ -DVIBRO_IMPACT_FUZZ=ON >build/fuzz.log 2>&1 || { cat build/fuzz.log; exit 2; }
	@cmake --build build/fuzz -j $(jobs)
	@build/fuzz/bin/fuzz_options -max_total_time=$(seconds) -timeout=10 -max_len=600 -print_final_stats=1 \
	  -dict=tests/program/fuzz_options.dict \
	  -artifact_prefix=build/fuzz/found/ build/fuzz/corpus tests/program/fuzz_inputs

pictures: figures beyond
	@mkdir -p figures/pictures
	@cp build/figures/*.png figures/pictures/

reference: configured-library
	$(make_target) reference-generate reference-generate-100
	@for scene in figure2 figure4a figure4b figure5a figure5b figure5c; do \
	  build/bin/reference-generate $$scene reference/$${scene}_events.csv || exit 2; done
	@for table in key_numbers located; do \
	  build/bin/reference-generate $$table reference/$$table.csv || exit 2; done
	@build/bin/reference-generate-100 located reference/located_100.csv || exit 2
	@build/bin/reference-generate-100 key_numbers build/key_numbers_100.csv || exit 2
	@cmp build/key_numbers_100.csv reference/key_numbers.csv
	@build/bin/reference-generate extremes reference/extreme_events.csv || exit 2
	@build/bin/reference-generate degenerate reference/degenerate_events.csv || exit 2
	@for part in states events; do \
	  build/bin/reference-generate work_precision_$$part reference/work_precision_$$part.csv || exit 2; done

# From what `make figures` and `make beyond` have left.
report: configured-figures
	$(make_target) provenance report
	@build/bin/provenance >build/compare.log || true
	@build/bin/report
	@echo "written: build/report.html"

# The figures drawn, against the run stored in the repository; and, to be committed, in its place.
compare: configured-figures
	$(make_target) provenance
	@build/bin/provenance
store: figures beyond
	$(make_target) provenance
	@build/bin/provenance --store

docs:
	@.ci/packages docs
	@mkdir -p build/docs
	@(cat lib/Doxyfile; echo "OUTPUT_DIRECTORY = build/docs"; echo "PROJECT_NUMBER = $(version)") | doxygen -
	@ln -sfn /usr/share/javascript/mathjax build/docs/mathjax
	@echo "written: build/docs/index.html"

packages:
	@.ci/packages

format:
	@git ls-files '*.hpp' '*.cpp' | xargs clang-format -i

# What is committed, under one folder; .commit says which commit it was.
version := $(shell sed -n 's/^project.vibro_impact VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
dist:
	@mkdir -p build
	@git archive --format=tar.gz --prefix=vibro-impact-$(version)/ -o build/vibro-impact-$(version).tar.gz HEAD
	@echo "written: build/vibro-impact-$(version).tar.gz"

clean:
	@rm -rf build
