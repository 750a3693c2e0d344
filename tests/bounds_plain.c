// tests/bounds.c without vector code: the scalar twins of the inner functions.
#define PARADT_NO_SIMD
#include "bounds.c"
