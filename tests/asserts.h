// The invariants of the library are checked in every test program: the Makefile includes this file before all others
// (-include). One that does not hold ends the program and names its place.
// The sanitized programs also have PARADT_VERIFY: the mesh of a small set is verified after every change.
#ifndef ASSERTS_H
#define ASSERTS_H

#undef NDEBUG
#include <assert.h>

#define PARADT_ASSERT(condition) assert(condition)

#endif
