// The library as a program of its own object file: what the benchmark's programs link, for the hash if for nothing
// else.
#define PARADT_IMPLEMENTATION
#include "paradt.h"
