// tests/bounds.c without vector code: the scalar twins of the inner functions.
#include <gmp.h>

#define PARADT_NO_SIMD
#define PARADT_IMPLEMENTATION // where tests/bounds.c includes it
#include "bounds.c"
