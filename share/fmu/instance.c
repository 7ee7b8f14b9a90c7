/* instance.c: one instance of the FMU: its memory, its start, what it says, saved states.
 *
 * All that changes lies in the two arrays of its run, so that a saved state is a copy of them. */
#include "fmu.h"

#include "gsmbp/inputs.h"
#include "gsmbp/integrate.h"
#include "gsmbp/partition.h"
#include "host/failure.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------ variables */

int
gsf_ns (const gsf_model *m)
{
  return m->nsq + m->nsu + m->scene->nx - m->scene->nq - m->scene->nu;
}

int
gsf_nz (const gsf_model *m)
{
  return m->scene->nev + (m->scene->nlam > 0) + (m->nsets > 0);
}

int
gsf_count (const gsf_model *m, int block)
{
  const gs_scene *s = m->scene;
  int chosen = s->nlam > 0 ? (m->nsq < s->nq ? m->nsq : 0) + m->nsu : 0;
  const int counts[GSF_BLOCKS] = {
    [GSF_TIME] = 1, [GSF_PARAMETER] = m->npar, [GSF_INPUT] = m->nin, [GSF_STATE] = s->nx,
    [GSF_CHOSEN] = chosen, [GSF_RATE] = gsf_ns (m), [GSF_OUTPUT] = s->ny, [GSF_MODE] = m->nports,
    [GSF_HELD] = s->nheld, [GSF_MEMORY] = s->nxk, [GSF_PLACE] = chosen, [GSF_TALLY] = m->nown,
    [GSF_WHEN] = m->nown, [GSF_OVERRIDDEN] = m->nswitched, [GSF_USED] = m->nswitched,
    [GSF_INDICATOR] = gsf_nz (m)
  };
  return counts[block];
}

int
gsf_first (const gsf_model *m, int block)
{
  int first = 0;
  for (int k = 0; k < block; k++)
    first += gsf_count (m, k);
  return first;
}

int
gsf_locate (const gsf_model *m, unsigned reference, int *place)
{
  for (int block = 0; block < GSF_BLOCKS; block++)
    {
      const unsigned n = (unsigned)gsf_count (m, block);
      if (reference < n)
        {
          *place = (int)reference;
          return block;
        }
      reference -= n;
    }
  return GSF_BLOCKS;
}

/* --------------------------------------------------------------------------------------- memory */

int
gsf_partition_size (const gs_scene *s)
{
  return s->nlam > 0 ? 24 + 8 * s->nu + 10 * s->nq + 7 * s->nlam + 2 * s->nlam * s->nu : 0;
}

/* parts of the FMU among what the run saves */
static void
divide (gsf_instance *a)
{
  const gsf_model *m = a->m;
  const gs_scene *s = m->scene;
  a->d = a->run.own;
  a->par = a->d + GSF_NUMBERS;
  a->memory = a->par + m->npar;
  a->xs = a->memory + s->nxk;
  a->xr = a->xs + s->nx;
  a->z = a->xr + s->nx;
  a->level = a->z + gsf_ns (m);
  a->size = a->level + s->nev;
  a->p = a->size + s->nev;
  a->i = a->run.own_wholes;
  a->set = a->i + GSF_WHOLES;
  a->place = a->set + s->nx;
  a->passed = a->place + gsf_ns (m);
  a->phase = a->passed + m->nmargins;
  a->low = a->phase + s->nev;
  a->t = a->run.clock + GS_STEP_NOW;
  a->cst = a->run.r.cst;
  a->x = a->run.x;
  a->v = a->run.v;
  a->w = a->run.w;
}

static int
numbers (const gsf_model *m)
{
  const gs_scene *s = m->scene;
  return GSF_NUMBERS + m->npar + s->nxk + 2 * s->nx + gsf_ns (m) + 2 * s->nev
         + gsf_partition_size (s);
}

static int
wholes (const gsf_model *m)
{
  return GSF_WHOLES + m->scene->nx + gsf_ns (m) + m->nmargins + 2 * m->scene->nev;
}

/* memory and the method of the run; 0: no memory */
static int
make_room (gsf_instance *a)
{
  const gs_scene *s = a->m->scene;
  a->run.o = gs_default_options ();
  a->run.o.method = a->m->method;
  a->run.o.maxsteps = GSF_MOST_STEPS;
  a->run.o.project = 1;
  if (! gsf_describe (a) || gs_step_open (&a->run, &a->about, numbers (a->m), wholes (a->m)))
    return 0;
  a->kept = malloc (gsf_bytes (a));
  a->xd = calloc ((size_t)(2 * s->nx + s->ny + 2 * s->nev + 3), sizeof (double));
  return a->kept && a->xd;
}

gsf_instance *
gsf_new (const gsf_model *m, int kind)
{
  const gs_scene *s = m->scene;
  gsf_instance *a = calloc (1, sizeof *a);
  if (! a)
    return NULL;
  a->m = m;
  if (! make_room (a))
    {
      gsf_free (a);
      return NULL;
    }
  divide (a);
  a->y = a->xd + s->nx;
  a->g = a->y + s->ny + 1;
  a->xout = a->g + s->nev;
  a->i[GSF_KIND] = kind;
  gsf_reset (a);
  return a;
}

void
gsf_free (gsf_instance *a)
{
  if (! a)
    return;
  gs_step_close (&a->run);
  free (a->kept);
  free (a->xd);
  free (a->events);
  free (a->event_text);
  free (a);
}

void
gsf_reset (gsf_instance *a)
{
  const int kind = a->i[GSF_KIND];
  a->shown = 0;
  memset (a->run.numbers, 0, a->run.nnumbers * sizeof (double));
  memset (a->run.wholes, 0, a->run.nwholes * sizeof (int));
  a->known = 0;
  a->i[GSF_KIND] = kind;
  a->i[GSF_PHASE] = GSF_MADE;
  a->i[GSF_STALE] = 1;
  a->d[GSF_T1] = 1e300;
  a->d[GSF_TOLERANCE] = 1e-10;
  a->d[GSF_T_NEXT] = 2e300;
  a->d[GSF_T_SWITCH] = 2e300;
  a->m->par (a->par);
  a->m->start (a->par, a->xs);
  gs_copy (a->m->scene->nx, a->xs, a->x);
  if (a->m->scene->nxk > 0)
    gs_copy (a->m->scene->nxk, a->m->scene->memory, a->memory);
}

void
gsf_terminate (gsf_instance *a)
{
  gsf_hide_samples (a);
  a->i[GSF_PHASE] = GSF_DONE;
}

/* ------------------------------------------------------------------------------ what goes wrong */

const char *const gsf_category[]
    = { "", "logStatusWarning", "logStatusDiscard", "logStatusError" };

int
gsf_fail (gsf_instance *a, int status, const char *format, ...)
{
  va_list more;
  va_start (more, format);
  vsnprintf (a->text, sizeof a->text, format, more);
  va_end (more);
  return status;
}

const char *
gsf_meaning (const char *routine, int info)
{
  const gsf_model *m = &gsf_the_model;
  for (int k = 0; k < m->ninfos; k++)
    if (m->infos[k].info == info && strcmp (m->infos[k].routine, routine) == 0)
      return m->infos[k].text;
  return NULL;
}

int
gsf_run_says (gsf_instance *a)
{
  return gsf_fail (a, GSF_ERROR, "%s", a->run.r.text);
}

int
gsf_failed (gsf_instance *a, int status, int routine, int info)
{
  int istat[GS_COUNTED] = { 0 };
  istat[GS_FAILED] = routine;
  istat[GS_FAILED_INFO] = info;
  gs_failure (&(gs_failed_run){ .d = &a->about, .info = GS_ROUTINE_FAILED, .istat = istat,
                                .t = *a->t },
              a->text, sizeof a->text);
  return status;
}

static const char *
phase_name (int phase)
{
  switch (phase)
    {
    case GSF_MADE:
      return "instantiated";
    case GSF_INIT:
      return "initialization mode";
    case GSF_EVENT:
      return "event mode";
    case GSF_CONTINUOUS:
      return "continuous-time mode";
    case GSF_STEP:
      return "step mode";
    default:
      return "terminated";
    }
}

int
gsf_allowed (gsf_instance *a, const char *function, int kinds, int phases)
{
  if (! (kinds & (1 << a->i[GSF_KIND])))
    return gsf_fail (a, GSF_ERROR, "%s belongs to the other kind of FMU", function);
  if (a->i[GSF_PHASE] & phases)
    return GSF_OK;
  return gsf_fail (a, GSF_ERROR, "%s is not allowed here: the instance (%s) is in the state %s",
                   function, a->i[GSF_KIND] == GSF_EXCHANGE ? "model exchange" : "co-simulation",
                   phase_name (a->i[GSF_PHASE]));
}

/* null pointers where n values are expected */
int
gsf_given (gsf_instance *a, const char *function, size_t n, const void *first, const void *second)
{
  if (n == 0 || (first && second))
    return GSF_OK;
  return gsf_fail (a, GSF_ERROR, "%s: a null pointer where %lu values are expected", function,
                   (unsigned long)n);
}

/* n values, where there must be another number of them */
int
gsf_as_many (gsf_instance *a, const char *function, size_t n, size_t expected)
{
  if (n == expected)
    return GSF_OK;
  return gsf_fail (a, GSF_ERROR, "%s: expected %lu values, found %lu", function,
                   (unsigned long)expected, (unsigned long)n);
}

/* --------------------------------------------------------------------------------- saved states */

/* ahead of the two arrays in a saved state; sum: of its bytes, 0 while it is no text of bytes */
typedef struct
{
  char token[64];
  size_t nd, ni, kind;
  uint64_t sum;
} header;

/* the checksum FNV-1a of the bytes behind the header */
static uint64_t
sum_of (const char *state, size_t n)
{
  uint64_t sum = 14695981039346656037u;
  for (size_t k = sizeof (header); k < n; k++)
    sum = (sum ^ (unsigned char)state[k]) * 1099511628211u;
  return sum;
}

static header
header_of (const gsf_instance *a)
{
  header h;
  memset (&h, 0, sizeof h);
  strncpy (h.token, a->m->token, sizeof h.token - 1);
  h.nd = a->run.nnumbers;
  h.ni = a->run.nwholes;
  h.kind = (size_t)a->i[GSF_KIND];
  return h;
}

size_t
gsf_bytes (const gsf_instance *a)
{
  return sizeof (header) + a->run.nnumbers * sizeof (double) + a->run.nwholes * sizeof (int);
}

void *
gsf_save (gsf_instance *a, void *old)
{
  header h = header_of (a);
  char *b = old ? old : malloc (gsf_bytes (a));
  if (! b)
    return NULL;
  gsf_hide_samples (a);
  memcpy (b, &h, sizeof h);
  memcpy (b + sizeof h, a->run.numbers, a->run.nnumbers * sizeof (double));
  memcpy (b + sizeof h + a->run.nnumbers * sizeof (double), a->run.wholes,
          a->run.nwholes * sizeof (int));
  return b;
}

static int
is_ours (const gsf_instance *a, const void *state)
{
  header h = header_of (a);
  return state && memcmp (state, &h, sizeof h) == 0;
}

int
gsf_restore (gsf_instance *a, const void *state)
{
  if (! is_ours (a, state))
    return gsf_fail (a, GSF_ERROR, "expected a state saved by an instance of this FMU and kind");
  const char *b = (const char *)state + sizeof (header);
  a->shown = 0;
  memcpy (a->run.numbers, b, a->run.nnumbers * sizeof (double));
  memcpy (a->run.wholes, b + a->run.nnumbers * sizeof (double), a->run.nwholes * sizeof (int));
  a->known = 0;
  return GSF_OK;
}

int
gsf_serialize (gsf_instance *a, const void *state, void *bytes, size_t n)
{
  if (! is_ours (a, state))
    return gsf_fail (a, GSF_ERROR, "expected a state saved by an instance of this FMU and kind");
  if (! bytes || n < gsf_bytes (a))
    return gsf_fail (a, GSF_ERROR, "expected room for %lu bytes, found %lu",
                     (unsigned long)gsf_bytes (a), (unsigned long)n);
  header h = header_of (a);
  memcpy (bytes, state, gsf_bytes (a));
  h.sum = sum_of (bytes, gsf_bytes (a));
  memcpy (bytes, &h, sizeof h);
  return GSF_OK;
}

/* are these the n bytes of a state of this FMU, as they were written? */
static int
is_whole (gsf_instance *a, const void *bytes, size_t n)
{
  header h, own = header_of (a);
  if (n != gsf_bytes (a))
    return ! gsf_fail (a, GSF_ERROR, "expected the %lu bytes of a state of this FMU and kind; "
                       "found %lu", (unsigned long)gsf_bytes (a), (unsigned long)n);
  memcpy (&h, bytes, sizeof h);
  own.sum = h.sum;
  if (memcmp (&h, &own, sizeof h) != 0)
    return ! gsf_fail (a, GSF_ERROR, "expected the bytes of a state of this FMU and kind; found "
                       "those of another, or damaged ones");
  if (h.sum != sum_of (bytes, n))
    return ! gsf_fail (a, GSF_ERROR, "the bytes of the state are damaged: their checksum does not "
                       "fit");
  return 1;
}

void *
gsf_deserialize (gsf_instance *a, const void *bytes, size_t n, void *old)
{
  if (! is_whole (a, bytes, n))
    return NULL;
  char *b = old ? old : malloc (n);
  if (! b)
    {
      gsf_fail (a, GSF_ERROR, "out of memory");
      return NULL;
    }
  const header h = header_of (a);
  memcpy (b, bytes, n);
  memcpy (b, &h, sizeof h);
  return b;
}
