/* The job and the chunks of a sweep on disk; sweep_files.h says what they are. */
#define _GNU_SOURCE
#include "sweep_files.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int
wrong (char *why, const char *what, const char *file)
{
  snprintf (why, GS_WHY, "%s %s: %s", what, file, errno ? strerror (errno) : "it is cut short");
  return 1;
}

/* one record; 0: there is another, 1: the end, 2: it is broken */
static int
next_record (FILE *f, gs_record *r)
{
  char line[120];
  if (! fgets (line, sizeof line, f))
    return 1;
  r->data = NULL;
  if (sscanf (line, "%39s %c %lld", r->name, &r->type, &r->count) != 3 || r->count < 0)
    return 2;
  size_t size = r->type == 'd' ? sizeof (double) : 1, n = (size_t) r->count;
  r->data = calloc (n + 1, size);
  if (! r->data || fread (r->data, size, n, f) != n || fgetc (f) != '\n')
    return 2;
  return 0;
}

int
gs_read_job (const char *file, gs_job *job, char *why)
{
  *job = (gs_job){ 0, NULL };
  errno = 0;
  FILE *f = fopen (file, "rb");
  if (! f)
    return wrong (why, "cannot read", file);
  int state = 0;
  while (state == 0)
    {
      gs_record r = { "", 'd', 0, NULL };
      state = next_record (f, &r);
      gs_record *more = state == 0 ? realloc (job->records, (job->count + 1) * sizeof r) : NULL;
      if (more)
        {
          job->records = more;
          job->records[job->count++] = r;
        }
      else
        {
          free (r.data);
          state = state == 0 ? 2 : state;
        }
    }
  fclose (f);
  errno = 0;
  if (state == 2 || job->count == 0 || strcmp (job->records[job->count - 1].name, "end") != 0)
    return wrong (why, "cannot read", file);
  return 0;
}

void
gs_free_job (gs_job *job)
{
  for (int i = 0; i < job->count; i++)
    free (job->records[i].data);
  free (job->records);
  *job = (gs_job){ 0, NULL };
}

static const void *
found (const gs_job *job, const char *name, char type, long long *count)
{
  for (int i = 0; i < job->count; i++)
    if (job->records[i].type == type && strcmp (job->records[i].name, name) == 0)
      {
        *count = job->records[i].count;
        return job->records[i].data;
      }
  *count = 0;
  return NULL;
}

const double *
gs_numbers (const gs_job *job, const char *name, long long *count)
{
  return found (job, name, 'd', count);
}

const char *
gs_text (const gs_job *job, const char *name, long long *count)
{
  const char *text = found (job, name, 's', count);
  return text ? text : "";
}

double
gs_number (const gs_job *job, const char *name, double otherwise)
{
  long long n;
  const double *x = gs_numbers (job, name, &n);
  return n > 0 ? x[0] : otherwise;
}

/* the head of a chunk's file; SUM: CRC-32 of what stands behind the head */
typedef struct
{
  char magic[8];
  int64_t first, n, columns, length;
  uint64_t sum;
} chunk_head;

static const char magic[8] = "GSSWEEP1";

static uint32_t
crc (uint32_t sum, const void *data, size_t n)
{
  static uint32_t table[256];
  const unsigned char *p = data;
  if (table[1] == 0)
    for (uint32_t i = 256; i-- > 0;)
      {
        uint32_t c = i;
        for (int k = 0; k < 8; k++)
          c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
        table[i] = c;
      }
  for (sum = ~sum; n-- > 0; p++)
    sum = table[(sum ^ *p) & 255] ^ (sum >> 8);
  return ~sum;
}

static uint32_t
sum_of (const gs_chunk *c)
{
  size_t bytes = sizeof (double) * (size_t) (c->n * c->columns);
  return crc (crc (0, c->values, bytes), c->text, (size_t) c->length);
}

static int
put (int file, const void *data, size_t n)
{
  for (const char *p = data; n > 0;)
    {
      ssize_t k = write (file, p, n);
      if (k < 0 && errno == EINTR)
        continue;
      if (k <= 0)
        return 1;
      p += k;
      n -= (size_t) k;
    }
  return 0;
}

int
gs_write_chunk (const char *folder, const gs_chunk *c, char *why)
{
  char name[4200], part[GS_PATH];
  snprintf (name, sizeof name, "%.4000s/%012lld_%lld.part", folder, c->first, c->n);
  if (gs_beside (name, part, why) != 0)
    return 1;
  chunk_head h = { "", c->first, c->n, c->columns, c->length, sum_of (c) };
  memcpy (h.magic, magic, sizeof magic);
  errno = 0;
  int file = open (part, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (file < 0)
    return wrong (why, "cannot write", name);
  int bad = put (file, &h, sizeof h)
            || put (file, c->values, sizeof (double) * (size_t) (c->n * c->columns))
            || put (file, c->text, (size_t) c->length);
  bad = close (file) != 0 || bad;
  if (! bad)
    return gs_put_part (part, name, why);
  wrong (why, "cannot write", name);
  unlink (part);
  return 1;
}

static int
read_body (FILE *f, const chunk_head *h, gs_chunk *c)
{
  const long long most = 1LL << 40;
  if (memcmp (h->magic, magic, sizeof magic) != 0 || h->n < 1 || h->columns < 1 || h->length < 0
      || h->n > most / h->columns || h->length > most)
    return 1;
  *c = (gs_chunk){ h->first, h->n, h->columns, h->length, NULL, NULL };
  size_t n = (size_t) (h->n * h->columns);
  c->values = malloc (n * sizeof (double));
  c->text = calloc ((size_t) h->length + 1, 1);
  return ! c->values || ! c->text || fread (c->values, sizeof (double), n, f) != n
         || fread (c->text, 1, (size_t) h->length, f) != (size_t) h->length || fgetc (f) != EOF
         || sum_of (c) != h->sum;
}

int
gs_read_chunk (const char *folder, const char *name, gs_chunk *c, char *why)
{
  char path[4400];
  snprintf (path, sizeof path, "%.4000s/%.300s", folder, name);
  *c = (gs_chunk){ 0, 0, 0, 0, NULL, NULL };
  errno = 0;
  FILE *f = fopen (path, "rb");
  if (! f)
    return wrong (why, "cannot read", path);
  chunk_head h;
  int bad = fread (&h, sizeof h, 1, f) != 1 || read_body (f, &h, c);
  fclose (f);
  errno = 0;
  if (! bad)
    return 0;
  gs_free_chunk (c);
  return wrong (why, "cannot read", path);
}

void
gs_free_chunk (gs_chunk *c)
{
  free (c->values);
  free (c->text);
  c->values = NULL;
  c->text = NULL;
}

static int
ends_with (const char *name, const char *end)
{
  size_t n = strlen (name), k = strlen (end);
  return n >= k && strcmp (name + n - k, end) == 0;
}

static int
by_name (const void *a, const void *b)
{
  return strcmp (*(char *const *) a, *(char *const *) b);
}

int
gs_list_chunks (const char *folder, int tidy, char ***names, int *count, char *why)
{
  *names = NULL;
  *count = 0;
  if (tidy)
    gs_remove_parts (folder);
  errno = 0;
  DIR *d = opendir (folder);
  if (! d)
    return wrong (why, "cannot read", folder);
  int bad = 0;
  for (struct dirent *e = readdir (d); e && ! bad; e = readdir (d))
    {
      if (! ends_with (e->d_name, ".part") || e->d_name[0] == '.')
        continue;
      char **more = realloc (*names, (size_t) (*count + 1) * sizeof (char *));
      bad = ! more || ! (more[*count] = strdup (e->d_name));
      *names = more ? more : *names;
      *count += ! bad;
    }
  closedir (d);
  if (*count > 0)
    qsort (*names, (size_t) *count, sizeof (char *), by_name);
  return bad ? wrong (why, "no memory for the list of", folder) : 0;
}

void
gs_free_list (char **names, int count)
{
  for (int i = 0; i < count; i++)
    free (names[i]);
  free (names);
}
