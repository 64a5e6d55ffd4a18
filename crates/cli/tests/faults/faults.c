/* Faults of a disk, put between a program and the C library (LD_PRELOAD).
 *
 *   FAULT_NAME  how the names of the files begin that are meant
 *   FAULT_AT    number of the call that changes a file, from 1, at which it begins
 *   FAULT_KIND  full       from then on no room: half of a write fits, then none;
 *                          no new files; cutting, renaming and removing go well
 *               once       that call alone fails, the ones after it go well
 *               read-only  from then on nothing in the folder can be made, renamed
 *                          or removed; files that are open can be written
 *               kill       the process is killed there; of a write half is done
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static long calls;

/* Whether the last part of a path is the name of a file that is meant: a
 * result; the deck is none, and a lock that cannot be had stops nobody. */
static int is_meant(const char *path) {
    const char *name = getenv("FAULT_NAME");
    const char *last = strrchr(path, '/');
    last = last ? last + 1 : path;
    if (!name || strncmp(last, name, strlen(name))) return 0;
    return !strstr(last, ".inp") && !strstr(last, ".lck");
}

static int is_meant_file(int file) {
    char link[64], path[4096];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t length = readlink(link, path, sizeof path - 1);
    if (length <= 0) return 0;
    path[length] = 0;
    return is_meant(path);
}

static int is_kind(const char *kind) {
    const char *asked = getenv("FAULT_KIND");
    return asked && !strcmp(asked, kind);
}

/* Counts a call; whether it is to go wrong. */
static int goes_wrong(void) {
    const char *at = getenv("FAULT_AT");
    long first = at ? atol(at) : 0;
    calls++;
    if (!first) return 0;
    return is_kind("once") || is_kind("kill") ? calls == first : calls >= first;
}

static int fails(int error) {
    if (is_kind("kill")) raise(SIGKILL);
    errno = error;
    return -1;
}

ssize_t write(int file, const void *bytes, size_t length) {
    static ssize_t (*next)(int, const void *, size_t);
    if (!next) next = dlsym(RTLD_NEXT, "write");
    if (is_meant_file(file) && goes_wrong() && !is_kind("read-only")) {
        static long half_done;
        if (length > 1 && half_done != 1) {
            half_done = 1;
            ssize_t done = next(file, bytes, length / 2);
            if (is_kind("kill")) raise(SIGKILL);
            if (is_kind("once")) calls--; /* the rest of it fails */
            return done;
        }
        return fails(ENOSPC);
    }
    return next(file, bytes, length);
}

static int open_as(const char *symbol, const char *path, int flags, mode_t mode) {
    int (*next)(const char *, int, ...) = dlsym(RTLD_NEXT, symbol);
    int changes = (flags & O_ACCMODE) != O_RDONLY;
    if (changes && is_meant(path) && goes_wrong()) {
        int makes = (flags & O_CREAT) != 0;
        if (is_kind("read-only") ? makes : makes || !is_kind("full"))
            return fails(is_kind("read-only") ? EACCES : ENOSPC);
    }
    return next(path, flags, mode);
}

#define OPEN(symbol)                                 \
    int symbol(const char *path, int flags, ...) {   \
        va_list more;                                \
        va_start(more, flags);                       \
        mode_t mode = va_arg(more, mode_t);          \
        va_end(more);                                \
        return open_as(#symbol, path, flags, mode);  \
    }
OPEN(open)
OPEN(open64)

int rename(const char *from, const char *to) {
    int (*next)(const char *, const char *) = dlsym(RTLD_NEXT, "rename");
    if (is_meant(to) && goes_wrong() && !is_kind("full"))
        return fails(is_kind("read-only") ? EACCES : EIO);
    return next(from, to);
}

int unlink(const char *path) {
    int (*next)(const char *) = dlsym(RTLD_NEXT, "unlink");
    if (is_meant(path) && goes_wrong() && !is_kind("full"))
        return fails(is_kind("read-only") ? EACCES : EIO);
    return next(path);
}

#define CUT(symbol, type)                                                            \
    int symbol(int file, type length) {                                              \
        int (*next)(int, type) = dlsym(RTLD_NEXT, #symbol);                          \
        if (is_meant_file(file) && goes_wrong() && (is_kind("kill") || is_kind("once"))) \
            return fails(EIO);                                                       \
        return next(file, length);                                                   \
    }
CUT(ftruncate, off_t)
CUT(ftruncate64, off64_t)
