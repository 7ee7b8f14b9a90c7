/* The program of a sweep: no Octave, as many threads, and ranks of MPI, as there are.

     sweep [-t THREADS] [-o FILE] [JOB]

   JOB is sweep.job beside the program, FILE sweep.h5 beside the job.  Chunks of runs are dealt out
   to whoever is done; each finished one is written whole into FILE.parts.  What stands there is not
   made again, so that a start after an end of whatever kind goes on.  At the end they become the
   table FILE.  It is the same for any number of ranks and threads. */
#define _GNU_SOURCE
#include "sweep_run.h"

#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#if defined (GS_MPI)
#include <mpi.h>
#endif

static int rank = 0, ranks = 1;

static void
stop (const char *why)
{
  fprintf (stderr, "sweep: %s\n", why);
#if defined (GS_MPI)
  MPI_Abort (MPI_COMM_WORLD, 1);
#endif
  exit (1);
}

static double
now (void)
{
  struct timespec t;
  clock_gettime (CLOCK_MONOTONIC, &t);
  return (double) t.tv_sec + 1e-9 * (double) t.tv_nsec;
}

/* ---- a chunk: its runs, made by the threads */

typedef struct
{
  gs_chunk c;
  char (*why)[GS_WHY];
} chunk_work;

/* the lines of those that failed */
static void
told (chunk_work *w)
{
  size_t room = 1;
  for (long long k = 0; k < w->c.n; k++)
    room += w->why[k][0] ? strlen (w->why[k]) + 30 : 0;
  w->c.text = calloc (room, 1);
  if (! w->c.text)
    stop ("no memory");
  for (long long k = 0; k < w->c.n; k++)
    if (w->why[k][0])
      w->c.length += sprintf (w->c.text + w->c.length, "%lld\t%s\n", w->c.first + k + 1, w->why[k]);
}

static void
run_chunk (const gs_sweep *s, const char *folder, int threads, long long first, long long n)
{
  chunk_work w = { .c = { first, n, s->columns, 0, NULL, NULL } };
  char why[GS_WHY] = "";
  w.c.values = calloc ((size_t) (n * s->columns), sizeof (double));
  w.why = calloc ((size_t) n, GS_WHY);
  if (! w.c.values || ! w.why)
    stop ("no memory");
  if (gs_sweep_rows (s, first, (int) n, threads, w.c.values, w.why, why) != 0)
    stop (why);
  told (&w);
  if (gs_write_chunk (folder, &w.c, why) != 0)
    stop (why);
  gs_free_chunk (&w.c);
  free (w.why);
}

/* ---- the dealer: which runs are missing, and how many make a chunk */

typedef struct
{
  char *have;
  long long runs, next, left, most;
  int workers;
  double a_run;     /* seconds, as the last chunk had it; 0: none has yet */
  pthread_mutex_t lock;
} dealer;

/* about a second of work, towards the end less */
static long long
size_of (const dealer *d)
{
  long long n = d->a_run > 0 ? (long long) (1 / d->a_run) : 16;
  long long fair = d->left / (2 * d->workers) + 1;
  n = n < fair ? n : fair;
  n = n < d->most ? n : d->most;
  return n > 1 ? n : 1;
}

/* the next chunk; N = 0: there is none */
static void
deal (dealer *d, double a_run, long long chunk[2])
{
  pthread_mutex_lock (&d->lock);
  if (a_run > 0)
    d->a_run = a_run;
  while (d->next < d->runs && d->have[d->next])
    d->next++;
  long long most = size_of (d), first = d->next;
  while (d->next < d->runs && ! d->have[d->next] && d->next - first < most)
    d->have[d->next++] = 1;
  chunk[0] = first;
  chunk[1] = d->next - first;
  d->left -= chunk[1];
  pthread_mutex_unlock (&d->lock);
}

/* what stands on disk is not made again; what is not whole goes */
static void
open_dealer (dealer *d, const gs_sweep *s, const char *folder, int workers)
{
  char **names, why[GS_WHY] = "", path[PATH_MAX];
  int count;
  long long room = (long long) 4e6 / (s->columns * s->start.nt);
  *d = (dealer){ .runs = s->runs, .left = s->runs, .workers = workers, .most = room };
  d->most = d->most < 1 ? 1 : d->most > 16384 ? 16384 : d->most;
  d->have = calloc ((size_t) s->runs + 1, 1);
  if (! d->have)
    stop ("no memory");
  if (gs_list_chunks (folder, 1, &names, &count, why) != 0)
    stop (why);
  for (int k = 0; k < count; k++)
    {
      gs_chunk c;
      if (gs_read_chunk (folder, names[k], &c, why) != 0)
        {
          snprintf (path, sizeof path, "%.3800s/%.200s", folder, names[k]);
          unlink (path);
          continue;
        }
      for (long long i = c.first; i < c.first + c.n && i < s->runs; i++)
        {
          d->left -= ! d->have[i];
          d->have[i] = 1;
        }
      gs_free_chunk (&c);
    }
  gs_free_list (names, count);
  pthread_mutex_init (&d->lock, NULL);
}

/* ---- who works: this process for itself, or for the dealer of rank 0 */

typedef struct
{
  const gs_sweep *sweep;
  const char *folder;
  int threads;
  dealer *dealer;      /* a null pointer: ask rank 0 */
} worker;

static void
ask (const worker *w, double a_run, long long chunk[2])
{
  if (w->dealer)
    deal (w->dealer, a_run, chunk);
#if defined (GS_MPI)
  else
    {
      MPI_Send (&a_run, 1, MPI_DOUBLE, 0, 1, MPI_COMM_WORLD);
      MPI_Recv (chunk, 2, MPI_LONG_LONG, 0, 2, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
#endif
}

static void *
work (void *data)
{
  const worker *w = data;
  long long chunk[2] = { 0, 0 };
  double a_run = 0;
  for (ask (w, a_run, chunk); chunk[1] > 0; ask (w, a_run, chunk))
    {
      double begin = now ();
      run_chunk (w->sweep, w->folder, w->threads, chunk[0], chunk[1]);
      a_run = (now () - begin) / (double) chunk[1];
    }
  return NULL;
}

#if defined (GS_MPI)
/* rank 0 deals while a thread of its own works */
static void
serve (dealer *d)
{
  for (int active = ranks - 1; active > 0;)
    {
      int is = 0;
      MPI_Status from;
      MPI_Iprobe (MPI_ANY_SOURCE, 1, MPI_COMM_WORLD, &is, &from);
      if (! is)
        {
          nanosleep (&(struct timespec){ 0, 200000 }, NULL);
          continue;
        }
      double a_run;
      long long chunk[2];
      MPI_Recv (&a_run, 1, MPI_DOUBLE, from.MPI_SOURCE, 1, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      deal (d, a_run, chunk);
      MPI_Send (chunk, 2, MPI_LONG_LONG, from.MPI_SOURCE, 2, MPI_COMM_WORLD);
      active -= chunk[1] == 0;
    }
}
#endif

/* ---- the folder of the chunks, and the beginning of a line that tells one sweep from another */

static void
put_text (const char *file, const char *text)
{
  char part[GS_PATH], why[GS_WHY];
  if (gs_beside (file, part, why) != 0)
    stop (why);
  FILE *f = fopen (part, "w");
  int bad = ! f || fputs (text, f) < 0;
  if (f)
    bad = fclose (f) != 0 || bad;
  if (bad)
    {
      unlink (part);
      stop ("cannot write into the folder of the chunks: is the disk full?");
    }
  if (gs_put_part (part, file, why) != 0)
    stop (why);
}

static void
open_folder (const gs_job *job, const char *folder)
{
  long long n;
  const char *text = gs_text (job, "description", &n);
  char file[PATH_MAX], why[GS_WHY];
  if (mkdir (folder, 0777) != 0 && errno != EEXIST)
    {
      snprintf (why, sizeof why, "cannot make the folder %.400s: %s", folder, strerror (errno));
      stop (why);
    }
  snprintf (file, sizeof file, "%.4000s/sweep.txt", folder);
  FILE *f = fopen (file, "r");
  if (! f)
    return put_text (file, text);
  char *there = calloc ((size_t) n + 2, 1);
  int same = there && fread (there, 1, (size_t) n + 1, f) == (size_t) n && ! strcmp (there, text);
  fclose (f);
  free (there);
  if (! same)
    {
      snprintf (why, sizeof why, "%.400s is of another sweep: delete it, or give another -o",
                folder);
      stop (why);
    }
}

static void
take_away (const char *folder)
{
  char **names, why[GS_WHY], path[PATH_MAX];
  int count;
  if (gs_list_chunks (folder, 1, &names, &count, why) != 0)
    return;
  for (int k = 0; k < count; k++)
    {
      snprintf (path, sizeof path, "%.3800s/%.200s", folder, names[k]);
      unlink (path);
    }
  gs_free_list (names, count);
  snprintf (path, sizeof path, "%.4000s/sweep.txt", folder);
  unlink (path);
  snprintf (path, sizeof path, "%.4000s/sweep.job", folder);
  unlink (path);
  rmdir (folder);
}

/* ---- */

typedef struct
{
  int threads;
  char job[PATH_MAX], file[PATH_MAX], folder[PATH_MAX + 10];
} options;

static void
read_options (options *o, int n, char **words)
{
  *o = (options){ .threads = 1 };
  ssize_t k = readlink ("/proc/self/exe", o->job, sizeof o->job - 20);
  char *slash = k > 0 ? strrchr (o->job, '/') : NULL;
  strcpy (slash ? slash + 1 : o->job, "sweep.job");
  for (int c = getopt (n, words, "t:o:"); c != -1; c = getopt (n, words, "t:o:"))
    {
      if (c == 't' && atoi (optarg) >= 1)
        o->threads = atoi (optarg);
      else if (c == 'o')
        snprintf (o->file, sizeof o->file, "%s", optarg);
      else
        stop ("expected sweep [-t THREADS] [-o FILE] [JOB]");
    }
  if (optind < n)
    snprintf (o->job, sizeof o->job, "%s", words[optind]);
  if (! o->file[0])
    {
      slash = strrchr (o->job, '/');
      snprintf (o->file, sizeof o->file, "%.*ssweep.h5", slash ? (int) (slash - o->job) + 1 : 0,
                o->job);
    }
  snprintf (o->folder, sizeof o->folder, "%s.parts", o->file);
}

/* the whole sweep, on rank 0 with the dealer */
static void
sweep (const options *o, const gs_job *job, const gs_sweep *s)
{
  worker w = { s, o->folder, o->threads, NULL };
  if (rank > 0)
    {
      work (&w);
      return;
    }
  dealer d;
  open_folder (job, o->folder);
  open_dealer (&d, s, o->folder, ranks);
  if (d.left < d.runs)
    printf ("sweep: goes on, %lld of %lld runs are there\n", d.runs - d.left, d.runs);
  fflush (stdout);
  w.dealer = &d;
#if defined (GS_MPI)
  pthread_t thread;
  if (pthread_create (&thread, NULL, work, &w) != 0)
    stop ("cannot begin a thread");
  serve (&d);
  pthread_join (thread, NULL);
#else
  work (&w);
#endif
}

static void
finish (const options *o, const gs_job *job, double begin)
{
  char why[GS_WHY] = "";
  if (gs_export_sweep (job, o->folder, o->file, why) != 0)
    stop (why);
  take_away (o->folder);
  printf ("sweep: %s, %.1f s\n", o->file, now () - begin);
}

int
main (int n, char **words)
{
  options o;
  gs_job job;
  gs_sweep s;
  char why[GS_WHY] = "";
  double begin = now ();
#if defined (GS_MPI)
  int given;
  MPI_Init_thread (&n, &words, MPI_THREAD_FUNNELED, &given);
  MPI_Comm_rank (MPI_COMM_WORLD, &rank);
  MPI_Comm_size (MPI_COMM_WORLD, &ranks);
  if (given < MPI_THREAD_FUNNELED)
    stop ("this MPI has no threads");
#endif
  read_options (&o, n, words);
  if (gs_read_job (o.job, &job, why) != 0 || gs_open_sweep (&s, &job, why) != 0)
    stop (why);
  if (access (o.file, F_OK) != 0)
    {
      sweep (&o, &job, &s);
#if defined (GS_MPI)
      MPI_Barrier (MPI_COMM_WORLD);
#endif
      if (rank == 0)
        finish (&o, &job, begin);
    }
  else if (rank == 0 && ! gs_is_table_of (&job, o.file))
    {
      snprintf (why, sizeof why, "%.400s is of another sweep: delete it, or give another -o",
                o.file);
      stop (why);
    }
  else if (rank == 0 && ! gs_is_whole_table (o.file))
    {
      snprintf (why, sizeof why, "%.400s is damaged: not all of it has its checksum; delete it to "
                "begin anew", o.file);
      stop (why);
    }
  else if (rank == 0)
    printf ("sweep: %s is there\n", o.file);
  gs_close_sweep (&s);
  gs_free_job (&job);
#if defined (GS_MPI)
  MPI_Finalize ();
#endif
  return 0;
}
