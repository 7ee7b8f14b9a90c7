/* mujoco_steps model.xml start.txt integrator steps: T seconds by mj_step, prints the least seconds
   of many runs and the coordinates at the end. A loop is as stiff as its step allows. */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

int main(int count, char **word) {
  char error[500];
  double end, q[64], v[64], least = 1e9;
  if (count != 5) return 1;
  mjModel *m = mj_loadXML(word[1], NULL, error, sizeof error);
  if (!m) { fprintf(stderr, "%s\n", error); return 1; }
  mjData *d = mj_makeData(m);
  FILE *file = fopen(word[2], "r");
  if (!file || fscanf(file, "%lf", &end) != 1) return 1;
  for (int i = 0; i < 2 * m->nv; i++)
    if (fscanf(file, "%lf", i < m->nv ? q + i : v + i - m->nv) != 1) return 1;
  const long steps = atol(word[4]);
  m->opt.integrator = atoi(word[3]);
  m->opt.timestep = end / steps;
  if (m->neq) m->eq_solref[0] = 2 * m->opt.timestep;
  const double start = now();
  for (int run = 0; run < 200 && now() - start < 0.1; run++) {
    mj_resetData(m, d);
    mju_copy(d->qpos, q, m->nv);
    mju_copy(d->qvel, v, m->nv);
    const double begun = now();
    for (long k = 0; k < steps; k++) mj_step(m, d);
    least = mju_min(least, now() - begun);
  }
  printf("%.9g", least);
  for (int i = 0; i < m->nq; i++) printf(" %.17g", d->qpos[i]);
  puts("");
  return 0;
}
