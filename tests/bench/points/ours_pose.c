/* ours_pose.c: the emitted routines of points behind the interface of ../speed/driver.c, for a
   chain of N joints with one frame; -DNAME=puma3 -DN=3. pj: PNJ; pjd: PNR; both: PNT and JPT, one
   after the other. */
#define GLUE(name, word) name##_##word##_
#define PASTE(name, word) GLUE(name, word)
#define F(word) PASTE(NAME, word)
void F(par)(double *), F(pre)(const double *, double *, int *),
    F(pnt)(const double *, const double *, const double *, double *, double *),
    F(jpt)(const double *, const double *, const double *, const double *, double *, double *),
    F(pnj)(const double *, const double *, const double *, double *, double *, double *),
    F(pnr)(const double *, const double *, const double *, const double *, double *, double *,
           double *, double *);
static const double t = 0;
static double cst[4096];

void init(const char *unused) {
  double par[1024];
  int info;
  F(par)(par);
  F(pre)(par, cst, &info);
}
void pj(const double *q, const double *v, const double *a, double *o) {
  F(pnj)(&t, q, cst, o, o + 3, o + 12);
}
void pjd(const double *q, const double *v, const double *a, double *o) {
  F(pnr)(&t, q, v, cst, o, o + 3, o + 12, o + 12 + 6 * N);
}
void both(const double *q, const double *v, const double *a, double *o) {
  F(pnt)(&t, q, cst, o, o + 3);
  F(jpt)(&t, q, v, cst, o + 12, o + 12 + 6 * N);
}
