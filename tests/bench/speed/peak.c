/* peak.c: what a core does at most, and sines and angles one by one and at once, behind the
   interface of driver.c. fma_one and fma_many: 10240 multiplications and additions, in ten chains
   that do not wait for one another, by single numbers and by the widest vectors. The others: eight
   angles. */
#include <math.h>
#if defined __AVX512F__
enum { WIDTH = 8 };
#elif defined __AVX__
enum { WIDTH = 4 };
#else
enum { WIDTH = 2 };
#endif
enum { CHAINS = 10, TURNS = 512 };
typedef double many __attribute__((vector_size(8 * WIDTH)));

void gssc_(const double *, double *, double *),
    gsscv_(const int *, const double *, double *, double *),
    gsatv_(const int *, const double *, const double *, double *);
static const int one = 1;

#define CHAIN(type, name, first, width)                                                           \
  void name(const double *q, const double *v, const double *x, double *o) {                       \
    const type m = first(1 - 1e-9 * q[0]), a = first(1e-9 * v[0]);                                \
    type s[CHAINS];                                                                               \
    for (int k = 0; k < CHAINS; k++) s[k] = first(x[0] + k);                                      \
    for (int turn = 0; turn < TURNS / width; turn++)                                              \
      for (int k = 0; k < CHAINS; k++) s[k] = s[k] * m + a;                                       \
    for (int k = 1; k < CHAINS; k++) s[0] += s[k];                                                \
    o[0] = last(s[0]);                                                                            \
  }
#define plain(x) (x)
#define all(x) ((many){0} + (x))
#define last(x) (x)
CHAIN(double, fma_one, plain, 1)
#undef last
#define last(x) ((x)[0] + (x)[1])
CHAIN(many, fma_many, all, WIDTH)

/* given once: a vector that is read behind single stores waits for them */
static double angle[8] = { .1, .8, -1.5, 2.2, 2.9, -3.6, 4.3, 5.0 };
static double side[8] = { 1, -1, 2, 1, -3, 1, 1, 2 }, s[8], c[8];

void gssc_eight(const double *q, const double *v, const double *x, double *o) {
  for (int k = 0; k < 8; k++) gssc_(angle + k, s + k, c + k);
  *o = s[0] + c[7];
}
void gsscv_eight(const double *q, const double *v, const double *x, double *o) {
  gsscv_(&one, angle, s, c);
  *o = s[0] + c[7];
}
void atan2_eight(const double *q, const double *v, const double *x, double *o) {
  for (int k = 0; k < 8; k++) s[k] = atan2(angle[k], side[k]);
  *o = s[0] + s[7];
}
void gsatv_eight(const double *q, const double *v, const double *x, double *o) {
  gsatv_(&one, angle, side, s);
  *o = s[0] + s[7];
}
