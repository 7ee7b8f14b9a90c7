/* driver: calls of compiled equations of motion, ours and the rivals', on the same states: their
   time or their values.

   driver STATES N JOBS time ROUNDS     on each line the ns of one call, a number for each round;
   the jobs take turns within a round driver STATES N JOBS values OUT      OUT: the results of all
   calls, job by job, doubles

   STATES: doubles q, v, a, tau of N each, state after state. A line of JOBS: the library (- for the
   yardstick), the file for its init (-: none), the function, how many doubles it returns. Functions
   are f(q, v, x, out), x = tau where the name begins with fd, else a; names that end in _v are
   batches, f(states, q, v, x, out) with arrays of states x N, the state running first; `sincos`
   with a count m is a loop of m sines and m cosines.       */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef void (*single)(const double *, const double *, const double *, double *);
typedef void (*batch)(int, const double *, const double *, const double *, double *);
struct job { void *f; char name[64]; int outputs, is_batch; long calls; };

static double *states, *columns, *out, sum;
static int n, count;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void fail(const char *what, const char *which) {
  fprintf(stderr, "driver: %s %s\n", what, which);
  exit(1);
}

/* where the third argument of a job stands: 3 tau, 2 a */
static int third(const struct job *j) { return strncmp(j->name, "fd", 2) ? 2 : 3; }

static void call(const struct job *j, int k, double *o) {
  const double *x = states + 4L * n * k;
  ((single)j->f)(x, x + n, x + third(j) * n, o);
}

static void call_batch(const struct job *j, double *o) {
  const double *x = columns;
  long size = (long)n * count;
  ((batch)j->f)(count, x, x + size, x + third(j) * size, o);
}

/* the yardstick: the angles are those of the states */
static void sines(int m) {
  for (int k = 0; k < count; k++)
    for (int i = 0; i < m; i++) { double x = states[4L * n * k + i % n]; sum += sin(x) + cos(x); }
}

/* seconds of CALLS passes over all states */
static double passes(const struct job *j, long calls) {
  double start = now();
  for (long c = 0; c < calls; c++) {
    if (!j->f) sines(j->outputs);
    else if (j->is_batch) call_batch(j, out);
    else for (int k = 0; k < count; k++) call(j, k, out);
    sum += out[0];
  }
  return now() - start;
}

static void read_states(const char *name) {
  FILE *file = fopen(name, "rb");
  if (!file) fail("cannot read", name);
  fseek(file, 0, SEEK_END);
  long size = ftell(file) / 8;
  rewind(file);
  count = size / (4 * n);
  states = malloc(size * 8);
  columns = aligned_alloc(64, (size * 8 + 63) / 64 * 64);
  if (fread(states, 8, size, file) != (size_t)size) fail("cannot read", name);
  fclose(file);
  for (int k = 0; k < count; k++)
    for (int i = 0; i < 4 * n; i++) columns[(long)i * count + k] = states[4L * n * k + i];
}

static int read_jobs(const char *name, struct job *jobs, int most) {
  FILE *file = fopen(name, "r");
  char library[4096], start[4096];
  int number = 0, size = 4 * n;
  if (!file) fail("cannot read", name);
  for (struct job *j = jobs; number < most && fscanf(file, "%4095s %4095s %63s %d", library, start,
                                                     j->name, &j->outputs) == 4;
       j++, number++) {
    if (j->outputs > size) size = j->outputs;
    if (!strcmp(library, "-")) continue;
    void *h = dlopen(library, RTLD_NOW);
    if (!h) fail("cannot open", dlerror());
    void (*init)(const char *) = (void (*)(const char *))dlsym(h, "init");
    if (strcmp(start, "-") && init) init(start);
    j->is_batch = strlen(j->name) > 2 && !strcmp(j->name + strlen(j->name) - 2, "_v");
    j->f = dlsym(h, j->name);
    if (!j->f) fail("no such function:", j->name);
  }
  fclose(file);
  out = aligned_alloc(64, ((size_t)size * count * 8 + 63) / 64 * 64);
  memset(out, 0, (size_t)size * count * 8);
  return number;
}

static void time_jobs(struct job *jobs, int number, int rounds) {
  double *ns = malloc(sizeof(double) * number * rounds);
  for (int k = 0; k < number; k++) {
    double t = passes(jobs + k, jobs[k].calls = 1);
    while (t < 5e-4) t = passes(jobs + k, jobs[k].calls *= 2);
  }
  for (int r = 0; r < rounds; r++)
    for (int k = 0; k < number; k++)
      ns[k * rounds + r] = 1e9 * passes(jobs + k, jobs[k].calls) / jobs[k].calls / count;
  for (int k = 0; k < number; k++)
    for (int r = 0; r < rounds; r++)
      printf(r + 1 < rounds ? "%.4g " : "%.4g\n", ns[k * rounds + r]);
}

static void write_values(struct job *jobs, int number, const char *name) {
  FILE *file = fopen(name, "wb");
  if (!file) fail("cannot write", name);
  for (struct job *j = jobs; j < jobs + number; j++) {
    if (j->is_batch) {
      call_batch(j, out);
      for (int k = 0; k < count; k++)
        for (int i = 0; i < j->outputs; i++) fwrite(out + (long)i * count + k, 8, 1, file);
    } else for (int k = 0; k < count; k++) { call(j, k, out); fwrite(out, 8, j->outputs, file); }
  }
  fclose(file);
}

int main(int arguments, char **v) {
  static struct job jobs[200];
  if (arguments != 6) fail("wants", "STATES N JOBS time|values ROUNDS|OUT");
  n = atoi(v[2]);
  read_states(v[1]);
  int number = read_jobs(v[3], jobs, 200);
  if (!strcmp(v[4], "time")) time_jobs(jobs, number, atoi(v[5]));
  else write_values(jobs, number, v[5]);
  fprintf(stderr, "%g\n", sum);
  return 0;
}
