// Any bytes are read as a file, by the readers of the tool (examples/paradt_read.h), of the format that the first byte chooses:
// one of those that are listed, or the one that the content suggests. Then
//     - points that are read have to be finite, of a dimension that is, and as many as are said to be
//     - what is refused has to have a reason, and no points
//     - the same bytes read twice have to give the same points; read by their content, they may give others, or none
// The readers have to give back all memory, which a replay with the address sanitizer sees.
//
// The first two bytes are a header:
//     0  number of the format in paradt_io_inputs, or by content
//     1  bits 0-3: the dimension wanted, 0: any; bit 4: weights; bit 5: radii; bits 6-7: columns
// The file follows.
#include "fuzz.h"

#define PARADT_READ_IMPLEMENTATION
#include "../examples/paradt_read.h"

// Memory that a file asks for and that is not there is refused like any other.
const char *__asan_default_options(void);
const char *__asan_default_options(void) {
    return "allocator_may_return_null=1";
}

// Writes the extension that a number chooses, without its dot, and returns 1; 0: by content.
static int choose_format(int number, char *format, size_t size) {
    const char *at = paradt_io_inputs();
    int count = 0;
    for (; *at; at++)
        count += *at == '.';
    number %= count + 1;
    for (at = paradt_io_inputs(); *at && number >= 0; at++)
        number -= *at == '.';
    if (number >= 0)
        return 0;
    snprintf(format, size, "%.*s", (int)strcspn(at, " "), at);
    return 1;
}

static void expect_sound(const paradt_io_points *points, int well, const paradt_io_error *error) {
    size_t i;
    if (!well) {
        if (error->status == PARADT_IO_OK || !error->text[0] || !memchr(error->text, 0, sizeof error->text))
            fail("refused", "without a reason");
        return;
    }
    if (points->dim < 2 || points->dim > PARADT_MAX_DIM)
        fail("points", "of a dimension that is none");
    if (points->count && !points->coordinates)
        fail("points", "are said to be there, and are not");
    for (i = 0; i < points->count * (size_t)points->dim; i++)
        if (!is_finite(points->coordinates[i]))
            fail("points", "a coordinate is not finite");
    for (i = 0; i < points->count && points->weights; i++)
        if (!is_finite(points->weights[i]))
            fail("points", "a weight is not finite");
    if (!memchr(points->note, 0, sizeof points->note))
        fail("points", "the note has no end");
}

static void expect_same(const paradt_io_points *a, const paradt_io_points *b) {
    size_t numbers = a->count * (size_t)a->dim;
    if (a->dim != b->dim || a->count != b->count || !a->weights != !b->weights || strcmp(a->note, b->note) ||
        (numbers && memcmp(a->coordinates, b->coordinates, numbers * sizeof(double))) ||
        (a->weights && a->count && memcmp(a->weights, b->weights, a->count * sizeof(double))))
        fail("read twice", "the points are others");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const char *const columns[] = {NULL, "1-3", "2,1", "x,y,r"};
    paradt_io_points points, again;
    paradt_io_want want;
    paradt_io_error error;
    char format[32], name[40];
    source b = {data, size};
    int number = next_byte(&b), wanted = next_byte(&b), well;
    memset(&want, 0, sizeof want);
    want.dim = wanted & 15;
    if (want.dim == 1 || want.dim > PARADT_MAX_DIM)
        want.dim = 0;
    want.weights = wanted >> 4 & 1;
    want.radii = wanted >> 5 & 1;
    want.columns = columns[wanted >> 6];
    snprintf(name, sizeof name, "f");
    if (choose_format(number, format, sizeof format)) {
        want.format = format;
        snprintf(name, sizeof name, "f.%s", format);
    }
    memset(&points, 0, sizeof points);
    memset(&error, 0, sizeof error);
    well = paradt_io_read_bytes(&points, b.data, b.left, "f", &want, &error);
    expect_sound(&points, well, &error);
    want.format = NULL;
    memset(&again, 0, sizeof again);
    memset(&error, 0, sizeof error);
    if (paradt_io_read_bytes(&again, b.data, b.left, name, &want, &error) != well) {
        if (well) // a name may be doubted where a format that is asked for is not
            expect_sound(&again, 0, &error);
    } else if (well) {
        expect_same(&points, &again);
    }
    paradt_io_free(&again);
    if (well)
        paradt_io_free(&points);
    return 0;
}
