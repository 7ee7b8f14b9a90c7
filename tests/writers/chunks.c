/* chunks.c: the writer of files of a sweep in C, for tests/writers/check. The file of the argument
 * has a line "writer folder version" for each call. Prints JOB, the line, then what the writer
 * says, then DONE or FAILED. */
#include "sweep_files.h"

#include <stdio.h>
#include <string.h>

enum { RUNS = 500, COLUMNS = 4 };

int
main (int n, char **words)
{
  static double values[RUNS * COLUMNS];
  char writer[40], folder[4000], why[GS_WHY];
  int version;
  FILE *jobs = n == 2 ? fopen (words[1], "r") : NULL;
  if (! jobs)
    return 1;
  puts ("READY");
  while (fscanf (jobs, "%39s\t%3999[^\t]\t%d", writer, folder, &version) == 3)
    {
      for (int k = 0; k < RUNS * COLUMNS; k++)
        values[k] = version * k;
      const gs_chunk chunk = { 0, RUNS, COLUMNS, 0, values, "" };
      gs_remove_parts (folder);
      const int bad = gs_write_chunk (folder, &chunk, why);
      printf ("JOB %s\n%s\n%s\n", writer, bad ? why : "", bad ? "FAILED" : "DONE");
      fflush (stdout);
    }
  puts ("END");
  return 0;
}
