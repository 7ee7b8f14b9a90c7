/* A library for LD_PRELOAD: programs see the clock and the times of files one year from now, as if
   the machine's clock was. (Debian's faketime does so, too, but Maxima on GCL crashes under it.) */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stddef.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { year = 365 * 86400 };

int
clock_gettime (clockid_t clock, struct timespec *t)
{
  int code = syscall (SYS_clock_gettime, clock, t);
  if (code == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
    t->tv_sec += year;
  return code;
}

time_t
time (time_t *t)
{
  struct timespec now;
  clock_gettime (CLOCK_REALTIME, &now);
  if (t != NULL)
    *t = now.tv_sec;
  return now.tv_sec;
}

int
gettimeofday (struct timeval *restrict t, void *restrict zone)
{
  struct timespec now;
  (void) zone;
  clock_gettime (CLOCK_REALTIME, &now);
  t->tv_sec = now.tv_sec;
  t->tv_usec = now.tv_nsec / 1000;
  return 0;
}

/* -- files: what is read is later by a year, what is set is earlier */

int
fstatat (int folder, const char *restrict name, struct stat *restrict s, int flags)
{
  int code = syscall (SYS_newfstatat, folder, name, s, flags);
  if (code == 0)
    {
      s->st_atim.tv_sec += year;
      s->st_mtim.tv_sec += year;
      s->st_ctim.tv_sec += year;
    }
  return code;
}
int
stat (const char *restrict name, struct stat *restrict s)
{
  return fstatat (AT_FDCWD, name, s, 0);
}
int
lstat (const char *restrict name, struct stat *restrict s)
{
  return fstatat (AT_FDCWD, name, s, AT_SYMLINK_NOFOLLOW);
}
int fstat (int file, struct stat *s) { return fstatat (file, "", s, AT_EMPTY_PATH); }

/* the same structure with 64 bits */
int fstatat64 (int, const char *restrict, struct stat64 *restrict, int)
  __attribute__ ((alias ("fstatat")));
int stat64 (const char *restrict, struct stat64 *restrict) __attribute__ ((alias ("stat")));
int lstat64 (const char *restrict, struct stat64 *restrict) __attribute__ ((alias ("lstat")));
int fstat64 (int, struct stat64 *) __attribute__ ((alias ("fstat")));

int
statx (int folder, const char *restrict name, int flags, unsigned mask, struct statx *restrict s)
{
  int code = syscall (SYS_statx, folder, name, flags, mask, s);
  if (code == 0)
    {
      s->stx_atime.tv_sec += year;
      s->stx_btime.tv_sec += year;
      s->stx_ctime.tv_sec += year;
      s->stx_mtime.tv_sec += year;
    }
  return code;
}

static int
set_times (int folder, const char *name, const struct timespec *t, int flags)
{
  struct timespec set[2];
  for (int k = 0; t != NULL && k < 2; k++)
    {
      set[k] = t[k];
      if (t[k].tv_nsec != UTIME_NOW && t[k].tv_nsec != UTIME_OMIT)
        set[k].tv_sec -= year;
    }
  return syscall (SYS_utimensat, folder, name, t == NULL ? NULL : set, flags);
}
int
utimensat (int folder, const char *name, const struct timespec t[2], int flags)
{
  return set_times (folder, name, t, flags);
}
int futimens (int file, const struct timespec t[2]) { return set_times (file, NULL, t, 0); }
