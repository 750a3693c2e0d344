# Builds the programs of the benchmark: make -f tests/bench/bench.mk -k programs PEERS="cgal tetgen ...", as run.sh does.

B     := build/bench
CC    ?= cc
CXX   ?= c++
PEERS ?= cgal cgal-regular cgal-dd cgal-tbb tetgen qhull qhull-hull hxt
# Flags of the library in paradt-use, such as -DPARADT_NO_VORONOI
USE_FLAGS ?=
# Some compilers don't know -march=native.
NATIVE := $(shell echo 'int one;' | $(CC) -march=native -x c -c -o /dev/null - 2>/dev/null && echo yes)

WARNINGS  := -Wall -Wextra -Wshadow
FLAGS     := -O3 $(WARNINGS) -I. -Itests/bench
# CGAL's interval arithmetic needs -frounding-math; NDEBUG removes its assertions.
CGALFLAGS := -std=c++17 $(FLAGS) -DNDEBUG -frounding-math
DEPENDS    = -MMD -MP -MT $@ -MF $@.d
SOURCES    = $(filter %.c %.cpp %.o,$^)

.PHONY: programs
.DELETE_ON_ERROR:

programs: $(addprefix $(B)/,points paradt $(if $(NATIVE),paradt-native) predicates $(PEERS))

$(B)/library.o: tests/bench/library.c paradt.h
	@mkdir -p $(@D)
	$(CC) $(FLAGS) $(DEPENDS) -c -o $@ $<

$(B)/library-native.o: tests/bench/library.c paradt.h
	@mkdir -p $(@D)
	$(CC) $(FLAGS) -march=native $(DEPENDS) -c -o $@ $<

$(B)/points: tests/bench/points.c $(B)/library.o
	@mkdir -p $(@D)
	$(CC) $(FLAGS) $(DEPENDS) -o $@ $(SOURCES) -lm

$(B)/predicates: tests/bench/predicates_bench.c paradt.h
	@mkdir -p $(@D)
	$(CC) $(FLAGS) $(DEPENDS) -o $@ $< -lm

$(B)/paradt: tests/bench/paradt_driver.c $(B)/library.o
	$(CC) $(FLAGS) $(DEPENDS) -o $@ $(SOURCES) -pthread -lm

$(B)/paradt-native: tests/bench/paradt_driver.c $(B)/library-native.o
	$(CC) $(FLAGS) -march=native $(DEPENDS) -o $@ $(SOURCES) -pthread -lm

$(B)/cgal: tests/bench/cgal3.cpp $(B)/library.o
	$(CXX) $(CGALFLAGS) $(DEPENDS) -o $@ $(SOURCES) -lmpfr -lgmp -lm

$(B)/cgal-tbb: tests/bench/cgal3.cpp $(B)/library.o
	$(CXX) $(CGALFLAGS) -DCGAL_LINKED_WITH_TBB $(DEPENDS) -o $@ $(SOURCES) -ltbb -ltbbmalloc -lmpfr -lgmp -lm

$(B)/cgal-regular: tests/bench/cgal_regular.cpp $(B)/library.o
	$(CXX) $(CGALFLAGS) $(DEPENDS) -o $@ $(SOURCES) -lmpfr -lgmp -lm

$(B)/cgal-dd: tests/bench/cgal_dd.cpp $(B)/library.o
	$(CXX) $(CGALFLAGS) -isystem /usr/include/eigen3 $(DEPENDS) -o $@ $(SOURCES) -lmpfr -lgmp -lm

$(B)/tetgen: tests/bench/tetgen.cpp $(B)/library.o
	$(CXX) $(FLAGS) -DTETLIBRARY $(DEPENDS) -o $@ $(SOURCES) -ltet -lm

$(B)/qhull: tests/bench/qhull.c $(B)/library.o
	$(CC) $(FLAGS) $(DEPENDS) -o $@ $(SOURCES) -lqhull_r -lm

$(B)/qhull-hull: tests/bench/qhull.c $(B)/library.o
	$(CC) $(FLAGS) -DQHULL_HULLS $(DEPENDS) -o $@ $(SOURCES) -lqhull_r -lm

$(B)/hxt: tests/bench/hxt.c $(B)/library.o
	$(CC) $(FLAGS) -fopenmp $(DEPENDS) -o $@ $(SOURCES) -lgmsh -lm

# The programs of use.sh
$(B)/library-use.o: tests/bench/library.c paradt.h $(B)/use-flags
	$(CC) $(FLAGS) $(USE_FLAGS) $(DEPENDS) -c -o $@ $<

$(B)/paradt-use: tests/bench/paradt_use.c $(B)/library-use.o
	$(CC) $(FLAGS) $(USE_FLAGS) $(DEPENDS) -o $@ $(SOURCES) -lm

$(B)/use-flags: FORCE
	@mkdir -p $(@D)
	@echo "$(USE_FLAGS)" | cmp -s - $@ || echo "$(USE_FLAGS)" >$@

FORCE:

# Of paradt.h the peers' programs have the hash and sizes alone, so they are not compiled anew with every change of it.
$(B)/cgal_use.o: tests/bench/cgal_use.cpp tests/bench/use.h tests/bench/bench.h
	@mkdir -p $(@D)
	$(CXX) $(CGALFLAGS) -isystem /usr/include/eigen3 -c -o $@ $<

$(B)/cgal-use: $(B)/cgal_use.o $(B)/library.o
	$(CXX) -o $@ $^ -lmpfr -lgmp -lm

$(B)/voro_use.o: tests/bench/voro_use.cpp tests/bench/use.h tests/bench/bench.h
	@mkdir -p $(@D)
	$(CXX) $(FLAGS) -c -o $@ $<

$(B)/voro-use: $(B)/voro_use.o $(B)/library.o
	$(CXX) -o $@ $^ -lvoro++ -lm

-include $(wildcard $(B)/*.d)
