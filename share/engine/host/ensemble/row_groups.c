/* Which thread makes which row, and constants of GS_LANES rows at once. */
#include "host/ensemble/row_groups.h"

#include <pthread.h>
#include <stdlib.h>

#include "gsmbp/arith.h"

/* the rows of a thread */
typedef struct
{
  int left;            /* rows that nobody has taken; -1: their constants are not known yet */
  int size, first;
  int info[GS_LANES];  /* of pre */
  gs_real *par, *cst;  /* (GS_LANES,npar), (GS_LANES,ncst) */
} row_group;

struct gs_row_groups
{
  const gs_ensemble *e;
  const gs_rows *rows;
  int threads, most;        /* most: rows of a group */
  int next;                 /* the first row that no group has */
  int at_once;              /* constants are computed for groups */
  row_group *groups;
  gs_real *room;
  pthread_mutex_t lock;     /* of all this */
  pthread_cond_t known;     /* constants of a group */
};

/* are constants computed for GS_LANES rows at once? */
static int
computes_groups (const gs_ensemble *e, const gs_rows *rows)
{
  return gs_ensemble_in_lanes (e) && e->lanes->pre && rows->table.x;
}

gs_row_groups *
gs_open_rows (const gs_ensemble *e, const gs_rows *rows, int threads)
{
  gs_row_groups *all = calloc (1, sizeof *all);
  if (! all)
    return NULL;
  const size_t one = (size_t)GS_LANES * (size_t)(e->npar + e->ncst);
  all->e = e;
  all->rows = rows;
  all->threads = threads;
  all->most = gs_least ((rows->n - 1) / threads + 1, GS_LANES);
  all->at_once = computes_groups (e, rows);
  all->groups = calloc ((size_t)threads, sizeof (row_group));
  all->room = all->at_once ? calloc (one * (size_t)threads + 1, sizeof (gs_real)) : NULL;
  if (! all->groups || (all->at_once && ! all->room))
    {
      free (all->groups);
      free (all->room);
      free (all);
      return NULL;
    }
  for (int k = 0; k < threads && all->at_once; k++)
    {
      row_group *g = &all->groups[k];
      g->par = all->room + one * (size_t)k;
      g->cst = g->par + GS_LANES * e->npar;
      for (int i = 0; i < e->npar; i++)
        for (int l = 0; l < GS_LANES; l++)
          g->par[GS_LANES * i + l] = rows->par[i];
    }
  pthread_mutex_init (&all->lock, NULL);
  pthread_cond_init (&all->known, NULL);
  return all;
}

void
gs_close_rows (gs_row_groups *all)
{
  pthread_mutex_destroy (&all->lock);
  pthread_cond_destroy (&all->known);
  free (all->groups);
  free (all->room);
  free (all);
}

void
gs_stop_rows (gs_row_groups *all)
{
  pthread_mutex_lock (&all->lock);
  all->next = all->rows->n;
  pthread_mutex_unlock (&all->lock);
}

#if ! defined (GSMBP_QUAD) && ! defined (GSMBP_FLOAT)
/* Always GS_LANES sets of parameters, so that the bits of a run are those of any group: the first
 * row is in the lanes after the last one. What the routine over lanes leaves is done by pre. */
static void
compute_constants (const gs_row_groups *all, row_group *g)
{
  const gs_ensemble *e = all->e;
  const gs_rows *rows = all->rows;
  const int n = GS_LANES;
  for (int k = 0; k < rows->varied; k++)
    for (int l = 0; l < n; l++)
      {
        const ptrdiff_t i = g->first + (l < g->size ? l : 0);
        g->par[n * (rows->which[k] - 1) + l]
          = rows->table.x[i * rows->table.row + k * rows->table.column];
      }
  e->lanes->pre (g->par, g->cst, g->info, &n, &n);
  for (int l = 0; l < g->size; l++)
    if (g->info[l] != 0)
      {
        double par[e->npar + 1], cst[e->ncst + 1];
        for (int k = 0; k < e->npar; k++)
          par[k] = g->par[n * k + l];
        g->info[l] = e->pre (par, cst);
        for (int k = 0; k < e->ncst && g->info[l] == 0; k++)
          g->cst[n * k + l] = cst[k];
      }
}
#else
static void
compute_constants (const gs_row_groups *all, row_group *g)
{
  (void)all, (void)g;
}
#endif

/* the next row of a group, its place in it; the lock is held */
static int
take (gs_row_groups *all, row_group *g, int *place)
{
  while (g->left < 0)
    pthread_cond_wait (&all->known, &all->lock);
  if (g->left == 0)
    return 0;
  *place = g->size - g->left--;
  return 1;
}

/* the next rows become those of a group; the lock is held, and released meanwhile */
static int
fill (gs_row_groups *all, row_group *g)
{
  const int size = gs_least (all->most, all->rows->n - all->next);
  if (size <= 0)
    return 0;
  g->left = -1;
  g->first = all->next;
  g->size = size;
  all->next += size;
  pthread_mutex_unlock (&all->lock);
  compute_constants (all, g);
  pthread_mutex_lock (&all->lock);
  g->left = size;
  pthread_cond_broadcast (&all->known);
  return 1;
}

/* the next row of a thread and the group that it is of, a null pointer where there is none */
static row_group *
next_of_groups (gs_row_groups *all, int thread, int *place)
{
  row_group *own = &all->groups[thread];
  if (take (all, own, place) || (fill (all, own) && take (all, own, place)))
    return own;
  for (int k = 0; k < all->threads; k++)
    if (take (all, &all->groups[k], place))
      return &all->groups[k];
  return NULL;
}

/* A row of the group of another thread is taken only where no group gets new rows: its constants
 * stay as they are. */
int
gs_next_row (gs_row_groups *all, int thread, gs_real *cst, gs_known_row *row)
{
  int place = 0;
  pthread_mutex_lock (&all->lock);
  const row_group *g = all->at_once ? next_of_groups (all, thread, &place) : NULL;
  const int first = g ? g->first + place : all->next;
  const int is = g || (! all->at_once && first < all->rows->n);
  all->next += is && ! g;
  pthread_mutex_unlock (&all->lock);
  *row = (gs_known_row){ first, NULL, 0 };
  for (int k = 0; g && k < all->e->ncst; k++)
    cst[k] = g->cst[GS_LANES * k + place];
  if (g)
    *row = (gs_known_row){ first, cst, g->info[place] };
  return is;
}
