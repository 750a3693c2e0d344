# ParaDT's tools, tests and benchmarks. The library itself needs no building: it is paradt.h.
# A target's "##" text is what `make help` prints. Everything that is built goes under build/.

BUILD    := build
CC       ?= cc
CXX      ?= c++
CFLAGS   ?= -O3
CXXFLAGS ?= -O2
OBJCOPY  ?= objcopy
JOBS     ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
WARNINGS := -Wall -Wextra -Wshadow

# The compiler lists the files that it included in a .d file beside its output. When one of them changes, the output is rebuilt.
DEPENDS = -MMD -MP -MT $@ -MF $@.d
# Sub-makes share the jobs of an outer -j. Without one they use all processors.
PARALLEL = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

MPICC ?= $(shell command -v mpicc.mpich || command -v mpicc)
TOOLS := $(BUILD)/paradt $(if $(and $(MPICC),$(wildcard examples/paradt_mpi.c)),$(BUILD)/paradt_mpi)

# The tools read what gzip has compressed if zlib is there. ZLIB= builds them without it.
ZLIB ?= $(if $(filter clean help,$(MAKECMDGOALS)),,$(shell echo 'int main(void) { return zlibVersion() == 0; }' | \
    $(CC) -include zlib.h -x c -o /dev/null - -lz 2>/dev/null && echo -DPARADT_ZLIB -lz))

.PHONY: all run examples check test bench thesis study study-threads theory lib clean help fuzz soak faults machines coverage \
    test-programs test-list coverage-programs
.DELETE_ON_ERROR:

all: $(TOOLS) ## Build the command-line tools: build/paradt and, where mpicc is found, build/paradt_mpi (the default)

$(BUILD)/paradt: examples/paradt.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(ERRORS) $(DEPENDS) -I. -o $@ $< $(ZLIB) -pthread -lm

$(BUILD)/paradt_mpi: examples/paradt_mpi.c
	@mkdir -p $(@D)
	$(MPICC) $(CFLAGS) $(WARNINGS) $(ERRORS) $(DEPENDS) -I. -o $@ $< $(ZLIB) -pthread -lm

RUN_INPUT   := gen:plummer:100000:1
RUN_OUTPUTS := $(BUILD)/cluster.vtu $(BUILD)/cluster.png

run: $(BUILD)/paradt ## Triangulate and certify a star cluster of 100,000 points; write build/cluster.vtu and build/cluster.png
	@echo "Triangulating $(RUN_INPUT) (a star cluster of 100,000 points) on $(JOBS) processors, and certifying the result:"
	$(BUILD)/paradt --jobs $(JOBS) --check --stats - $(addprefix -o ,$(RUN_OUTPUTS)) $(RUN_INPUT)
	@echo "Certified. Written: $(RUN_OUTPUTS) (ParaView opens the first, any image viewer the second)."

# Each is a program of one file. They are run in the folder that they write their pictures to.
EXAMPLES := $(patsubst examples/%.c,$(BUILD)/examples/%,$(filter-out examples/paradt%,$(wildcard examples/*.c)))

examples: $(EXAMPLES) ## Build and run the examples; their pictures go to build/examples/
	@for e in $(notdir $(EXAMPLES)); do echo "$$e:" && (cd $(BUILD)/examples && ./$$e) || exit 1; done

$(BUILD)/examples/%: examples/%.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(DEPENDS) -o $@ $< -lm

# --- tests -----------------------------------------------------------------------------------------------------------
# tests/*.c are cmocka programs, tests/*.sh print TAP lines. tests/setup.sh installs what it can and writes HAVE_... lines. Tests
# that need what is still missing are skipped and say why.

T        := $(BUILD)/tests
QUICK    := # 1: the core of the tests alone
PROVIDED := $(T)/have.mk
-include $(if $(filter test-programs test-list coverage-programs $(T)/% $(BUILD)/coverage/%,$(MAKECMDGOALS)),$(PROVIDED))

C_TESTS      := $(sort $(wildcard tests/*.c))
# Without in this list the test of the headers' structure runs like the others.
NO_TESTS     := tests/run.sh tests/setup.sh tests/machines.sh tests/coverage.sh
SHELL_TESTS  := $(filter-out $(NO_TESTS),$(sort $(wildcard tests/*.sh)))
FUZZERS      := $(sort $(wildcard fuzz/fuzz_*.c))
# Test programs that include cgal.h need CGAL, those that include voro.h Voro++, and those that include gmp.h or one of these
# other headers GMP.
NEEDS_CGAL   := $(if $(C_TESTS),$(shell grep -lE '^ *# *include *[<"]cgal\.h' $(C_TESTS)))
NEEDS_VORO   := $(if $(C_TESTS),$(shell grep -lE '^ *# *include *[<"]voro\.h' $(C_TESTS)))
NEEDS_GMP    := $(if $(C_TESTS),$(shell grep -lE '^ *# *include *[<"](gmp|oracle|verify|harness)\.h' $(C_TESTS)))
# These run the whole library under the sanitizers. Left out are the comparisons with CGAL and Voro++, whose code is not to be
# tested, a program that only compares the cells of thousands of triangulations, and two that compare numbers with their bounds.
# tests/index16.c has the code without vectors. RACES have threads.
SANITIZED    := $(filter-out $(NEEDS_CGAL) $(NEEDS_VORO) tests/definition.c tests/bounds.c tests/bounds_plain.c,$(C_TESTS))
RACES        := tests/locator.c tests/methods_agree.c tests/lifted_hull.c tests/voronoi.c
# `make check` runs these, and the shell tests in part where they know QUICK.
QUICK_TESTS  := $(filter-out $(NEEDS_CGAL) $(NEEDS_VORO) tests/lifted_hull.c tests/optimality.c tests/resources.c,$(C_TESTS))
QUICK_SHELL  := $(filter %/fuzz_replay.sh %/header_builds.sh %/header_manners.sh %/mpi.sh %/readers.sh %/structure.sh %/tool.sh,$(SHELL_TESTS))
QUICK_ASAN   := $(filter tests/check.c tests/input.c,$(C_TESTS))
# Tests of the library's internals contain the implementation. The others share one object of it, built with the same flags.
OPAQUE       := $(if $(C_TESTS),$(shell grep -L '^ *# *define *PARADT_IMPLEMENTATION' $(C_TESTS)))
# Of tests of internals, these change nothing of the library by macros, so they share its object, too. Public functions are in them
# for inlining alone; only the private ones that they call are compiled again. (In system headers gcc does not warn about that.)
BORROWING    := $(filter tests/check.c tests/delaunay_tree.c tests/insertion.c tests/lifted_hull.c,$(C_TESTS))
BORROW       := '-DPARADT_DEF=extern inline __attribute__((gnu_inline))' -isystem .
INCLUDE       = $(if $(filter $(BORROWING),$<),$(BORROW),-I.) -Itests

missing = $(strip $(if $(HAVE_CMOCKA),,libcmocka-dev) $(if $(filter $1,$(NEEDS_GMP)),$(if $(HAVE_GMP),,libgmp-dev)) \
          $(if $(filter $1,$(NEEDS_VORO)),$(if $(HAVE_VORO),,voro++-dev)) \
          $(if $(filter $1,$(NEEDS_CGAL)),$(if $(HAVE_CGAL),,libcgal-dev libeigen3-dev)))
ready   = $(foreach t,$1,$(if $(call missing,$t),,$t))
program = $(patsubst tests/%.c,$(T)/%,$1)

TEST_PROGRAMS := $(call program,$(call ready,$(if $(QUICK),$(QUICK_TESTS),$(C_TESTS))))
ASAN_PROGRAMS := $(if $(HAVE_SANITIZERS),$(patsubst tests/%.c,$(T)/sanitized/%,$(call ready,$(if $(QUICK),$(QUICK_ASAN),$(SANITIZED)))))
RACE_PROGRAMS := $(if $(QUICK),,$(if $(HAVE_THREAD_SANITIZER),$(patsubst tests/%.c,$(T)/races/%,$(call ready,$(RACES)))))
FUZZ_PROGRAMS := $(FUZZERS:fuzz/%.c=$(T)/fuzz/%)
TEST_INPUT    := $(if $(wildcard tests/programs/families.c),$(T)/families)
CGAL_OBJECTS  := $(patsubst tests/%.cc,$(T)/%.o,$(sort $(wildcard tests/cgal_*.cc)))
GMP_LIBRARY   := $(if $(HAVE_GMP),-lgmp)
# Enough for the lines of a backtrace. Variables would take a third more of the compiler's time.
TRACES        := -g1
# Test programs check the library's invariants; the sanitized ones verify the mesh too (tests/asserts.h).
ASSERTS       := -include tests/asserts.h
# The address sanitizer sees accesses by null pointers and beyond objects, too. Checks for these alone would take a fifth more time.
UNDEFINED     := -fsanitize=undefined -fno-sanitize=null,object-size
SANITIZE      := -DPARADT_VERIFY -fsanitize=address -fno-sanitize-recover=all -fno-omit-frame-pointer
# Tests of the library's internals compile in half of the time of -O2, and run for seconds. The second flag joins products and sums,
# as -O2 does.
LEVEL          = $(if $(filter $(OPAQUE),$<),-O2,-O1 -fexpensive-optimizations)

# Warnings about the tools and the library that the tests share, also those of the optimizer, fail the tests.
test-programs: ERRORS := -Werror
# What takes long to compile comes first, so that no processor is left with it at the end.
test-programs: $(if $(QUICK),,$(if $(wildcard examples/paradt.c),$(TOOLS)) $(TEST_INPUT)) $(RACE_PROGRAMS) $(ASAN_PROGRAMS) $(TEST_PROGRAMS) \
    $(FUZZ_PROGRAMS)

# One of the others watches what the library calls.
WATCHING     := tests/resources.c
LINKED       := $(filter-out $(WATCHING),$(OPAQUE))
# Undefined behaviour is looked for in the object that these share, and in the code without vectors: compilers need as long for its
# checks as for all the rest.
BOTH         := $(LINKED) $(WATCHING) tests/index16.c
# One small check of it makes the compiler link what the shared object's checks call.
CHECKED       = $(if $(filter $(BOTH),$<),$(UNDEFINED),$(if $(filter $(BORROWING),$<),-fsanitize=unreachable))

$(call program,$(LINKED) $(BORROWING)): $(T)/paradt.o
$(call program,$(WATCHING)): $(T)/paradt_watched.o
$(patsubst tests/%.c,$(T)/sanitized/%,$(LINKED) $(BORROWING)): $(T)/sanitized/paradt.o
$(patsubst tests/%.c,$(T)/sanitized/%,$(WATCHING)): $(T)/sanitized/paradt_watched.o
$(patsubst tests/%.c,$(T)/races/%,$(LINKED) $(BORROWING)): $(T)/races/paradt.o

$(T)/paradt.o: MANNER = -O2 $(ERRORS)
$(T)/sanitized/paradt.o: MANNER = -Og $(SANITIZE) $(UNDEFINED)
# Where products and sums can be fused they are, as then what is computed in two ways gives other bits by other tasks
$(T)/races/paradt.o: MANNER = -O1 -fsanitize=thread $(shell grep -qsw fma /proc/cpuinfo && echo -mfma -ffp-contract=fast -fexpensive-optimizations)
%/paradt.o: paradt.h tests/asserts.h
	@mkdir -p $(@D)
	echo '#include "paradt.h"' | $(CC) $(MANNER) $(TRACES) $(ASSERTS) $(WARNINGS) -I. -DPARADT_IMPLEMENTATION -x c -c -o $@ -

%/paradt_watched.o: %/paradt.o
	$(OBJCOPY) $(foreach call,malloc realloc calloc madvise,--redefine-sym $(call)=watched_$(call)) $< $@

$(T)/%: tests/%.c
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) $(LEVEL) $(TRACES) $(ASSERTS) $(WARNINGS) $(DEPENDS) $(INCLUDE) -o $@ $< $(filter %.o,$^) -pthread -lcmocka $(GMP_LIBRARY) -lm

$(call program,$(NEEDS_CGAL)): $(T)/%: tests/%.c $(CGAL_OBJECTS)
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -O2 $(TRACES) $(ASSERTS) $(WARNINGS) $(DEPENDS) -I. -Itests -c -o $@.o $<
	$(CXX) -o $@ $@.o $(filter %.o,$^) -pthread -lcmocka -lmpfr -lgmp -lm

$(call program,$(NEEDS_VORO)): $(T)/%: tests/%.c $(T)/voro.o
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -O2 $(TRACES) $(ASSERTS) $(WARNINGS) $(DEPENDS) -I. -Itests -c -o $@.o $<
	$(CXX) -o $@ $@.o $(filter %.o,$^) -pthread -lcmocka -lvoro++ $(GMP_LIBRARY) -lm

$(T)/voro.o: tests/voro.cc
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(DEPENDS) -I. -Itests -c -o $@ $<

# CGAL's interval arithmetic needs -frounding-math. Without NDEBUG CGAL would check its own results.
$(T)/cgal_%.o: tests/cgal_%.cc
	@mkdir -p $(@D)
	$(CXX) -std=c++17 $(CXXFLAGS) -DNDEBUG -frounding-math $(DEPENDS) -isystem /usr/include/eigen3 -I. -Itests -c -o $@ $<

$(T)/sanitized/%: tests/%.c
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -Og $(TRACES) $(ASSERTS) $(SANITIZE) $(CHECKED) $(WARNINGS) $(DEPENDS) $(INCLUDE) -o $@ $< $(filter %.o,$^) -pthread -lcmocka $(GMP_LIBRARY) -lm

$(T)/races/%: tests/%.c
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -O1 $(TRACES) $(ASSERTS) -fsanitize=thread $(WARNINGS) $(DEPENDS) $(INCLUDE) -o $@ $< $(filter %.o,$^) -pthread -lcmocka $(GMP_LIBRARY) -lm

$(T)/fuzz/%: fuzz/%.c $(T)/$(if $(HAVE_SANITIZERS),sanitized/)paradt.o
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -Og $(TRACES) $(ASSERTS) -DPARADT_FUZZ_STANDALONE -DPARADT_FUZZ_LINKED $(if $(HAVE_SANITIZERS),$(SANITIZE) $(UNDEFINED)) $(WARNINGS) $(DEPENDS) \
	    -I. -o $@ $< $(filter %.o,$^) $(ZLIB) -pthread -lm

$(T)/families: tests/programs/families.c
	@mkdir -p $(@D)
	@rm -f $@
	$(CC) -O2 $(TRACES) $(WARNINGS) $(DEPENDS) -I. -Itests -o $@ $< -lm

# These take longest, the first ones most. They start first, so that no processor is left with one of them at the end.
LONGEST := %/hostile_flags.sh %/mpi.sh %/header_builds.sh %/methods_agree %/resources %/voronoi %/waiting %/equals_cgal %/link.sh \
           %/predicates_flags.sh %/dynamic %/tool.sh %/hull %/locator %/definition %/lifted_hull %/repair %/host
STARTED := $(if $(QUICK),$(QUICK_SHELL),$(SHELL_TESTS)) $(ASAN_PROGRAMS) $(RACE_PROGRAMS) $(TEST_PROGRAMS)

# Prints the runner's list: the programs in the order in which they start, then the skipped tests with their reasons.
test-list:
	@for t in $(foreach l,$(LONGEST),$(filter $l,$(STARTED))) $(filter-out $(LONGEST),$(STARTED)); do echo "$$t"; done
	@$(foreach t,$(if $(QUICK),$(QUICK_TESTS),$(C_TESTS)),$(if $(call missing,$t),echo "skip $(t:tests/%.c=%) needs $(call missing,$t)";)) :
	@$(if $(QUICK)$(HAVE_THREAD_SANITIZER),,echo "skip races needs a compiler with -fsanitize=thread that runs here")
	@$(if $(HAVE_SANITIZERS),,echo "skip sanitized needs a compiler with -fsanitize=address$(comma)undefined")

comma := ,

check: QUICK := 1
check: test ## Run the core of the tests, between two changes (three minutes)

test: ## Run all tests, after installing what they need (apt-get, as root or by sudo) or saying what to install
	@mkdir -p $(T)
	@CC="$(CC)" CXX="$(CXX)" sh tests/setup.sh $(PROVIDED)
	-@$(MAKE) --no-print-directory -k $(PARALLEL) QUICK=$(QUICK) test-programs >$(T)/build.log 2>&1 || \
	    { grep -E 'error|Error|undefined reference' $(T)/build.log | head -40; echo "See $(T)/build.log."; }
	@$(MAKE) --no-print-directory -s QUICK=$(QUICK) test-list >$(T)/list
	@CC="$(CC)" CXX="$(CXX)" JOBS=$(JOBS) QUICK=$(QUICK) sh tests/run.sh $(T)/list $(T)/logs

# Without optimisation the library is built in seconds, and most faults show in small sets.
faults: ## Plant faults one by one, and run the tests that should see them (tests/faults; half an hour on two processors)
	@JOBS=$(JOBS) CC="$(CC)" sh tests/faults/run.sh

machines: $(T)/paradt.o $(TEST_INPUT) ## Compare other processors and builds with this one, and analyse the header (tests/machines.sh)
	@CC="$(CC)" CXX="$(CXX)" sh tests/machines.sh

# Clang counts lines and branches as they are written, whatever is inlined. Assertions are left out, as their failing branch is
# none to cover. The library is built three times: for the vectors that there are, for SSE2, and without vectors. The slowest tests
# have as few sets as under the sanitizers.
COVERAGE := $(BUILD)/coverage
COUNTED  := clang -O1 -fprofile-instr-generate -fcoverage-mapping -w -I. -Itests
FEWER    := $(addprefix %/,bounds bounds_plain definition delaunay_tree dynamic flips host hull lifted_hull methods_agree optimality waiting)
COVERING := $(filter-out $(NEEDS_CGAL) $(NEEDS_VORO),$(C_TESTS))
TWINS    := tests/dynamic.c tests/methods_agree.c tests/repair.c
COVERING_PROGRAMS := $(COVERING:tests/%.c=$(COVERAGE)/best/%) $(FUZZERS:fuzz/%.c=$(COVERAGE)/best/%) \
    $(foreach lanes,sse2 plain,$(TWINS:tests/%.c=$(COVERAGE)/$(lanes)/%) $(COVERAGE)/$(lanes)/fuzz_triangulate) \
    $(COVERAGE)/ranks $(if $(MPICC),$(COVERAGE)/mpi)

coverage: ## Count the lines and branches of the headers that tests and corpora reach (tests/coverage.sh; twenty minutes)
	@mkdir -p $(T) $(COVERAGE)
	@sh tests/setup.sh $(PROVIDED) clang llvm libclang-rt-14-dev libcmocka-dev libgmp-dev mpich libmpich-dev
	@$(MAKE) --no-print-directory -k $(PARALLEL) coverage-programs >$(COVERAGE)/build.log 2>&1 || tail -20 $(COVERAGE)/build.log
	@JOBS=$(JOBS) sh tests/coverage.sh $(COVERING_PROGRAMS)

coverage-programs: $(COVERING_PROGRAMS)

$(COVERAGE)/best/paradt.o: MANNER =
$(COVERAGE)/sse2/paradt.o: MANNER = '-D__builtin_cpu_supports(name)=0'
$(COVERAGE)/plain/paradt.o: MANNER = -DPARADT_NO_SIMD
$(COVERAGE)/%/paradt.o: paradt.h
	@mkdir -p $(@D)
	echo '#include "paradt.h"' | $(COUNTED) $(MANNER) -DPARADT_IMPLEMENTATION -x c -c -o $@ -

$(patsubst tests/%.c,$(COVERAGE)/best/%,$(LINKED)): $(COVERAGE)/best/paradt.o
$(patsubst tests/%.c,$(COVERAGE)/best/%,$(WATCHING)): $(COVERAGE)/best/paradt_watched.o
$(patsubst tests/%.c,$(COVERAGE)/sse2/%,$(TWINS)): $(COVERAGE)/sse2/paradt.o
$(patsubst tests/%.c,$(COVERAGE)/plain/%,$(TWINS)): $(COVERAGE)/plain/paradt.o

define counted_program
$(COVERAGE)/$1/%: tests/%.c
	@mkdir -p $$(@D)
	$(COUNTED) $$(if $$(filter $(FEWER),$$@),-DSANITIZED=1) $$(DEPENDS) -o $$@ $$< $$(filter %.o,$$^) -pthread -lcmocka -lgmp -lm

$(COVERAGE)/$1/fuzz_%: fuzz/fuzz_%.c $(COVERAGE)/$1/paradt.o
	@mkdir -p $$(@D)
	$(COUNTED) -DPARADT_FUZZ_STANDALONE -DPARADT_FUZZ_LINKED $(ZLIB) $$(DEPENDS) -o $$@ $$< $$(filter %.o,$$^) -pthread -lm
endef
$(foreach lanes,best sse2 plain,$(eval $(call counted_program,$(lanes))))

$(COVERAGE)/ranks: tests/programs/ranks.c
	@mkdir -p $(@D)
	$(COUNTED) $(DEPENDS) -Itests/bench/alone -o $@ $< -pthread -lm

$(COVERAGE)/mpi: tests/programs/mpi.c
	@mkdir -p $(@D)
	MPICH_CC=clang OMPI_CC=clang $(MPICC) $(filter-out clang,$(COUNTED)) $(DEPENDS) -Itests/programs -o $@ $< -lm

# --- the rest --------------------------------------------------------------------------------------------------------

FUZZ_SECONDS := 60
fuzz: ## Fuzz each harness (or FUZZ="hull living:2", with weights) for FUZZ_SECONDS=60 without sanitizers and as long with them
	JOBS=$(JOBS) sh fuzz/fuzz.sh $(FUZZ_SECONDS) $(FUZZ)

bench: ## Compare speed and memory with the peers that Debian packages (CGAL, TetGen, Qhull)
	sh tests/bench/run.sh

$(BUILD)/bench/soak: tests/bench/soak.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(DEPENDS) -include tests/asserts.h -DPARADT_IMPLEMENTATION -I. -Itests -o $@ $< -lm

SOAK_FIRST := 0
SOAK_SETS := 10000
soak: $(BUILD)/bench/soak ## Check small random sets of all families by all methods: SOAK_SETS=10000 from number SOAK_FIRST=0 on
	$(BUILD)/bench/soak $(SOAK_FIRST) $(SOAK_SETS)

thesis: $(TOOLS) ## Repeat the thesis' experiment over MPI, beside its own figures (about 20 minutes)
	sh tests/bench/thesis.sh

$(BUILD)/bench/study: tests/bench/study.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(DEPENDS) -Itests/bench/alone -I. -o $@ $< -pthread -lm

study: $(BUILD)/bench/study ## Measure the work of up to 256 ranks, one after another (about 15 minutes; needs no MPI)
	sh tests/bench/study.sh

$(BUILD)/bench/study_threads: tests/bench/study_threads.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(DEPENDS) -I. -o $@ $< -pthread -lm

study-threads: $(BUILD)/bench/study_threads ## Measure the tasks of up to 64 threads, one after another (about 15 minutes)
	sh tests/bench/study_threads.sh

$(BUILD)/bench/theory: tests/bench/theory.c
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(WARNINGS) $(DEPENDS) -I. -o $@ $< -lm

theory: $(BUILD)/bench/theory ## Compare the size of the Delaunay tree with what the thesis' theorems predict (half a minute)
	$(BUILD)/bench/theory

LIBRARY := $(BUILD)/libparadt.so
# Only the public functions are visible.
lib: $(LIBRARY) ## Build a shared library, for programs in other languages: build/libparadt.so

$(LIBRARY): paradt.h
	@mkdir -p $(@D)
	echo '#include "paradt.h"' | $(CC) $(CFLAGS) $(WARNINGS) -fPIC -fvisibility=hidden -shared -I. -DPARADT_IMPLEMENTATION \
	    '-DPARADT_DEF=extern __attribute__((visibility("default")))' -x c -o $@ - -lm

clean: ## Remove everything that was built
	rm -rf $(BUILD)

help: ## List these targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1|\2/p' Makefile | awk -F'|' '{ printf "%-12s %s\n", $$1, $$2 }'

-include $(wildcard $(BUILD)/*.d $(BUILD)/examples/*.d $(BUILD)/bench/*.d $(T)/*.d $(T)/*/*.d $(BUILD)/coverage/*.d $(BUILD)/coverage/*/*.d)
