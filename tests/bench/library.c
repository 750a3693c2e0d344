// The library in an object file of its own. The programs of the benchmark link it; those of peers use its hash only.
#define PARADT_IMPLEMENTATION
#include "paradt.h"
