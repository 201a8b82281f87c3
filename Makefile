# make figures        install what is missing, build, and draw the paper into build/figures: Figure 1, still
#                     and moving (motion.gif), Figures 2 to 5, Table I, exit boundaries, the inferred
#                     frequencies, what other procedures give, error against run time; then check every key
#                     number
# make test           install what is missing, build, and run every test
#
# make figure2 ...    draw one picture
# make beyond         draw the rest: stiff and extreme cases, and what goes beyond the paper (minutes)
# make pictures       draw all and renew figures/pictures, which the documents show
# make check          compare every key number, published number and fragment of a document
# make build          build the library and the program only
# make test-sanitize  run the tests of the library and the program under the address and
#                     undefined-behaviour sanitizers, and sweeps under the thread sanitizer (minutes)
# make reference      recompute the 50-digit tables in reference/tables/ (more than an hour)
# make docs           write the public headers and the walk through one impact as HTML, build/docs
# make deps           install the packages that are missing, and nothing else
# make clean          remove build/
#
# Variable: preset=release, a preset of CMakePresets.json (release, werror, dev, clang, sanitize, threads)

drawn  := $(filter-out style,$(basename $(notdir $(wildcard figures/*.gp figures/*/*.gp))))
jobs   := $(shell nproc 2>/dev/null || echo 1)
preset := release
tests  := test_programs
folder := build$(addprefix /,$(filter dev clang sanitize threads,$(preset)))

.PHONY: help figures beyond pictures $(drawn) check build test test-sanitize reference docs deps clean
.NOTPARALLEL:  # the targets share build/, and each uses all processors
MAKEFLAGS += --no-print-directory

help:
	@sed -n '/^# make /,/^$$/s/^# \{0,1\}//p' Makefile

# Installs the packages of a part (.ci/packages) and configures the build.
configured-%:
	@mkdir -p $(folder)
	@.ci/packages $*
	@cmake --preset $(preset) >$(folder)/configure.log 2>&1 || { cat $(folder)/configure.log; exit 2; }

make_target = @cmake --build --preset $(preset) -j $(jobs) --target

build: configured-runner
	$(make_target) vibro-impact

figures: configured-figures
	$(make_target) figures_programs
	@cmake --build --preset $(preset) --target figures
	@$(folder)/bin/check >$(folder)/check.log || { cat $(folder)/check.log; exit 1; }
	@tail -n 1 $(folder)/check.log

beyond pictures: configured-figures
	$(make_target) figures_programs beyond_programs vibro-impact
	@cmake --build --preset $(preset) --target $@

$(drawn): configured-figures
	$(make_target) $@
	@cmake --build --preset $(preset) --target draw_$@

test: configured-tests
	$(make_target) $(tests)
	@ctest --preset $(preset) -j $(jobs)

check: configured-runner
	$(make_target) check quoted_tables
	@$(folder)/bin/check

test-sanitize:
	@.ci/packages clang
	@$(MAKE) test preset=sanitize
	@$(MAKE) test preset=threads tests="analysis_tests program_tests vibro-impact"

reference: configured-runner
	$(make_target) reference-generate
	@for scene in figure2 figure4a figure4b figure5a figure5b figure5c chain10 chain200; do \
	  $(folder)/bin/reference-generate $$scene reference/tables/$${scene}_events.csv || exit 2; done
	@$(folder)/bin/reference-generate checked_numbers reference/tables/checked_numbers.csv || exit 2
	@$(folder)/bin/reference-generate extremes reference/tables/extreme_events.csv || exit 2
	@for part in states events; do \
	  $(folder)/bin/reference-generate work_precision_$$part reference/tables/work_precision_$$part.csv || exit 2; done

docs:
	@.ci/packages docs
	@mkdir -p build/docs
	@(cat lib/Doxyfile; echo "OUTPUT_DIRECTORY = build/docs") | doxygen -
	@ln -sfn /usr/share/javascript/mathjax build/docs/mathjax
	@echo "written: build/docs/index.html"

deps:
	@.ci/packages runner figures tests

clean:
	@rm -rf build
