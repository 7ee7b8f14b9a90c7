/* The one writer of files of the C of a sweep; sweep_files.h says what it does. */
#define _GNU_SOURCE
#include "sweep_files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int
refuse (char *why, const char *target, const char *found)
{
  snprintf (why, GS_WHY, "%.300s: expected a regular file or a new name; found %.200s", target,
            found);
  return 1;
}

/* TARGET with symbolic links followed, in REAL; 1: it is there and no regular file */
static int
real_file (const char *target, char real[PATH_MAX], char *why)
{
  struct stat there;
  if (lstat (target, &there) != 0)
    return snprintf (real, PATH_MAX, "%s", target) >= PATH_MAX ? refuse (why, target, "a long name")
                                                               : 0;
  if (! realpath (target, real) || stat (real, &there) != 0)
    return refuse (why, target, "a symbolic link to nothing");
  return S_ISREG (there.st_mode) ? 0 : refuse (why, target, S_ISDIR (there.st_mode) ? "a folder"
                                               : "a device, pipe or socket");
}

int
gs_beside (const char *target, char *part, char *why)
{
  char real[PATH_MAX];
  if (real_file (target, real, why) != 0)
    return 1;
  char *slash = strrchr (real, '/');
  int folder = slash ? (int) (slash - real) + 1 : 0;
  if (snprintf (part, GS_PATH, "%.*s.new-%ld-%s", folder, real, (long) getpid (), real + folder)
      >= GS_PATH)
    return refuse (why, target, "a long name");
  return 0;
}

int
gs_put_part (const char *part, const char *target, char *why)
{
  char real[PATH_MAX];
  if (real_file (target, real, why) != 0)
    {
      unlink (part);
      return 1;
    }
  errno = 0;
  int f = open (part, O_RDONLY);
  int bad = f < 0 || fsync (f) != 0, reason = errno;
  bad = (f >= 0 && close (f) != 0) || bad;
  if (! bad && rename (part, real) == 0)
    return 0;
  snprintf (why, GS_WHY, "cannot write %.400s: %s", target, strerror (bad ? reason : errno));
  unlink (part);
  return 1;
}

void
gs_remove_parts (const char *folder)
{
  char path[GS_PATH], *end;
  DIR *d = opendir (folder);
  for (struct dirent *e = d ? readdir (d) : NULL; e; e = readdir (d))
    {
      if (strncmp (e->d_name, ".new-", 5) != 0)
        continue;
      long pid = strtol (e->d_name + 5, &end, 10);
      if (pid > 0 && *end == '-' && kill ((pid_t) pid, 0) != 0 && errno == ESRCH
          && snprintf (path, sizeof path, "%s/%s", folder, e->d_name) < (int) sizeof path)
        unlink (path);
    }
  if (d)
    closedir (d);
}
