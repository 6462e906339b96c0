/* Writes the trace of a Spiraling Edge run as JSON Lines (.setrace), for
 * `spiraling-edge diff TRACE INPUT`. C99 and C++, no dependency; include it anywhere.
 *
 *     setrace trace;
 *     setrace_begin(&trace, file, count, positions);       // x y z of each point, in file order
 *     for each pivot {
 *         setrace_pivot(&trace, p, first, last);
 *         setrace_list(&trace, "fan", fan, length);        // from first to last; 0: no triangle
 *         setrace_list(&trace, "ring", ring, ring_length); // optional, as sort, limits, ...
 *         setrace_next(&trace, next);                      // optional
 *     }
 *     if (setrace_end(&trace) != 0) perror("trace");       // then close the file
 *
 * A pivot that is passed over (section 7 of the paper) gets a line, too, with an empty fan. Fields
 * beside p, first, last and fan are optional: `sort`, `limits`, `reciprocal`, `hole` and `sphere`,
 * the candidates after that stage by increasing angle; `start` and `end`; `ring`, the active edge
 * ring after the pivot, from the next pivot on; `next`. A trace that is meant to end before the run
 * does says so in its last line, setrace_ends(). docs/file-formats.md has the rest.
 */
#ifndef SETRACE_H
#define SETRACE_H

#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* Value of setrace_next() where no ring is left. */
#define SETRACE_NONE UINT32_MAX

typedef struct {
    FILE* file;
    int in_line; /* A line was begun. */
    int failed;  /* Something could not be written. */
} setrace;

static inline void setrace_check(setrace* trace, int result) {
    if (result < 0) trace->failed = 1;
}

/* 64-bit FNV-1a of the positions as doubles, the least significant byte first. */
static inline uint64_t setrace_hash(size_t count, const double* xyz) {
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    size_t i;
    int k;
    for (i = 0; i < 3 * count; ++i) {
        uint64_t bits;
        memcpy(&bits, &xyz[i], sizeof bits);
        for (k = 0; k < 8; ++k) hash = (hash ^ ((bits >> (8 * k)) & 255)) * UINT64_C(0x100000001b3);
    }
    return hash;
}

/* Writes the header. `xyz` has three doubles per point, equal to those of the input file; NULL if
 * the program holds other numbers: then diff compares only the number of points. */
static inline void setrace_begin(setrace* trace, FILE* file, size_t count, const double* xyz) {
    trace->file = file;
    trace->in_line = 0;
    trace->failed = 0;
    setrace_check(trace, fprintf(file, "{\"setrace\":1,\"points\":%" PRIu64, (uint64_t)count));
    if (xyz != NULL) {
        setrace_check(
            trace, fprintf(file, ",\"hash\":\"fnv1a64:%016" PRIx64 "\"", setrace_hash(count, xyz)));
    }
    setrace_check(trace, fputs("}\n", file));
}

static inline void setrace_end_line(setrace* trace) {
    if (trace->in_line) setrace_check(trace, fputs("}\n", trace->file));
    trace->in_line = 0;
}

/* Begins the line of a pivot between `first` and `last`, all numbers of points from 0. */
static inline void setrace_pivot(setrace* trace, uint32_t p, uint32_t first, uint32_t last) {
    setrace_end_line(trace);
    setrace_check(
        trace, fprintf(trace->file, "{\"p\":%" PRIu32 ",\"first\":%" PRIu32 ",\"last\":%" PRIu32, p,
                       first, last));
    trace->in_line = 1;
}

/* Adds a list of points to the line: "fan", "sort", "limits", "reciprocal", "hole", "sphere",
 * "ring". */
static inline void setrace_list(setrace* trace, const char* field, const uint32_t* points,
                                size_t count) {
    size_t i;
    setrace_check(trace, fprintf(trace->file, ",\"%s\":[", field));
    for (i = 0; i < count; ++i)
        setrace_check(trace, fprintf(trace->file, "%s%" PRIu32, i > 0 ? "," : "", points[i]));
    setrace_check(trace, fputs("]", trace->file));
}

/* Adds one point to the line: "start" or "end", the limits of section 6.1. */
static inline void setrace_point(setrace* trace, const char* field, uint32_t point) {
    setrace_check(trace, fprintf(trace->file, ",\"%s\":%" PRIu32, field, point));
}

/* Adds the next pivot, or SETRACE_NONE. */
static inline void setrace_next(setrace* trace, uint32_t next) {
    if (next == SETRACE_NONE) {
        setrace_check(trace, fputs(",\"next\":null", trace->file));
    } else {
        setrace_point(trace, "next", next);
    }
}

/* Marks the pivot as the one with which the trace is meant to end. */
static inline void setrace_ends(setrace* trace) {
    setrace_check(trace, fputs(",\"ends\":true", trace->file));
}

/* Ends the last line. Returns 0 if all could be written; the file stays open. */
static inline int setrace_end(setrace* trace) {
    setrace_end_line(trace);
    if (fflush(trace->file) != 0) trace->failed = 1;
    return trace->failed;
}

#endif
