// The Delaunay tree: every node has its father and stepfather, what is in conflict with a node is in conflict with one of these
// two, and searches find what there is. Points come with paradt_triangulate and one at a time.
#define PARADT_STATIC // functions that are not called are not compiled
#define PARADT_IMPLEMENTATION
#include "harness.h"

enum { LARGEST_DIM = SANITIZED ? 4 : 8 };
static const int points_in[] = {0, 0, 150, 120, 45, 24, 18, 15, 13};
static const int few_points_in[] = {0, 0, 40, 28, 12, 9, 10, 10, 10}; // where determinants have thousands of bits

// A tree of the first points of a set; the others are left for queries, or to be inserted later.
typedef struct grown {
    sample s;
    paradt__memory memory;
    paradt__set set;
    paradt__insertion build;
    paradt__tree tree;
    paradt_index *order, *representative;
    size_t first;
} grown;

static const paradt__progress silent = {NULL, NULL, 0};

// Returns 0 for sets of one place, which have no tree.
static int grow(grown *g, int f, int w, int dim, int count) {
    paradt_points points;
    size_t bad;
    memset(g, 0, sizeof *g);
    g->s = family_make(&families[f], &weightings[w], dim, count, (uint64_t)(1 + f + 100 * w));
    points = points_of(&g->s);
    paradt__memory_begin(&g->memory, NULL);
    g->representative = (paradt_index *)need((size_t)g->s.count, sizeof *g->representative);
    assert_int_equal(paradt__set_load(&g->set, &points, NULL, &paradt__alone, &g->memory, g->representative, &bad), PARADT_OK);
    if (g->set.space.dim < 1)
        return 0;
    g->order = paradt__round_order(g->set.count, &g->memory);
    paradt__insertion_begin(&g->build, &g->set, g->order, &g->memory);
    g->first = g->set.count * 2 / 3;
    if (g->first <= (size_t)g->set.space.dim)
        g->first = (size_t)g->set.space.dim + 1;
    assert_int_equal(paradt__insertion_first(&g->build), PARADT_OK);
    g->build.count = g->first;
    assert_int_equal(paradt__tree_begin(&g->tree, &g->build.scene.mesh, &g->memory), PARADT_OK);
    assert_int_equal(g->tree.roots, g->set.space.dim + 2);
    assert_int_equal(paradt__tree_insert_all(&g->tree, &g->build, &silent), PARADT_OK);
    return 1;
}

static void cut_down(grown *g) {
    if (g->order) {
        paradt__tree_free(&g->tree);
        paradt__insertion_end(&g->build);
        paradt__release(&g->memory, g->order);
    }
    paradt__set_free(&g->set, &g->memory);
    assert_int_equal(g->memory.held, 0);
    free(g->representative);
    sample_free(&g->s);
}

// Calls `run` with trees of all dimensions and, in turn, weightings of a family.
static void for_each_tree(int f, void (*run)(grown *g)) {
    for (int dim = 2; dim <= LARGEST_DIM; dim++)
        for (int turn = 0; turn < 2; turn++) {
            int w = turn ? 1 + (f + dim) % (WEIGHTING_COUNT - 1) : 0;
            int extremes = families[f].extremes || weightings[w].extremes;
            grown g;
            if (extremes && dim > (is_quick() ? 3 : 5))
                continue;
            if (grow(&g, f, w, dim, extremes ? few_points_in[dim] : points_in[dim])) {
                watch(&g.s, 60);
                run(&g);
                watch(NULL, 0);
            }
            cut_down(&g);
        }
}

static paradt__tree_node *node_at(const grown *g, size_t number) {
    assert_in_range(number, 0, g->tree.nodes.count - 1);
    return paradt__tree_at(&g->tree, (paradt_index)number);
}

// Returns the number of vertices that two nodes have in common; the infinite vertex is one.
static int shared(const grown *g, const paradt__tree_node *a, const paradt__tree_node *b) {
    int corners = g->tree.corners, count = 0;
    for (int i = 0; i < corners; i++)
        for (int j = 0; j < corners; j++) {
            paradt_index x = paradt__tree_row(a)[i], y = paradt__tree_row(b)[j];
            count += x == y || (x < 0 && y < 0);
        }
    return count;
}

// Fills the stepfather of each node.
static paradt_index *stepfathers_of(const grown *g) {
    paradt_index *stepfather = (paradt_index *)need(g->tree.nodes.count, sizeof *stepfather);
    for (size_t i = 0; i < g->tree.nodes.count; i++)
        stepfather[i] = PARADT__OPEN;
    for (size_t i = 0; i < g->tree.nodes.count; i++)
        for (paradt_index next = node_at(g, i)->stepson; next >= 0; next = node_at(g, (size_t)next)->stepbrother) {
            assert_true(stepfather[next] == PARADT__OPEN); // in one list only
            stepfather[next] = (paradt_index)i;
        }
    return stepfather;
}

// --- what holds in a tree

static void check_kin(grown *g) {
    const paradt__mesh *mesh = &g->build.scene.mesh;
    size_t corners = (size_t)mesh->corners, sons = 0, live = 0, cells = 0;
    paradt_index *stepfather = stepfathers_of(g);
    for (size_t i = 0; i < g->tree.nodes.count; i++) {
        const paradt__tree_node *node = node_at(g, i);
        int lives = node->place != PARADT__NOWHERE;
        for (paradt_index next = node->son; next >= 0; next = node_at(g, (size_t)next)->brother, sons++)
            if (node_at(g, (size_t)next)->father != (paradt_index)i)
                fail_on_sample(&g->s, "a son has another father");
        if (lives && node->son != PARADT__OPEN)
            fail_on_sample(&g->s, "a cell lives and has sons");
        live += (size_t)lives;
        for (size_t j = 0; lives && j < corners; j++) {
            paradt_index v = mesh->vertices[(size_t)node->place * corners + j], x = paradt__tree_row(node)[j];
            if (v < 0 ? x >= 0 : x != v)
                fail_on_sample(&g->s, "a live node is not as its cell");
        }
        if (lives && g->tree.at[node->place] != (paradt_index)i)
            fail_on_sample(&g->s, "a cell has another node");
        if (i < g->tree.roots) {
            assert_true(node->father == PARADT__OPEN && stepfather[i] == PARADT__OPEN);
            continue;
        }
        assert_in_range(node->father, 0, i - 1);
        assert_in_range(stepfather[i], 0, i - 1);
        if (shared(g, node, node_at(g, (size_t)node->father)) != (int)corners - 1 ||
            shared(g, node, node_at(g, (size_t)stepfather[i])) != (int)corners - 1)
            fail_on_sample(&g->s, "a node shares no facet with its father or stepfather");
        if (node_at(g, (size_t)node->father)->place != PARADT__NOWHERE)
            fail_on_sample(&g->s, "a father lives");
    }
    for (size_t i = 0; i < mesh->count; i++)
        cells += mesh->vertices[i * corners] != PARADT__DEAD;
    assert_int_equal(live, cells);
    assert_int_equal(sons, g->tree.nodes.count - g->tree.roots);
    free(stepfather);
}

// Of each query: a node in conflict has a father or stepfather in conflict; searches from anywhere find a cell in conflict, if
// there is one.
static void check_conflicts(grown *g) {
    const paradt__mesh *mesh = &g->build.scene.mesh;
    size_t corners = (size_t)mesh->corners, last = g->first + 12 < g->set.count ? g->first + 12 : g->set.count;
    paradt_index *stepfather = stepfathers_of(g);
    unsigned char *conflict = (unsigned char *)need(g->tree.nodes.count, 1);
    for (size_t q = g->first; q < last; q++) {
        const double *x = paradt__scene_record(&g->build.scene, g->order[q]);
        size_t found = 0;
        for (size_t i = 0; i < g->tree.nodes.count; i++) {
            const paradt__tree_node *node = node_at(g, i);
            conflict[i] = (unsigned char)paradt__tree_conflicts(&g->build.scene, node, x);
            if (conflict[i] && i >= g->tree.roots && !conflict[node->father] && !conflict[stepfather[i]])
                fail_on_sample(&g->s, "a conflict comes from nowhere");
            if (node->place == PARADT__NOWHERE)
                continue;
            if (conflict[i] != paradt__conflicts(&g->build.scene, node->place, x))
                fail_on_sample(&g->s, "a node says other conflicts than its cell");
            found += conflict[i];
        }
        for (size_t start = 0; start < mesh->count; start += 1 + mesh->count / 7) {
            paradt_index place;
            if (mesh->vertices[start * corners] == PARADT__DEAD)
                continue;
            assert_int_equal(paradt__tree_locate(&g->tree, &g->build.scene, (paradt_index)start, x, &place), PARADT_OK);
            if (place == PARADT__NOWHERE ? found > 0 : !paradt__conflicts(&g->build.scene, place, x))
                fail_on_sample(&g->s, "a search finds no cell in conflict");
        }
    }
    free(conflict);
    free(stepfather);
}

// Points that come one at a time, each from a cell anywhere, make the triangulation of all.
static void check_later_points(grown *g) {
    paradt__insertion *build = &g->build;
    paradt__mesh *mesh = &build->scene.mesh;
    size_t corners = (size_t)mesh->corners, made = g->tree.nodes.count;
    uint64_t hash = 0;
    for (size_t q = g->first; q < g->set.count; q++) {
        paradt_index point = g->order[q], place = (paradt_index)(q % mesh->count);
        while (mesh->vertices[(size_t)place * corners] == PARADT__DEAD)
            place = (place + 1) % (paradt_index)mesh->count;
        assert_int_equal(paradt__tree_locate(&g->tree, &build->scene, place, paradt__scene_record(&build->scene, point), &place),
                         PARADT_OK);
        if (place == PARADT__NOWHERE)
            continue;
        build->count++;
        assert_int_equal(paradt__insert_one_more(build, point, place), PARADT_OK);
        made += build->update.made_count;
        assert_int_equal(paradt__tree_record(&g->tree, build, point), PARADT_OK);
    }
    assert_int_equal(g->tree.nodes.count, made);
    check_kin(g);
    paradt__mesh_close(mesh, g->set.origin, 0, NULL);
    for (size_t i = 0; i < mesh->count; i++) {
        uint64_t vertices[PARADT_MAX_DIM + 1];
        for (size_t j = 0; j < corners; j++)
            vertices[j] = (uint64_t)mesh->vertices[i * corners + j];
        hash += paradt_hash_cell(vertices, mesh->corners);
    }
    for (int method = 0; method < 2; method++) {
        paradt_points points = points_of(&g->s);
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = method ? PARADT_DELAUNAY_TREE : PARADT_BOWYER_WATSON;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        if (paradt_hash(&t) != hash)
            fail_on_sample(&g->s, "points that come one at a time make other cells");
        assert_true(method ? t.stats.history_nodes >= t.cell_count : t.stats.history_nodes == 0);
        paradt_free(&t);
    }
}

// state: family
static void nodes_have_fathers_and_stepfathers(void **state) { for_each_tree((int)(intptr_t)*state, check_kin); }
static void conflicts_descend_from_conflicts(void **state) { for_each_tree((int)(intptr_t)*state, check_conflicts); }
static void points_may_come_one_at_a_time(void **state) { for_each_tree((int)(intptr_t)*state, check_later_points); }

// Searches are numbered. After the largest number they begin again, and no node seems to have been looked at.
static void searches_are_counted_anew(void **state) {
    grown g;
    (void)state;
    assert_true(grow(&g, family_named("uniform"), 0, 3, 400));
    g.tree.searches = (paradt__tag)-1 - 3;
    for (size_t i = 0; i < g.tree.nodes.count; i++)
        node_at(&g, i)->seen = 1 + (paradt__tag)(i % 3);
    check_conflicts(&g);
    assert_in_range(g.tree.searches, 1, 1000);
    cut_down(&g);
}

// In the same order an insertion without the tree makes as many cells.
static void history_nodes_are_the_cells_ever_made(void **state) {
    (void)state;
    for (int dim = 2; dim <= 4; dim++) {
        sample s = family_make(&families[family_named("uniform")], NULL, dim, 500, 1);
        paradt_points points = points_of(&s);
        paradt_options options = {0};
        paradt_triangulation t;
        paradt__memory memory;
        paradt__set set;
        paradt__insertion build;
        paradt_index *order, *representative = (paradt_index *)need(500, sizeof *representative);
        size_t bad, made = (size_t)dim + 2;
        paradt__memory_begin(&memory, NULL);
        assert_int_equal(paradt__set_load(&set, &points, NULL, &paradt__alone, &memory, representative, &bad), PARADT_OK);
        order = paradt__round_order(set.count, &memory);
        paradt__insertion_begin(&build, &set, order, &memory);
        assert_int_equal(paradt__insertion_first(&build), PARADT_OK);
        while (build.inserted < build.count) {
            const double *x = paradt__scene_record(&build.scene, paradt__insertion_point(&build, build.inserted));
            assert_int_equal(paradt__insert_next(&build, paradt__walk(&build.scene, paradt__insertion_start(&build), x)), PARADT_OK);
            made += build.update.made_count;
        }
        options.method = PARADT_DELAUNAY_TREE;
        assert_int_equal(paradt_triangulate(&t, &points, &options), PARADT_OK);
        assert_int_equal(t.stats.history_nodes, made);
        paradt_free(&t);
        paradt__insertion_end(&build);
        paradt__release(&memory, order);
        paradt__set_free(&set, &memory);
        free(representative);
        sample_free(&s);
    }
}

// --- errors

typedef struct books {
    size_t calls, fail_at, live;
} books;

static void *allocate(void *user, size_t bytes) {
    books *b = (books *)user;
    if (++b->calls == b->fail_at)
        return NULL;
    b->live++;
    return malloc(bytes);
}

static void give_back(void *user, void *block) {
    ((books *)user)->live -= block != NULL;
    free(block);
}

// So many points have nodes in several blocks. A block that is refused is an error and leaves nothing behind.
static void every_refused_block_is_an_error(void **state) {
    sample s = family_make(&families[family_named("uniform")], NULL, 3, SANITIZED ? 300 : 900, 1);
    paradt_points points = points_of(&s);
    paradt_status status = PARADT_ERROR_MEMORY;
    (void)state;
    for (size_t k = 1; status; k++) {
        books b = {0, k, 0};
        paradt_options options = {0};
        paradt_triangulation t;
        options.method = PARADT_DELAUNAY_TREE;
        options.allocator.alloc = allocate;
        options.allocator.free = give_back;
        options.allocator.user = &b;
        status = paradt_triangulate(&t, &points, &options);
        assert_true(status == (b.calls >= k ? PARADT_ERROR_MEMORY : PARADT_OK));
        if (!status)
            assert_in_range(t.stats.history_nodes, PARADT__NODES_BLOCK + 1, 40 * s.count);
        paradt_free(&t);
        assert_int_equal(b.live, 0);
    }
    sample_free(&s);
}

static void more_nodes_than_indices_are_too_large(void **state) {
    grown g;
    size_t capacity, count;
    (void)state;
    assert_true(grow(&g, family_named("uniform"), 0, 3, 50));
    capacity = g.tree.nodes.capacity;
    count = g.tree.nodes.count;
    g.tree.nodes.count = g.tree.nodes.capacity = (size_t)PARADT__NOWHERE / PARADT__NODES_BLOCK * PARADT__NODES_BLOCK;
    assert_int_equal(paradt__tree_room(&g.tree, &g.build.scene.mesh, 1), PARADT_ERROR_TOO_LARGE);
    g.tree.nodes.capacity = capacity;
    g.tree.nodes.count = count;
    cut_down(&g);
}

int main(void) {
    static struct CMUnitTest tests[3 * FAMILY_COUNT + 4];
    size_t count = 0;
    tests[count++] = named_test(searches_are_counted_anew, NULL, "searches_are_counted_anew");
    tests[count++] = named_test(history_nodes_are_the_cells_ever_made, NULL, "history_nodes_are_the_cells_ever_made");
    tests[count++] = named_test(every_refused_block_is_an_error, NULL, "every_refused_block_is_an_error");
    tests[count++] = named_test(more_nodes_than_indices_are_too_large, NULL, "more_nodes_than_indices_are_too_large");
    for (int f = 0; f < FAMILY_COUNT; f++) {
        void *row = (void *)(intptr_t)f;
        const char *name = families[f].name;
        tests[count++] = named_test(nodes_have_fathers_and_stepfathers, row, "nodes_have_fathers_and_stepfathers_on_%s", name);
        tests[count++] = named_test(conflicts_descend_from_conflicts, row, "conflicts_descend_from_conflicts_on_%s", name);
        tests[count++] = named_test(points_may_come_one_at_a_time, row, "points_may_come_one_at_a_time_on_%s", name);
    }
    return run_named_tests("delaunay_tree", tests, count);
}
