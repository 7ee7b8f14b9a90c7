/* Many runs on threads. */
#include "host/ensemble/ensemble.h"

#include <pthread.h>
#include <stdlib.h>

#include "host/ensemble/row_groups.h"
#include "host/lanes/lanes.h"

/* what the threads share */
typedef struct
{
  const gs_ensemble *e;
  const gs_rows *rows;
  gs_row_groups *groups;
  gs_take_member *take;
  void *to;
  void (*progress) (void *asked, int done);
  int done, failed;       /* rows that were taken; 1: no memory */
  int most;               /* rows of a thread, where all have as many */
  pthread_mutex_t lock;   /* of done and failed */
} ensemble;

/* a thread's */
typedef struct
{
  ensemble *all;
  int number;
  gs_real *cst;           /* ncst: of the next row */
} worker;

int
gs_ensemble_in_lanes (const gs_ensemble *e)
{
#if defined (GSMBP_QUAD) || defined (GSMBP_FLOAT)
  (void)e;
  return 0;
#else
  /* else the right side would be that of one run */
  const int loops = e->scene->nlam == 0 || e->run.iopt[GS_LOOPS] <= 2;
  return e->lanes && e->lanes->rhs && e->run.iopt[GS_METHOD] != 0 && loops
         && e->run.nx == e->scene->nx;
#endif
}

/* a run has ended */
static void
finish (void *data, gs_member *m)
{
  ensemble *all = ((worker *)data)->all;
  const gs_ensemble *e = all->e;
  all->take (all->to, e, m);
  pthread_mutex_lock (&all->lock);
  all->done++;
  if (all->progress)
    all->progress (e->run.asked, all->done);
  pthread_mutex_unlock (&all->lock);
}

/* the next run that does not end at its start; 0: there is none */
static int
begin_next (void *data, gs_member *m)
{
  worker *w = data;
  const ensemble *all = w->all;
  gs_known_row row;
  while (gs_next_row (all->groups, w->number, w->cst, &row))
    {
      if (gs_begin_member (all->e, all->rows, &row, m))
        return 1;
      finish (w, m);
    }
  return 0;
}

/* one run after the other; 0, or there is no memory */
static int
one_by_one (worker *w)
{
  gs_member m;
  if (gs_make_member (w->all->e, &m) != 0)
    return GS_OUT_OF_MEMORY;
  while (begin_next (w, &m))
    {
      gs_run_member (w->all->e, &m);
      finish (w, &m);
    }
  gs_free_member (&m);
  return 0;
}

static void *
work (void *data)
{
  worker *w = data;
  ensemble *all = w->all;
  w->cst = malloc (((size_t)all->e->ncst + 1) * sizeof (gs_real));
  int failed = w->cst == NULL;
#if ! defined (GSMBP_QUAD) && ! defined (GSMBP_FLOAT)
  const gs_lane_source source = { w, begin_next, finish };
  if (! failed && gs_ensemble_in_lanes (all->e))
    failed = gs_run_lanes (all->e, &source, all->most);
  else
#endif
  if (! failed)
    failed = one_by_one (w);
  free (w->cst);
  if (failed)
    {
      gs_stop_rows (all->groups);
      pthread_mutex_lock (&all->lock);
      all->failed = 1;
      pthread_mutex_unlock (&all->lock);
    }
  return NULL;
}

/* by the calling thread and as many others as there can be */
static void
run_threads (worker *workers, int threads)
{
  pthread_t *others = malloc ((size_t)threads * sizeof (pthread_t));
  int begun = 1;
  for (; others && begun < threads; begun++)
    if (pthread_create (&others[begun], NULL, work, &workers[begun]) != 0)
      break;
  work (&workers[0]);
  for (int k = 1; k < begun && others; k++)
    pthread_join (others[k], NULL);
  free (others);
}

int
gs_run_ensemble (const gs_ensemble *e, const gs_rows *rows, int threads, gs_take_member *take,
                 void *to, void (*progress) (void *asked, int done))
{
  if (rows->n < 1)
    return 0;
  threads = threads < 1 ? 1 : threads < rows->n ? threads : rows->n;
  ensemble all = { .e = e, .rows = rows, .take = take, .to = to, .progress = progress,
                   .most = (rows->n - 1) / threads + 1 };
  worker *workers = calloc ((size_t)threads, sizeof *workers);
  all.groups = workers ? gs_open_rows (e, rows, threads) : NULL;
  if (! all.groups)
    {
      free (workers);
      return GS_OUT_OF_MEMORY;
    }
  for (int k = 0; k < threads; k++)
    workers[k] = (worker){ .all = &all, .number = k };
  pthread_mutex_init (&all.lock, NULL);
  run_threads (workers, threads);
  pthread_mutex_destroy (&all.lock);
  gs_close_rows (all.groups);
  free (workers);
  return all.failed ? GS_OUT_OF_MEMORY : 0;
}
