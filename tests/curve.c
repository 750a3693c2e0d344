// Reading the points: Hilbert's curve, sorting along it, equal points, what is measured meanwhile, and the rounds of
// insertion.
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#include "harness.h"

#include <float.h>

enum { LATTICE_POINTS = 4096, SCALES = 3000, BOXED = 3000, SPREAD = 200000 };

// Makes point i of a lattice of 2^levels points along each axis.
static void lattice_point(int i, int dim, int levels, double *x) {
    for (int j = 0; j < dim; j++, i >>= levels) x[j] = i & ((1 << levels) - 1);
}

// Computes the keys of all points of a lattice of 2^levels points along each axis. order[key] becomes the point with
// this key. Returns the number of points, or -1 if the keys are not the numbers below it.
static int keys_of_cube(const paradt__hilbert *hilbert, int dim, int levels, int *order) {
    int64_t low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
    int count = 1 << (dim * levels);
    paradt__lattice lattice;
    for (int j = 0; j < dim; j++) {
        low[j] = paradt__ordered_bits(0.0);
        high[j] = paradt__ordered_bits((double)((1 << levels) - 1));
    }
    paradt__lattice_begin(&lattice, dim, levels, 0, low, high);
    for (int i = 0; i < count; i++) order[i] = -1;
    for (int i = 0; i < count; i++) {
        double x[PARADT_MAX_DIM];
        lattice_point(i, dim, levels, x);
        uint64_t key = paradt__hilbert_key(hilbert, &lattice, x);
        if (key >= (uint64_t)count || order[key] >= 0) return -1;
        order[key] = i;
    }
    return count;
}

static void the_curve_goes_from_neighbour_to_neighbour(void **state) {
    static int order[LATTICE_POINTS];
    (void)state;
    for (int dim = 2; dim <= 6; dim++)
        for (int many = 0; many < 2; many++) {
            int levels = dim == 2 ? 6 : dim == 3 ? 4 : 2;
            paradt__hilbert hilbert;
            paradt__hilbert_begin(&hilbert, dim, many ? 1000000 : 10);
            int count = keys_of_cube(&hilbert, dim, levels, order);
            assert_true(count > 0); // the keys are a permutation
            for (int i = 1; i < count; i++) {
                double a[PARADT_MAX_DIM], b[PARADT_MAX_DIM], distance = 0;
                lattice_point(order[i - 1], dim, levels, a);
                lattice_point(order[i], dim, levels, b);
                for (int j = 0; j < dim; j++) distance += fabs(a[j] - b[j]);
                assert_true(distance == 1);
            }
        }
}

static void the_corners_of_any_box_get_different_places(void **state) {
    static const double boxes[][2] = {{0, 1},
                                      {-1, 1},
                                      {1, 1 + DBL_EPSILON},
                                      {-DBL_MAX, DBL_MAX},
                                      {0, 0x1p-1074},
                                      {-0x1p-1074, 0x1p-1074},
                                      {DBL_MAX, DBL_MAX * (1 - DBL_EPSILON / 2)},
                                      {1e-300, 1e300},
                                      {1 - DBL_EPSILON / 2, 1},
                                      {DBL_MIN - 0x1p-1074, DBL_MIN}};
    (void)state;
    for (size_t b = 0; b < sizeof boxes / sizeof *boxes; b++)
        for (int levels = 1, by_steps = 0; levels <= 20; levels += by_steps, by_steps = !by_steps) {
            double low_corner[3] = {7e20, fmin(boxes[b][0], boxes[b][1]), 0};
            double high_corner[3] = {7e20, fmax(boxes[b][0], boxes[b][1]), 0x1p-1074};
            int64_t low[3], high[3];
            paradt__hilbert hilbert;
            paradt__lattice lattice;
            for (int j = 0; j < 3; j++) {
                low[j] = paradt__ordered_bits(low_corner[j]);
                high[j] = paradt__ordered_bits(high_corner[j]);
            }
            paradt__hilbert_begin(&hilbert, 3, 10);
            paradt__lattice_begin(&lattice, 3, levels, by_steps, low, high);
            assert_true(paradt__hilbert_key(&hilbert, &lattice, low_corner) !=
                        paradt__hilbert_key(&hilbert, &lattice, high_corner));
        }
}

static void sorting_keeps_the_order_of_equal_keys(void **state) {
    static const size_t counts[] = {0, 1, 2, 31, 32, 33, 500, 70000};
    static const int bits[] = {1, 8, 9, 17, 60, 64};
    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        for (size_t b = 0; b < sizeof bits / sizeof *bits; b++)
            for (int across = 0; across < 2; across++) {
                size_t count = counts[c];
                paradt__keyed *keyed = (paradt__keyed *)need(count + 1, sizeof *keyed);
                paradt__keyed *other = (paradt__keyed *)need(count + 1, sizeof *other);
                for (size_t i = 0; i < count; i++) { // few different keys, up to the highest bit
                    keyed[i].key = paradt__mix(i) % 97 * 0x9e3779b97f4a7c15u >> (64 - bits[b]);
                    keyed[i].item = (paradt_index)i;
                }
                paradt__keyed_sort(keyed, other, count, bits[b], across);
                const paradt__keyed *sorted = across ? other : keyed;
                for (size_t i = 1; i < count; i++)
                    assert_true(sorted[i - 1].key < sorted[i].key ||
                                (sorted[i - 1].key == sorted[i].key && sorted[i - 1].item < sorted[i].item));
                free(keyed);
                free(other);
            }
}

static void tasks_in_turn(void *user, size_t count, void (*task)(void *context, size_t index), void *context) {
    (void)user;
    for (size_t i = count; i-- > 0;) task(context, i); // backwards: nothing may depend on the order of the tasks
}

// Makes SCALES points in random order, about three at each of the places whose distances from 0 are powers of two.
static void fill_scales(double *x, int dim) {
    for (size_t i = 0; i < SCALES; i++) {
        size_t place = paradt__mix(i) % (SCALES / 3);
        for (int j = 0; j < dim; j++)
            x[i * (size_t)dim + (size_t)j] = ldexp(j % 2 ? 1.25 : 1.0, 900 - (int)place * (j + 2));
    }
}

// The distances are far too small for the first lattice, so runs of equal keys get lattices of their own. The number of
// tasks, and that of the levels, which crowded points increase, have no influence.
static void equal_points_are_found_on_all_scales(void **state) {
    static double x[SCALES * PARADT_MAX_DIM];
    static paradt_index representative[SCALES];
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (size_t tasks = 1; tasks <= PARADT__MOST_TASKS; tasks++) {
            paradt_points points = {0};
            paradt__team team = {tasks_in_turn, NULL, tasks, {NULL, NULL, 0.0}};
            paradt__memory memory;
            paradt__set set;
            size_t bad = 0, distinct = 0, count = tasks % 2 ? SCALES : PARADT__MANY_KEYS - 1;
            fill_scales(x, dim);
            points.data = x;
            points.count = count;
            points.dim = dim;
            paradt__memory_begin(&memory, NULL);
            assert_int_equal(paradt__set_load(&set, &points, NULL, &team, &memory, representative, &bad), PARADT_OK);
            for (size_t i = 0; i < count; i++) {
                size_t first = 0, bytes = (size_t)dim * sizeof *x;
                while (memcmp(x + first * (size_t)dim, x + i * (size_t)dim, bytes)) first++;
                assert_int_equal(representative[i], first);
                distinct += first == i;
            }
            assert_int_equal(set.count, distinct);
            for (size_t i = 0; i < set.count; i++) assert_int_equal(representative[set.origin[i]], set.origin[i]);
            paradt__set_free(&set, &memory);
            assert_int_equal(memory.held, 0);
        }
}

// A hash of a record's bytes, or a comparison of them, takes zeros of one sign.
static void records_have_no_negative_zero(void **state) {
    const double wide[] = {-0.0, 1, -0.0}, weight = -0.0;
    const float narrow[] = {-0.0f, 1, -0.0f}, light = -0.0f;
    (void)state;
    for (int floats = 0; floats < 2; floats++) {
        paradt_points points = {0};
        paradt__source source;
        double record[4];
        points.data = floats ? (const void *)narrow : (const void *)wide;
        points.scalar = points.weight_scalar = floats ? PARADT_F32 : PARADT_F64;
        points.weights = floats ? (const void *)&light : (const void *)&weight;
        points.count = 1;
        points.dim = 3;
        source = paradt__source_of(&points);
        paradt__read_record(&source, 0, record);
        for (int i = 0; i < 4; i++) assert_true(paradt__bits(record[i]) == (i == 1 ? paradt__bits(1.0) : 0));
    }
}

// Three points of which two differ along one axis alone, by one unit in the last place, and have the same first key.
static void points_that_differ_along_one_axis_are_two(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int axis = 0; axis < dim; axis++) {
            double x[3 * 4];
            paradt_index representative[3];
            paradt_points points = paradt_points_f64(x, 3, dim);
            paradt__memory memory;
            paradt__set set;
            size_t bad = 0;
            for (int j = 0; j < dim; j++) x[j] = 0, x[dim + j] = x[2 * dim + j] = 1;
            x[2 * dim + axis] = 1 + DBL_EPSILON;
            paradt__memory_begin(&memory, NULL);
            assert_int_equal(paradt__set_load(&set, &points, NULL, &paradt__alone, &memory, representative, &bad), PARADT_OK);
            assert_int_equal(set.count, 3);
            for (int i = 0; i < 3; i++) assert_int_equal(representative[i], i);
            paradt__set_free(&set, &memory);
        }
}

// A cut between two points loses bits when the set is scaled, as the points do not. They stay on its two sides.
static void cuts_that_lose_bits_stay_between_their_points(void **state) {
    (void)state;
    for (int negative = 0; negative < 2; negative++) {
        const double unit = 0x1p-1034; // scaled by 2^-40 it is the least number
        double below = negative ? -6 * unit : 5 * unit, above = negative ? -5 * unit : 6 * unit;
        paradt__cut cut[2];
        paradt__cuts cuts = {0};
        paradt__set set = {0};
        int exact = 1;
        memset(cut, 0, sizeof cut);
        cuts.boxes = 2;
        cuts.cut = cut;
        cut[1].at = below + 0.25 * unit;
        set.exponent = 1023 + 40;
        assert_true(paradt__cut_is_above(cut + 1, &below) && !paradt__cut_is_above(cut + 1, &above));
        paradt__cuts_follow(&cuts, &set, 1);
        below = paradt__scale(below, -40, &exact);
        above = paradt__scale(above, -40, &exact);
        assert_true(exact);
        assert_true(paradt__cut_is_above(cut + 1, &below) && !paradt__cut_is_above(cut + 1, &above));
    }
}

enum { EVERYWHERE, ON_A_LATTICE, IN_CLUMPS, NEAR_A_PLANE };

static void fill_spread(double *x, int kind) {
    for (size_t i = 0; i < SPREAD; i++) {
        uint64_t number = paradt__mix(i), clump = paradt__mix(i % 50);
        for (int j = 0; j < 3; j++, number = paradt__mix(number), clump = paradt__mix(clump)) {
            double *at = x + 3 * i + j;
            *at = (double)(number >> 11) * 0x1p-53;
            if (kind == ON_A_LATTICE) *at = (double)(number >> 58);
            if (kind == IN_CLUMPS) *at = (double)(clump >> 11) * 0x1p-53 + *at * 0x1p-9;
            if (kind == NEAR_A_PLANE && j == 2) *at *= 0x1p-20;
        }
    }
}

static int is_crowded(const double *x, size_t count) {
    static paradt_index representative[SPREAD];
    static paradt__loader loader;
    paradt_points points = paradt_points_f64(x, count, 3);
    paradt__source source = paradt__source_of(&points);
    paradt__memory memory;
    paradt__set set;
    size_t bad = 0;
    int crowded;
    memset(&set, 0, sizeof set);
    paradt__memory_begin(&memory, NULL);
    paradt__loader_begin(&loader, &set, &source, NULL, &paradt__alone, &memory, representative);
    assert_int_equal(paradt__loader_allocate(&loader), PARADT_OK);
    assert_int_equal(paradt__loader_survey(&loader, &bad), PARADT_OK);
    paradt__hilbert_begin(&loader.hilbert, 3, count);
    crowded = paradt__loader_crowded(&loader, paradt__levels_for(count, 3));
    paradt__loader_free(&loader);
    paradt__set_free(&set, &memory);
    assert_int_equal(memory.held, 0);
    return crowded;
}

// Near a plane a few points get levels enough to tell most of them apart; many points do not.
static void a_sample_tells_whether_points_are_crowded(void **state) {
    static const struct {
        int kind, few, many;
    } rows[] = {{EVERYWHERE, 0, 0}, {ON_A_LATTICE, 0, 0}, {IN_CLUMPS, 1, 1}, {NEAR_A_PLANE, 0, 1}};
    static double x[SPREAD * 3];
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        fill_spread(x, rows[i].kind);
        assert_int_equal(is_crowded(x, PARADT__MANY_KEYS), rows[i].few);
        assert_int_equal(is_crowded(x, SPREAD), rows[i].many);
    }
}

// Makes points by kind. 0: anywhere in a cube; 1: on a small lattice; 2: of large coordinates; 3: the second axis is
// the longest, and a multiple of the first.
static void fill_boxes(double *x, size_t count, int dim, int kind) {
    for (size_t i = 0; i < count; i++) {
        double *p = x + i * (size_t)dim;
        uint64_t number = paradt__mix(i);
        for (int j = 0; j < dim; j++, number = paradt__mix(number)) {
            p[j] = (double)(number >> 11) * 0x1p-53;
            if (kind == 1) p[j] = (double)(number % 9) - 4.0;
            if (kind == 2) p[j] = ldexp(p[j], 60);
            if (kind == 3 && j == 1) p[j] = 2.0 * p[0];
        }
    }
}

// Each box has the points within its bounds, and behind them, where the boxes are apart, copies of its last point.
// even: each has an equal share of the points.
static void expect_boxes(const paradt__set *set, const paradt__cuts *cuts, int even) {
    size_t begin = 0, total = 0, share = set->count / cuts->boxes, bytes = set->width * sizeof(double);
    for (size_t box = 0; box < cuts->boxes; box++) {
        size_t end = begin + (cuts->boxes > 1 ? cuts->cut[box].count : set->count);
        double low[PARADT_MAX_DIM], high[PARADT_MAX_DIM];
        for (int j = 0; j < set->space.ambient; j++) {
            low[j] = -INFINITY;
            high[j] = INFINITY;
        }
        paradt__cuts_box(cuts, box, low, high);
        if (cuts->boxes > 1) assert_int_equal(cuts->cut[box].begin, begin);
        assert_true(end <= set->capacity);
        if (even) assert_true(end - begin + 4 > share && end - begin < share + 4);
        for (size_t i = begin; i < end; i++) {
            const double *p = paradt__record(set, (paradt_index)i);
            assert_int_equal(paradt__cuts_find(cuts, p), box);
            for (int j = 0; j < set->space.ambient; j++) assert_true(p[j] >= low[j] && p[j] <= high[j]);
        }
        total += end - begin;
        begin = end;
        if (cuts->positions) end = box + 1 < cuts->boxes ? cuts->cut[box + 1].begin : cuts->positions;
        for (; begin < end; begin++) {
            const double *p = paradt__record(set, (paradt_index)begin);
            assert_memory_equal(p, p - set->width, bytes);
        }
    }
    assert_int_equal(total, set->count);
    assert_int_equal(begin, cuts->positions ? cuts->positions : set->count);
}

// Building a grid sorts the set in another way; the points are then moved back to their boxes.
static void expect_dealt(paradt__set *set, const paradt__cuts *cuts, paradt__memory *memory) {
    paradt__grid grid;
    if (set->space.dim < 2 || cuts->boxes < 2 || cuts->positions) return;
    memset(&grid, 0, sizeof grid);
    assert_int_equal(paradt__grid_build(&grid, set, NULL, memory), PARADT_OK);
    paradt__grid_free(&grid, memory);
    paradt__regions_deal(set, cuts, 0, set->count, 0, cuts->boxes);
    expect_boxes(set, cuts, 0);
}

// A set that is sorted by boxes has the same representatives.
static void boxes_follow_each_other(void **state) {
    static double x[BOXED * PARADT_MAX_DIM];
    static paradt_index representative[BOXED], expected[BOXED];
    (void)state;
    for (int dim = 2; dim <= 4; dim++)
        for (int kind = 0; kind < 4; kind++)
            for (size_t boxes = 1, apart = 0; boxes <= 700; boxes += !apart ? 0 : boxes < 9 ? 1 : 230, apart = !apart) {
                paradt_points points = {0};
                paradt__team team = {tasks_in_turn, NULL, boxes % 2 && apart ? boxes : 2, {NULL, NULL, 0.0}};
                paradt__cuts cuts = {0};
                paradt__memory memory;
                paradt__set set;
                size_t bad = 0;
                fill_boxes(x, BOXED, dim, kind);
                points.data = x;
                points.count = BOXED;
                points.dim = dim;
                cuts.boxes = boxes;
                cuts.gaps = cuts.apart = (int)apart;
                paradt__memory_begin(&memory, NULL);
                assert_int_equal(paradt__set_load(&set, &points, NULL, &paradt__alone, &memory, expected, &bad),
                                 PARADT_OK);
                paradt__set_free(&set, &memory);
                assert_int_equal(paradt__set_load(&set, &points, &cuts, &team, &memory, representative, &bad),
                                 PARADT_OK);
                assert_memory_equal(representative, expected, sizeof expected);
                expect_boxes(&set, &cuts, kind % 2 == 0); // kinds 1 and 3 have many points at one place or on one cut
                expect_dealt(&set, &cuts, &memory);
                paradt__set_free(&set, &memory);
                paradt__release(&memory, cuts.cut);
                assert_int_equal(memory.held, 0);
            }
}

// Widens a range by a number, whose exponent and bits are found by frexp.
static void widen(paradt__range *range, double x) {
    int exponent, bits = 53;
    int64_t digits = (int64_t)ldexp(frexp(fabs(x), &exponent), bits);
    if (x == 0) return;
    for (; digits % 2 == 0; digits /= 2) bits--;
    range->unit = exponent - bits < range->unit ? exponent - bits : range->unit;
    range->bottom = exponent - 1 < range->bottom ? exponent - 1 : range->bottom;
    range->top = exponent > range->top ? exponent : range->top;
}

static void expect_range(const paradt__range *range, const paradt__range *expected) {
    assert_int_equal(range->unit, expected->unit);
    assert_int_equal(range->bottom, expected->bottom);
    assert_int_equal(range->top, expected->top);
}

// Compares the measures of a set that has just been gathered with those of its sample.
static void expect_measured(const paradt__set *set, const sample *s) {
    paradt__range coordinates = paradt__no_range, weights = paradt__no_range;
    int biased = 0;
    for (int j = 0; j < s->dim; j++) {
        double low = INFINITY, high = -INFINITY;
        for (int i = 0; i < s->count; i++) {
            double x = s->x[i * s->dim + j];
            low = x < low ? x : low;
            high = x > high ? x : high;
            widen(&coordinates, x);
            if (fabs(x) >= DBL_MIN && ilogb(x) + 1023 > biased) biased = ilogb(x) + 1023;
        }
        assert_true(paradt__from_ordered_bits(set->space.low[j]) == low);
        assert_true(paradt__from_ordered_bits(set->space.high[j]) == high);
    }
    for (int i = 0; i < s->count && s->w; i++) widen(&weights, s->w[i]);
    expect_range(&set->space.coordinates, &coordinates);
    expect_range(&set->space.weights, &weights);
    assert_int_equal(set->exponent, biased);
}

static void points_are_measured_while_they_are_read(void **state) {
    (void)state;
    for (int f = 0; f < FAMILY_COUNT; f++)
        for (int w = 0; w < WEIGHTING_COUNT; w++) {
            sample s = family_make(&families[f], &weightings[w], 2 + (f + w) % 4, 60, 5);
            paradt_points points = points_of(&s);
            paradt__source source = paradt__source_of(&points);
            paradt__team team = {tasks_in_turn, NULL, 1 + (size_t)w % 3, {NULL, NULL, 0.0}};
            paradt__memory memory;
            paradt__set set = {0};
            paradt_index *representative = (paradt_index *)need((size_t)s.count, sizeof *representative);
            size_t bad = 0;
            paradt__memory_begin(&memory, NULL);
            assert_int_equal(paradt__set_gather(&set, &source, NULL, &team, &memory, representative, &bad), PARADT_OK);
            expect_measured(&set, &s);
            paradt__set_free(&set, &memory);
            free(representative);
            sample_free(&s);
        }
}

static void rounds_take_every_point_once_and_one_of_sixteen_earlier(void **state) {
    static const size_t counts[] = {0, 1, 15, 16, 255, 256, 257, 5000, 100000};
    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        size_t count = counts[c], early = 0;
        int rounds = paradt__round_count(count);
        paradt__memory memory;
        paradt__memory_begin(&memory, NULL);
        paradt_index *order = paradt__round_order(count, &memory);
        unsigned char *seen = (unsigned char *)need(count + 1, 1);
        assert_non_null(order);
        memset(seen, 0, count + 1);
        for (size_t i = 0; rounds && i < count; i += 16) early += paradt__earlier_one(i / 16, 0) < count;
        for (size_t i = 0; i < count; i++) {
            assert_false(seen[order[i]]);
            seen[order[i]] = 1;
            if (i < early) assert_int_equal(order[i], paradt__earlier_one((size_t)order[i] / 16, 0));
            if (i > early) assert_true(order[i - 1] < order[i]); // the last round follows the curve
        }
        if (rounds) assert_true(early >= count / 16 && early <= count / 16 + 1);
        else assert_int_equal(early, 0);
        free(seen);
        paradt__release(&memory, order);
    }
}

enum { OWN = 4000, TWINS = 200, OUTSIDE = 100, OTHERS = TWINS + OUTSIDE, NEAR = 16 };

// The set's first `own` points, in a box, are along the curve. Merges other points with them: TWINS of the others are
// at the places of own points, the rest anywhere. At most NEAR own points may stand between a point and its twin.
static void merge_and_compare(paradt__set *set, size_t own, const int64_t *low, const int64_t *high) {
    static paradt__keyed sorted[OTHERS], other[OTHERS];
    static paradt_index merged[OWN + OTHERS];
    static size_t place[OWN + OTHERS];
    size_t all = set->count = own + OTHERS;
    paradt__curve curve;
    paradt__rounds one; // only one round
    memset(&one, 0, sizeof one);
    paradt__curve_begin(&curve, 3, paradt__levels_for(OWN, 3), set->space.low, set->space.high, all);
    paradt__curve_limit(&curve, low, high);
    one.order = merged;
    for (size_t i = 0; i < TWINS; i++)
        memcpy(set->records + 3 * (own + i), set->records + 3 * (own / TWINS * i), 3 * sizeof(double));
    for (size_t i = 3 * (own + TWINS); i < 3 * all; i++) set->records[i] = (double)(paradt__mix(i) >> 11) * 0x1p-50 - 4;
    paradt__merge_others(set, own, &curve, sorted, other, &one);
    assert_int_equal(one.next, all);
    for (size_t i = 0; i < all; i++) place[i] = all;
    for (size_t i = 0; i < all; i++) {
        assert_in_range(merged[i], 0, all - 1);
        assert_int_equal(place[merged[i]], all);
        place[merged[i]] = i;
    }
    for (size_t i = 1; i < own; i++) assert_true(place[i - 1] < place[i]);
    for (size_t i = 0; i < TWINS; i++) {
        size_t a = place[own / TWINS * i], b = place[own + i], between = 0;
        for (size_t k = a < b ? a : b; k < (a < b ? b : a); k++) between += (size_t)merged[k] < own;
        assert_true(between <= NEAR);
    }
}

static void others_come_where_the_curve_passes_them(void **state) {
    static double x[(OWN + OTHERS) * 3];
    static paradt_index representative[OWN];
    paradt_points points = paradt_points_f64(x, OWN, 3);
    paradt__memory memory;
    paradt__set set;
    int64_t low[3];
    size_t bad, own = 0;
    (void)state;
    memset(&set, 0, sizeof set);
    paradt__memory_begin(&memory, NULL);
    for (size_t i = 0; i < OWN * 3; i++) x[i] = (double)(paradt__mix(i + 7) >> 11) * 0x1p-53;
    assert_int_equal(paradt__set_load(&set, &points, NULL, &paradt__alone, &memory, representative, &bad), PARADT_OK);
    memcpy(x, set.records, OWN * 3 * sizeof *x);
    paradt__set_free(&set, &memory);
    set.records = x;
    merge_and_compare(&set, OWN, set.space.low, set.space.high);
    for (size_t i = 0; i < OWN; i++) { // the points of a region, along the curve of all points
        if (x[3 * i] > 0.37 && x[3 * i + 1] > 0.21) memmove(x + 3 * own++, x + 3 * i, 3 * sizeof *x);
    }
    memcpy(low, set.space.low, sizeof low);
    low[0] = paradt__ordered_bits(0.37);
    low[1] = paradt__ordered_bits(0.21);
    merge_and_compare(&set, own, low, set.space.high);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_curve_goes_from_neighbour_to_neighbour),
        cmocka_unit_test(the_corners_of_any_box_get_different_places),
        cmocka_unit_test(sorting_keeps_the_order_of_equal_keys),
        cmocka_unit_test(equal_points_are_found_on_all_scales),
        cmocka_unit_test(records_have_no_negative_zero),
        cmocka_unit_test(points_that_differ_along_one_axis_are_two),
        cmocka_unit_test(cuts_that_lose_bits_stay_between_their_points),
        cmocka_unit_test(a_sample_tells_whether_points_are_crowded),
        cmocka_unit_test(boxes_follow_each_other),
        cmocka_unit_test(points_are_measured_while_they_are_read),
        cmocka_unit_test(rounds_take_every_point_once_and_one_of_sixteen_earlier),
        cmocka_unit_test(others_come_where_the_curve_passes_them),
    };
    return cmocka_run_group_tests_name("curve", tests, NULL, NULL);
}
