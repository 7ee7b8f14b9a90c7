/* eliminate_lay.c: which unknowns and equations are left, and where their derivatives are. */
#include "host/collocation/eliminate_parts.h"

#include <math.h>

/* the block of an entry of the Jacobian; -1: it stays as it is */
static int
block_of (const gs_rest_program *e, int k)
{
  const int ruler = e->ruler[e->p->jac_rows[k]];
  return ruler >= 0 ? ruler : e->owner[e->p->jac_columns[k]];
}
static int
block_of_second (const gs_rest_program *e, int k)
{
  const int owner = e->owner[e->p->hess_rows[k]];
  return owner >= 0 ? owner : e->owner[e->p->hess_columns[k]];
}

/* entries 0 to n - 1 by their blocks: list; those of block b from first[b] on (count + 2) */
static void
sort_entries (const gs_rest_program *e, int n, int (*of) (const gs_rest_program *, int), int *first,
              int *list)
{
  for (int b = 0; b <= e->d.count + 1; b++)
    first[b] = 0;
  for (int k = 0; k < n; k++)
    first[of (e, k) + 2]++;   /* those that stay first */
  for (int b = 0; b <= e->d.count; b++)
    first[b + 1] += first[b];
  for (int k = 0; k < n; k++)
    list[first[of (e, k) + 1]++] = k;
  for (int b = e->d.count + 1; b > 0; b--)
    first[b] = first[b - 1];
  first[0] = 0;
}

/* blocks of unknowns without bounds */
static int
number_all (gs_rest_program *e)
{
  const gs_nlp *p = e->p;
  for (int k = 0; k < p->n; k++)
    e->owner[k] = -1;
  for (int k = 0; k < p->m; k++)
    e->ruler[k] = -1;
  for (int b = 0; b < e->d.count; b++)
    for (int i = 0; i < e->d.size; i++)
      {
        const int k = gs_unknown_of (e, b) + i, row = gs_equation_of (e, b) + i;
        if (p->low[k] > -1e19 || p->high[k] < 1e19 || p->glow[row] < 0 || p->ghigh[row] > 0)
          return 0;
        e->owner[k] = b;
        e->ruler[row] = b;
      }
  for (int k = 0; k < p->n; k++)
    e->column[k] = e->owner[k] < 0 ? e->n++ : -1;
  for (int k = 0; k < p->m; k++)
    e->row[k] = e->ruler[k] < 0 ? e->m++ : -1;
  return 1;
}

/* others and pairs of block b from the entries list (n) of the Jacobian; seen: where an unknown or
 * n of p + a row was met last, at least 0; 0: an unknown of another block */
static int
lay_block (gs_rest_program *e, int b, int n, const int *list, int *seen, int *nothers)
{
  const gs_nlp *p = e->p;
  e->begins[b] = *nothers;
  for (int a = 0; a < n; a++)
    {
      const int k = list[a], row = p->jac_rows[k], column = p->jac_columns[k];
      const int own = e->owner[column] == b;
      if (e->ruler[row] >= 0 && e->owner[column] >= 0 && ! own)
        return 0;
      if (own && e->ruler[row] == b)
        continue;
      int *place = seen + (own ? p->n + row : column);
      if (*place < (own ? 0 : e->begins[b]) || (own && e->pair_block[*place] != b))
        {
          *place = own ? e->npairs++ : (*nothers)++;
          if (own)
            {
              e->pair_row[*place] = e->row[row];
              e->pair_block[*place] = b;
            }
          else
            e->others[*place] = column;
        }
      e->jac_place[k] = *place;
    }
  e->seconds[b] = *nothers;
  return 1;
}

/* what second derivatives have together with the unknowns of block b; 0: unknowns of another one */
static int
lay_second (gs_rest_program *e, int b, int n, const int *list, int *seen, int *nothers)
{
  const gs_nlp *p = e->p;
  for (int a = 0; a < n; a++)
    for (int side = 0; side < 2; side++)
      {
        const int k = list[a], column = (side ? p->hess_columns : p->hess_rows)[k];
        int *place = e->hess_place + 2 * k + side;
        if (e->owner[column] == b)
          {
            *place = column - gs_unknown_of (e, b);
            continue;
          }
        if (e->owner[column] >= 0)
          return 0;
        if (seen[column] < e->begins[b])
          {
            seen[column] = (*nothers)++;
            e->others[seen[column]] = column;
          }
        *place = e->d.size + seen[column] - e->begins[b];
      }
  e->hessian += (*nothers - e->begins[b]) * (*nothers - e->begins[b] + 1) / 2;
  return 1;
}

static int
lay_blocks (gs_rest_program *e, const int *first, const int *list, const int *first_second,
            const int *list_second, int *seen)
{
  int nothers = 0;
  e->nseconds = 0;
  for (int k = 0; k < e->p->n + e->p->m; k++)
    seen[k] = -1;
  for (int b = 0; b < e->d.count; b++)
    {
      if (! lay_block (e, b, first[b + 2] - first[b + 1], list + first[b + 1], seen, &nothers)
          || ! lay_second (e, b, first_second[b + 2] - first_second[b + 1],
                           list_second + first_second[b + 1], seen, &nothers))
        return 0;
      for (int k = first_second[b + 1]; k < first_second[b + 2]; k++)
        {
          e->second_block[e->nseconds] = b;
          e->second_list[e->nseconds++] = list_second[k];
        }
    }
  e->begins[e->d.count] = nothers;
  e->jacobian = first[1];
  for (int k = 0; k < e->npairs; k++)
    e->jacobian += e->seconds[e->pair_block[k]] - e->begins[e->pair_block[k]];
  e->hessian += first_second[1];
  return 1;
}

static void
take_room (gs_rest_program *e)
{
  gs_room *r = &e->room;
  const gs_nlp *p = e->p;
  const ptrdiff_t second = p->hessian > 0 ? p->hessian : 0, blocks = e->d.count;
  e->column = gs_room_places (r, p->n);
  e->row = gs_room_places (r, p->m);
  e->owner = gs_room_places (r, p->n);
  e->ruler = gs_room_places (r, p->m);
  e->others = gs_room_places (r, p->jacobian + 2 * second);
  e->begins = gs_room_places (r, blocks + 1);
  e->seconds = gs_room_places (r, blocks);
  e->pair_row = gs_room_places (r, p->jacobian);
  e->pair_block = gs_room_places (r, p->jacobian);
  e->jac_place = gs_room_places (r, p->jacobian);
  e->hess_place = gs_room_places (r, 2 * second);
  e->second_list = gs_room_places (r, second);
  e->second_block = gs_room_places (r, second);
  e->x = gs_room_numbers (r, p->n);
  e->z = gs_room_numbers (r, p->n);
  e->g = gs_room_numbers (r, p->m);
  e->jac = gs_room_numbers (r, p->jacobian);
  e->hess = gs_room_numbers (r, second);
  e->gradient = gs_room_numbers (r, p->n);
  e->lambda = gs_room_numbers (r, p->m);
  e->inverse = gs_room_reals (r, blocks * e->d.size * e->d.size);
  e->unit = gs_room_reals (r, e->d.size * e->d.size);
}

/* what depends on how many others there are */
static void
take_more (gs_rest_program *e)
{
  const ptrdiff_t size = e->d.size;
  ptrdiff_t most = 0;
  for (int b = 0; b < e->d.count; b++)
    if (e->begins[b + 1] - e->begins[b] > most)
      most = e->begins[b + 1] - e->begins[b];
  e->pairs = gs_room_numbers (&e->room, size * e->npairs);
  e->slopes = gs_room_numbers (&e->room, size * e->begins[e->d.count]);
  e->square = gs_room_numbers (&e->room, (size + most) * (size + most));
  e->work = gs_room_numbers (&e->room, (size + most) * (size + most));
}

int
gs_rest_lay (gs_rest_program *e)
{
  const gs_nlp *p = e->p;
  const int second = p->hessian > 0 ? p->hessian : 0;
  take_room (e);
  int *first = gs_room_places (&e->room, e->d.count + 2);
  int *first_second = gs_room_places (&e->room, e->d.count + 2);
  int *list = gs_room_places (&e->room, p->jacobian), *more = gs_room_places (&e->room, second);
  int *seen = gs_room_places (&e->room, p->n + p->m);
  if (e->room.full || ! number_all (e))
    return 0;
  for (int k = 0; k < p->jacobian; k++)
    e->jac_place[k] = -1;
  for (int k = 0; k < 2 * second; k++)
    e->hess_place[k] = -1;
  sort_entries (e, p->jacobian, block_of, first, list);
  sort_entries (e, second, block_of_second, first_second, more);
  if (! lay_blocks (e, first, list, first_second, more, seen))
    return 0;
  if (p->hessian < 0)
    e->hessian = p->hessian;
  take_more (e);
  return ! e->room.full;
}

static void
put_lower (int a, int b, int k, int *rows, int *columns)
{
  rows[k] = a > b ? a : b;
  columns[k] = a > b ? b : a;
}

void
gs_rest_places (const gs_rest_program *e, int part, int *rows, int *columns)
{
  const gs_nlp *p = e->p;
  int n = 0;
  if (part == GS_JACOBIAN)
    {
      for (int k = 0; k < p->jacobian; k++)
        if (block_of (e, k) < 0)
          {
            rows[n] = e->row[p->jac_rows[k]];
            columns[n++] = e->column[p->jac_columns[k]];
          }
      for (int k = 0; k < e->npairs; k++)
        for (int j = e->begins[e->pair_block[k]]; j < e->seconds[e->pair_block[k]]; j++)
          {
            rows[n] = e->pair_row[k];
            columns[n++] = e->column[e->others[j]];
          }
      return;
    }
  for (int k = 0; k < p->hessian; k++)
    if (block_of_second (e, k) < 0)
      put_lower (e->column[p->hess_rows[k]], e->column[p->hess_columns[k]], n++, rows, columns);
  for (int b = 0; b < e->d.count; b++)
    for (int i = e->begins[b]; i < e->begins[b + 1]; i++)
      for (int j = e->begins[b]; j <= i; j++)
        put_lower (e->column[e->others[i]], e->column[e->others[j]], n++, rows, columns);
}
