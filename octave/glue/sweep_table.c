/* The table of a sweep in HDF5, made of its chunks one by one; sweep_files.h says what they are.
   /table: a row for each run, /names and /units of its columns (also as attributes of it); /ok and
   /reached [s] of the runs; /failed/run and /failed/reason; /whole/NAME: runs x /times [s]. */
#define _GNU_SOURCE
#include "sweep_files.h"

#include <errno.h>
#include <hdf5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct
{
  const gs_job *job;
  const char *folder;
  hid_t file, plain;              /* PLAIN: no times are noted, the same table is the same bytes */
  hid_t table, ok, reached, whole[200];
  long long runs, varied, kept, wholes, nt, found;
  const double *samples;          /* runs x varied, run by run */
  char *failed;                   /* all lines RUN<tab>REASON */
  size_t length;
} export;

/* how many lines a text has */
static long long
lines_of (const char *text)
{
  long long n = 0;
  for (; *text; text++)
    n += *text == '\n';
  return n;
}

/* a data set in pieces of whole rows, about 256 kB, each with a checksum that every reader of HDF5
   looks at; their places are those of the table, whatever the order in which they are written */
static hid_t
made (const export *e, hid_t at, const char *name, hid_t type, int rank, const hsize_t *dims)
{
  const size_t row = H5Tget_size (type) * (size_t) (rank > 1 ? dims[1] : 1);
  hsize_t piece[2] = { row > 0 && row < 262144 ? 262144 / row : 1, rank > 1 ? dims[1] : 1 };
  piece[0] = piece[0] < dims[0] ? piece[0] : dims[0];
  H5Pset_chunk (e->plain, rank, piece);
  hid_t space = H5Screate_simple (rank, dims, NULL);
  hid_t set = H5Dcreate2 (at, name, type, space, H5P_DEFAULT, e->plain, H5P_DEFAULT);
  H5Sclose (space);
  return set;
}

/* lines of a text as strings of one length; SET < 0: as an attribute of TO */
static int
put_lines (const export *e, hid_t to, const char *name, const char *text, int attribute)
{
  hsize_t n = (hsize_t) lines_of (text), width = 1, k = 0;
  for (const char *p = text, *q; (q = strchr (p, '\n')); p = q + 1)
    width = (hsize_t) (q - p) > width ? (hsize_t) (q - p) : width;
  char *rows = calloc (n + 1, width);
  if (! rows || n == 0)
    {
      free (rows);
      return n != 0;
    }
  for (const char *p = text, *q; (q = strchr (p, '\n')); p = q + 1)
    memcpy (rows + width * k++, p, (size_t) (q - p));
  hid_t type = H5Tcopy (H5T_C_S1), space = H5Screate_simple (1, &n, NULL);
  H5Tset_size (type, width);
  H5Tset_strpad (type, H5T_STR_NULLPAD);
  hid_t it = attribute ? H5Acreate2 (to, name, type, space, H5P_DEFAULT, H5P_DEFAULT)
                       : made (e, to, name, type, 1, &n);
  int bad = it < 0 || (attribute ? H5Awrite (it, type, rows)
                                 : H5Dwrite (it, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows)) < 0;
  attribute ? H5Aclose (it) : H5Dclose (it);
  H5Sclose (space);
  H5Tclose (type);
  free (rows);
  return bad;
}

static int
put_unit (const export *e, hid_t to, const char *unit)
{
  char line[80];
  snprintf (line, sizeof line, "%.70s\n", unit);
  return put_lines (e, to, "unit", line, 1);
}

/* line number K of a text */
static void
line (const char *text, long long k, char *out, size_t room)
{
  for (; k > 0 && text; k--)
    if ((text = strchr (text, '\n')))
      text++;
  size_t n = text ? strcspn (text, "\n") : 0;
  snprintf (out, room, "%.*s", (int) n, text ? text : "");
}

static int
put_times (export *e)
{
  long long n;
  const double *times = gs_numbers (e->job, "tout", &n);
  hsize_t dims[1] = { (hsize_t) n };
  hid_t set = made (e, e->file, "times", H5T_NATIVE_DOUBLE, 1, dims);
  int bad = H5Dwrite (set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times) < 0
            || put_unit (e, set, "s");
  H5Dclose (set);
  return bad;
}

static int
put_wholes (export *e)
{
  long long n;
  const char *names = gs_text (e->job, "whole", &n), *units = gs_text (e->job, "whole_units", &n);
  hsize_t dims[2] = { (hsize_t) e->runs, (hsize_t) e->nt };
  char name[200], unit[80];
  if (e->wholes == 0)
    return 0;
  hid_t group = H5Gcreate2 (e->file, "whole", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  int bad = put_times (e);
  for (int k = 0; k < e->wholes && ! bad; k++)
    {
      line (names, k, name, sizeof name);
      line (units, k, unit, sizeof unit);
      e->whole[k] = made (e, group, name, H5T_NATIVE_DOUBLE, 2, dims);
      bad = e->whole[k] < 0 || put_unit (e, e->whole[k], unit);
    }
  H5Gclose (group);
  return bad;
}

static int
begin (export *e)
{
  long long n;
  hsize_t dims[2] = { (hsize_t) e->runs, (hsize_t) (e->varied + e->kept) };
  const char *names = gs_text (e->job, "names", &n), *units = gs_text (e->job, "units", &n);
  e->table = made (e, e->file, "table", H5T_NATIVE_DOUBLE, 2, dims);
  e->ok = made (e, e->file, "ok", H5T_STD_U8LE, 1, dims);
  e->reached = made (e, e->file, "reached", H5T_NATIVE_DOUBLE, 1, dims);
  return e->table < 0 || e->ok < 0 || e->reached < 0 || put_unit (e, e->reached, "s")
         || put_lines (e, e->table, "names", names, 1)
         || put_lines (e, e->table, "units", units, 1)
         || put_lines (e, e->file, "names", names, 0) || put_lines (e, e->file, "units", units, 0)
         || put_lines (e, e->file, "description", gs_text (e->job, "description", &n), 0)
         || put_wholes (e);
}

/* rows FIRST to FIRST + N - 1 of a data set */
static int
put_rows (hid_t set, hid_t type, long long first, long long n, long long columns, const void *x)
{
  hsize_t from[2] = { (hsize_t) first, 0 }, size[2] = { (hsize_t) n, (hsize_t) columns };
  hid_t space = H5Dget_space (set);
  int rank = H5Sget_simple_extent_ndims (space);
  H5Sselect_hyperslab (space, H5S_SELECT_SET, from, NULL, size, NULL);
  hid_t memory = H5Screate_simple (rank, size, NULL);
  int bad = H5Dwrite (set, type, memory, space, H5P_DEFAULT, x) < 0;
  H5Sclose (memory);
  H5Sclose (space);
  return bad;
}

/* columns FROM to FROM + N - 1 of the rows of a chunk, behind BEFORE places of each row of OUT */
static void
part (const gs_chunk *c, long long from, long long n, double *out, long long before)
{
  for (long long i = 0; i < c->n; i++)
    memcpy (out + (before + n) * i + before, c->values + c->columns * i + from,
            sizeof (double) * (size_t) n);
}

static int
put_chunk (export *e, const gs_chunk *c)
{
  long long width = e->varied + e->kept, most = width > e->nt ? width : e->nt;
  double *rows = malloc (sizeof (double) * (size_t) (c->n * (most + 1)));
  unsigned char *ok = malloc ((size_t) c->n);
  if (! rows || ! ok)
    return 1;
  part (c, 2, e->kept, rows, e->varied);
  for (long long i = 0; i < c->n; i++)
    {
      ok[i] = c->values[c->columns * i] != 0;
      memcpy (rows + width * i, e->samples + e->varied * (c->first + i),
              sizeof (double) * (size_t) e->varied);
    }
  int bad = put_rows (e->table, H5T_NATIVE_DOUBLE, c->first, c->n, width, rows)
            || put_rows (e->ok, H5T_NATIVE_UCHAR, c->first, c->n, 1, ok);
  part (c, 1, 1, rows, 0);
  bad = bad || put_rows (e->reached, H5T_NATIVE_DOUBLE, c->first, c->n, 1, rows);
  for (int k = 0; k < e->wholes && ! bad; k++)
    {
      part (c, 2 + e->kept + k * e->nt, e->nt, rows, 0);
      bad = put_rows (e->whole[k], H5T_NATIVE_DOUBLE, c->first, c->n, e->nt, rows);
    }
  free (rows);
  free (ok);
  return bad;
}

/* the chunks in the order of the runs, which they cover one after the other */
static int
put_chunks (export *e, char *why)
{
  char **names;
  int count, bad = gs_list_chunks (e->folder, 0, &names, &count, why);
  for (int k = 0; k < count && ! bad; k++)
    {
      gs_chunk c;
      bad = gs_read_chunk (e->folder, names[k], &c, why);
      if (! bad && (c.first != e->found || c.first + c.n > e->runs
                    || c.columns != 2 + e->kept + e->wholes * e->nt))
        {
          snprintf (why, GS_WHY, "%s/%s does not follow the chunk before", e->folder, names[k]);
          bad = 1;
        }
      char *more = bad ? NULL : realloc (e->failed, e->length + (size_t) c.length + 1);
      if (more)
        {
          memcpy (more + e->length, c.text, (size_t) c.length + 1);
          e->failed = more;
          e->length += (size_t) c.length;
          e->found += c.n;
          bad = put_chunk (e, &c);
        }
      gs_free_chunk (&c);
    }
  gs_free_list (names, count);
  if (! bad && e->found != e->runs)
    snprintf (why, GS_WHY, "%s has %lld of %lld runs", e->folder, e->found, e->runs);
  return bad || e->found != e->runs;
}

/* the runs that failed, and why */
static int
put_failed (export *e)
{
  hsize_t n = e->failed ? (hsize_t) lines_of (e->failed) : 0, k = 0;
  if (n == 0)
    return 0;
  double *run = malloc (n * sizeof (double));
  char *text = calloc (e->length + 1, 1), *to = text;
  if (! run || ! text)
    return 1;
  for (char *p = e->failed, *tab, *end; (end = strchr (p, '\n')); p = end + 1)
    {
      run[k++] = atof (p);
      tab = memchr (p, '\t', (size_t) (end - p));
      p = tab ? tab + 1 : p;
      memcpy (to, p, (size_t) (end + 1 - p));
      to += end + 1 - p;
    }
  hid_t group = H5Gcreate2 (e->file, "failed", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  hid_t set = made (e, group, "run", H5T_STD_I64LE, 1, &n);
  int bad = H5Dwrite (set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, run) < 0
            || put_lines (e, group, "reason", text, 0);
  H5Dclose (set);
  H5Gclose (group);
  free (run);
  free (text);
  return bad;
}

static void
end (export *e)
{
  hid_t sets[] = { e->table, e->ok, e->reached };
  for (int k = 0; k < 3; k++)
    if (sets[k] >= 0)
      H5Dclose (sets[k]);
  for (int k = 0; k < e->wholes; k++)
    if (e->whole[k] >= 0)
      H5Dclose (e->whole[k]);
  H5Pclose (e->plain);
  free (e->failed);
}

static void
sizes (export *e)
{
  long long n;
  e->samples = gs_numbers (e->job, "samples", &n);
  e->varied = (long long) gs_number (e->job, "varied", 0);
  e->runs = e->varied > 0 ? n / e->varied : 0;
  e->kept = lines_of (gs_text (e->job, "names", &n)) - e->varied;
  e->wholes = lines_of (gs_text (e->job, "whole", &n));
  gs_numbers (e->job, "tout", &e->nt);
  for (int k = 0; k < 200; k++)
    e->whole[k] = -1;
  e->table = e->ok = e->reached = -1;
}

int
gs_export_sweep (const gs_job *job, const char *folder, const char *file, char *why)
{
  char part[GS_PATH];
  export e = { .job = job, .folder = folder };
  sizes (&e);
  if (gs_beside (file, part, why) != 0)
    return 1;
  snprintf (why, GS_WHY, "cannot write %.500s", file);
  if (e.wholes > 200)
    return snprintf (why, GS_WHY, "more than 200 whole runs are kept"), 1;
  H5Eset_auto2 (H5E_DEFAULT, NULL, NULL);
  e.file = H5Fcreate (part, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  if (e.file < 0)
    return 1;
  e.plain = H5Pcreate (H5P_DATASET_CREATE);
  H5Pset_obj_track_times (e.plain, 0);
  H5Pset_fletcher32 (e.plain);
  H5Pset_alloc_time (e.plain, H5D_ALLOC_TIME_EARLY);
  int bad = begin (&e) || put_chunks (&e, why) || put_failed (&e);
  end (&e);
  bad = H5Fclose (e.file) < 0 || bad;
  if (! bad)
    return gs_put_part (part, file, why);
  unlink (part);
  return 1;
}

/* are the rows of WIDTH characters the lines of a text? */
static int
same_lines (const char *rows, size_t n, size_t width, const char *text)
{
  for (size_t k = 0; k < n; k++)
    {
      size_t length = strcspn (text, "\n"), there = strnlen (rows + width * k, width);
      if (text[length] == 0 || there != length || memcmp (rows + width * k, text, length) != 0)
        return 0;
      text += length + 1;
    }
  return *text == 0;
}

int
gs_is_table_of (const gs_job *job, const char *file)
{
  long long size;
  H5Eset_auto2 (H5E_DEFAULT, NULL, NULL);
  hid_t f = H5Fopen (file, H5F_ACC_RDONLY, H5P_DEFAULT);
  hid_t set = f < 0 ? -1 : H5Dopen2 (f, "description", H5P_DEFAULT);
  hid_t type = set < 0 ? -1 : H5Dget_type (set), space = set < 0 ? -1 : H5Dget_space (set);
  hssize_t n = space < 0 ? 0 : H5Sget_simple_extent_npoints (space);
  size_t width = type < 0 ? 0 : H5Tget_size (type);
  char *rows = n > 0 && width > 0 ? calloc ((size_t) n, width) : NULL;
  int is = rows && H5Dread (set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows) >= 0
           && same_lines (rows, (size_t) n, width, gs_text (job, "description", &size));
  free (rows);
  if (set >= 0)
    {
      H5Sclose (space);
      H5Tclose (type);
      H5Dclose (set);
    }
  if (f >= 0)
    H5Fclose (f);
  return is;
}

/* can a data set be read?  By pieces of whole rows; HDF5 looks at their checksums. */
static int
readable (hid_t set)
{
  hsize_t size[2] = { 1, 1 }, at[2] = { 0, 0 }, piece[2];
  hid_t type = H5Dget_type (set), space = H5Dget_space (set);
  int rank = H5Sget_simple_extent_ndims (space);
  int good = (rank == 1 || rank == 2) && H5Sget_simple_extent_dims (space, size, NULL) == rank;
  const size_t row = H5Tget_size (type) * (size_t) size[1];
  const hsize_t most = row > 0 && row < 1048576 ? 1048576 / row : 1;
  char *rows = malloc ((size_t) most * row + 1);
  for (; good && rows && at[0] < size[0]; at[0] += most)
    {
      piece[0] = size[0] - at[0] < most ? size[0] - at[0] : most;
      piece[1] = size[1];
      hid_t here = H5Screate_simple (rank, piece, NULL);
      good = H5Sselect_hyperslab (space, H5S_SELECT_SET, at, NULL, piece, NULL) >= 0
             && H5Dread (set, type, here, space, H5P_DEFAULT, rows) >= 0;
      H5Sclose (here);
    }
  good = good && rows;
  free (rows);
  H5Sclose (space);
  H5Tclose (type);
  return good;
}

static herr_t
not_readable (hid_t at, const char *name, const H5L_info_t *link, void *none)
{
  (void) link, (void) none;
  hid_t it = H5Oopen (at, name, H5P_DEFAULT);
  int bad = it < 0 || (H5Iget_type (it) == H5I_DATASET && ! readable (it));
  if (it >= 0)
    H5Oclose (it);
  return bad;
}

int
gs_is_whole_table (const char *file)
{
  H5Eset_auto2 (H5E_DEFAULT, NULL, NULL);
  hid_t f = H5Fopen (file, H5F_ACC_RDONLY, H5P_DEFAULT);
  int good = f >= 0 && H5Lvisit (f, H5_INDEX_NAME, H5_ITER_NATIVE, not_readable, NULL) == 0;
  if (f >= 0)
    H5Fclose (f);
  return good;
}
