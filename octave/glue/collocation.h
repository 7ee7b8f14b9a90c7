// The program of an optimal motion (gsmbp_collocate): goal, equations, their derivatives from DAE,
// DAJ, DAH at all points, as octave/private/gsmbp__transcription.m lays them out.
#pragma once

#include "gsmbp_program.h"
#include "handles.h"
#include "parameters.h"

#include <list>

// the fields of a transcription; numbers of places begin with 0 here
class transcription
{
public:

  transcription (const octave_scalar_map& given, const reals& constants);

  bool evaluate (int part, const double *z, double factor, const double *lambda, double *out);
  int size_of (int part) const;
  int unknowns (void) const { return m_n; }
  int equations (void) const { return m_m; }

private:

  typedef std::vector<double> doubles;
  typedef std::vector<int> wholes;

  // a triplet: what G or H at a place is multiplied by
  struct triplet { double k; int from; };
  struct timed { double k; int from, phase; };
  struct crossed { double k; int from, weight; };
  struct share { int column, point; double a; };   // of a rate at a point in a defect
  // of the integrand in the unknowns of a point: a term; second derivatives by them and a duration
  struct product { int a, b; double weight; };
  struct own_curve { double k; int point; };
  struct own_cross { int unknown, point, phase; };
  struct pair { int row, column; double k; };      // of a quadratic form of the program's unknowns

  doubles numbers (const char *name) const;
  wholes places (const char *name) const;
  wholes column (const char *name, int c) const;
  int whole (const char *name) const { return m_given->contents (name).int_value (); }
  void read_layout (void);
  void read_triplets (void);
  void read_integrand (void);

  bool move_to (const double *z);
  bool take_parameters (const double *p);
  void functions (void);
  void derivatives (void);
  const number *state (int q) const { return &m_x[std::size_t (S.nx) * q]; }
  double rate (int j, int q) const;
  void sums (doubles& s) const;
  double goal (void) const;
  double whole_weight (int q) const;
  double own_integrand (int q) const;
  double own_slope (int l, int q) const;
  double *own_hessian (double factor, double *v) const;
  void gradient (double *g);
  void equations_at (double *g);
  void jacobian (double *v);
  void hessian (double factor, const double *lambda, double *v);
  void weights (double factor, const double *lambda);

  const octave_scalar_map *m_given;   // while it is read
  int K, nz, nT, np, nr, nf, nJ, nH, m_n, m_m;
  double t0, goal_time;
  doubles tau, goals, integral, final_x, final_f, fixed;
  wholes phase, rates, stages, bounded, own, left, of_defect, parameter, f_of, by, h_time;
  std::vector<triplet> plain, curved;
  std::vector<timed> by_time;
  std::vector<crossed> mixed;
  std::vector<share> shares;
  wholes crossed_speeds, gradient_of;
  doubles own_linear;                      // (nz,K)
  wholes own_unknowns;                     // those that the integrand has
  std::vector<product> own_products;
  std::vector<own_curve> own_curves;
  std::vector<own_cross> own_crosses;
  std::vector<pair> rough;                 // lower triangle; half of the form is in the goal
  wholes columns_of;                       // of the program: (time, unknowns of a point; K)

  reals m_cst, m_par;
  doubles m_z;
  bool m_has_f, m_has_g, m_good;
  reals m_t, m_x, m_ud, m_lam, m_v, F, G, H, m_w;
  doubles T, bare, speeds;
};

transcription::doubles
transcription::numbers (const char *name) const
{
  Matrix m = m_given->contents (name).matrix_value ();
  return doubles (m.data (), m.data () + m.numel ());
}

// places, which begin with 1 in Octave
transcription::wholes
transcription::places (const char *name) const
{
  wholes w;
  for (double x : numbers (name))
    w.push_back (int (x) - 1);
  return w;
}

// a column of a matrix, as it is
transcription::wholes
transcription::column (const char *name, int c) const
{
  Matrix m = m_given->contents (name).matrix_value ();
  wholes w;
  for (octave_idx_type i = 0; i < m.rows (); i++)
    w.push_back (int (m(i, c)));
  return w;
}

transcription::transcription (const octave_scalar_map& given, const reals& constants)
  : m_given (&given), m_cst (constants), m_has_f (false), m_has_g (false), m_good (false)
{
  read_layout ();
  read_triplets ();
  read_integrand ();
  m_t = room (K);
  m_x = room (S.nx * K);
  m_ud = room (S.nu * K);
  m_lam = room (S.nlam * K);
  m_v = room (S.nv * K);
  F = room (nf * K);
  G = room (nJ * K);
  H = room (nH * K);
  m_w = room (nf * K);
  T.assign (nT, 0.0);
  bare.assign (std::size_t (nf) * K * nT, 0.0);
  speeds.assign (std::size_t (S.nu) * K * nT, 0.0);
  m_given = nullptr;
}

void
transcription::read_layout (void)
{
  K = whole ("K");
  nz = whole ("nz");
  nT = whole ("nT");
  np = whole ("np");
  nr = whole ("nr");
  nf = whole ("nf");
  m_n = whole ("n");
  m_m = whole ("m");
  t0 = m_given->contents ("t0").double_value ();
  goal_time = m_given->contents ("goal_time").double_value ();
  tau = numbers ("tau");
  goals = numbers ("goal");
  integral = numbers ("weights");   // (nT,K)
  final_x = numbers ("final_x");
  final_f = numbers ("final_f");
  phase = places ("phase");
  rates = places ("rate");          // -1 where a rate is an acceleration
  stages = places ("stages");
  bounded = places ("bounded");
  own = places ("own_points");      // a point for each column of the defects
  left = places ("left_points");
  of_defect = places ("of_defect");
  parameter = places ("which");
  doubles par = numbers ("par");
  for (double p : par)
    m_par.push_back (decimal (p));
  f_of = column ("J", 0);
  by = column ("J", 1);
  nJ = int (f_of.size ());
  nH = int (column ("H", 0).size ());
  columns_of = places ("columns");
  for (int e = 0; e < nJ; e++)
    if (goals[f_of[e] - 1] != 0 || final_f[f_of[e] - 1] != 0)
      gradient_of.push_back (e);
}

void
transcription::read_triplets (void)
{
  auto of = [&] (const char *name) { return m_given->contents (name).matrix_value (); };
  Matrix a = of ("fixed"), b = of ("plain"), c = of ("timed"), d = of ("curved"),
         e = of ("crossed"), s = of ("share_list");
  wholes phases = places ("of");
  crossed_speeds = column ("crossed_speeds", 2);
  for (octave_idx_type i = 0; i < a.rows (); i++)
    fixed.push_back (a(i, 2));
  for (octave_idx_type i = 0; i < b.rows (); i++)
    plain.push_back ({ b(i, 2), int (b(i, 3)) - 1 });
  for (octave_idx_type i = 0; i < c.rows (); i++)
    by_time.push_back ({ c(i, 2), int (c(i, 3)) - 1, phases[i] });
  for (octave_idx_type i = 0; i < d.rows (); i++)
    curved.push_back ({ d(i, 2), int (d(i, 3)) - 1 });
  for (octave_idx_type i = 0; i < e.rows (); i++)
    mixed.push_back ({ e(i, 2), int (e(i, 3)) - 1, int (e(i, 4)) - 1 });
  for (octave_idx_type i = 0; i < s.rows (); i++)
    shares.push_back ({ int (s(i, 0)) - 1, int (s(i, 1)) - 1, s(i, 2) });
}

void
transcription::read_integrand (void)
{
  Matrix a = m_given->contents ("own_products").matrix_value (),
         b = m_given->contents ("own_curved").matrix_value (),
         c = m_given->contents ("own_crossed").matrix_value (),
         d = m_given->contents ("rough").matrix_value ();
  own_linear = numbers ("own_linear");
  for (octave_idx_type i = 0; i < a.rows (); i++)
    own_products.push_back ({ int (a(i, 0)) - 1, int (a(i, 1)) - 1, a(i, 2) });
  for (octave_idx_type i = 0; i < b.rows (); i++)
    own_curves.push_back ({ b(i, 2), int (b(i, 3)) - 1 });
  for (octave_idx_type i = 0; i < c.rows (); i++)
    own_crosses.push_back ({ int (c(i, 2)) - 1, int (c(i, 3)) - 1, int (c(i, 4)) - 1 });
  for (octave_idx_type i = 0; i < d.rows (); i++)
    rough.push_back ({ int (d(i, 0)) - 1, int (d(i, 1)) - 1, d(i, 2) });
  std::vector<bool> used (nz, false);
  for (const own_cross& one : own_crosses)
    used[one.unknown] = true;
  for (int l = 0; l < nz; l++)
    if (used[l])
      own_unknowns.push_back (l);
}

int
transcription::size_of (int part) const
{
  switch (part)
    {
    case GSMBP_GOAL: return 1;
    case GSMBP_GRADIENT: return m_n;
    case GSMBP_EQUATIONS: return m_m;
    case GSMBP_FUNCTIONS: return nf * K;
    case GSMBP_JACOBIAN:
      return int (fixed.size () + plain.size () + by_time.size () + S.nx * own.size ());
    default: return int (curved.size () + mixed.size () + crossed_speeds.size ()
                         + own_curves.size () + own_crosses.size () + rough.size ());
    }
}

// the constants of other parameters
bool
transcription::take_parameters (const double *p)
{
  if (np == 0)
    return true;
  int info = 0;
  reals par = m_par;
  for (int k = 0; k < np; k++)
    par[parameter[k]] = p[k];
  routine ("pre") (&par[0], &m_cst[0], &info);
  return info == 0;
}

// the point taken apart, once
bool
transcription::move_to (const double *z)
{
  if (m_z.size () == std::size_t (m_n) && std::equal (m_z.begin (), m_z.end (), z))
    return m_good;
  m_z.assign (z, z + m_n);
  m_has_f = m_has_g = false;
  const double *durations = z + std::size_t (K) * nz;
  std::copy (durations, durations + nT, T.begin ());
  doubles before (nT, t0);
  for (int k = 1; k < nT; k++)
    before[k] = before[k - 1] + T[k - 1];
  for (int q = 0; q < K; q++, z += nz)
    {
      m_t[q] = before[phase[q]] + T[phase[q]] * tau[q];
      std::copy (z, z + S.nx, &m_x[std::size_t (S.nx) * q]);
      std::copy (z + S.nx, z + S.nx + S.nu, &m_ud[std::size_t (S.nu) * q]);
      std::copy (z + S.nx + S.nu, z + S.nx + S.nu + S.nlam, &m_lam[std::size_t (S.nlam) * q]);
      std::copy (z + nz - S.nv, z + nz, &m_v[std::size_t (S.nv) * q]);
    }
  m_good = take_parameters (durations + nT);
  return m_good;
}

void
transcription::functions (void)
{
  if (m_has_f)
    return;
  const fortran f = routine ("dae");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &F[nf * q]);
  m_has_f = true;
}

void
transcription::derivatives (void)
{
  functions ();
  if (m_has_g)
    return;
  const fortran f = routine ("daj");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &G[nJ * q]);
  m_has_g = true;
}

// of state J at the point Q
double
transcription::rate (int j, int q) const
{
  return double (rates[j] >= 0 ? F[nf * q + rates[j]] : m_ud[S.nu * q + j - S.nq]);
}

// of each defect what stands by its duration, a column each
void
transcription::sums (doubles& s) const
{
  s.assign (S.nx * own.size (), 0.0);
  for (const share& one : shares)
    for (int j = 0; j < S.nx; j++)
      s[S.nx * one.column + j] += one.a * rate (j, one.point);
}

// of the integral at the point Q, with the durations
double
transcription::whole_weight (int q) const
{
  double whole = 0;
  for (int p = 0; p < nT; p++)
    whole += T[p] * integral[nT * q + p];
  return whole;
}

// what the goal integrates of the unknowns of the point Q; its derivative by the unknown L
double
transcription::own_integrand (int q) const
{
  const double *z = &m_z[std::size_t (nz) * q], *k = &own_linear[std::size_t (nz) * q];
  double sum = 0;
  for (int l : own_unknowns)
    sum += k[l] * z[l];
  for (const product& one : own_products)
    sum += one.weight * z[one.a] * z[one.b];
  return sum;
}

double
transcription::own_slope (int l, int q) const
{
  const double *z = &m_z[std::size_t (nz) * q];
  double sum = own_linear[std::size_t (nz) * q + l];
  for (const product& one : own_products)
    sum += one.weight * ((one.a == l ? z[one.b] : 0) + (one.b == l ? z[one.a] : 0));
  return sum;
}

double *
transcription::own_hessian (double factor, double *v) const
{
  for (const own_curve& one : own_curves)
    *v++ = factor * one.k * whole_weight (one.point);
  for (const own_cross& one : own_crosses)
    *v++ = factor * integral[nT * one.point + one.phase] * own_slope (one.unknown, one.point);
  for (const pair& one : rough)
    *v++ = factor * one.k;
  return v;
}

double
transcription::goal (void) const
{
  double sum = 0;
  for (double t : T)
    sum += goal_time * t;
  if (! own_unknowns.empty ())
    for (int q = 0; q < K; q++)
      sum += whole_weight (q) * own_integrand (q);
  for (int q = 0; q < K; q++)
    for (int i = 0; i < nf; i++)
      if (goals[i] != 0)
        for (int p = 0; p < nT; p++)
          sum += T[p] * integral[nT * q + p] * goals[i] * double (F[nf * q + i]);
  for (int i = 0; i < nf; i++)
    sum += final_f[i] * double (F[nf * (K - 1) + i]);
  for (int j = 0; j < S.nx; j++)
    sum += final_x[j] * double (state (K - 1)[j]);
  for (const pair& one : rough)
    sum += (one.row == one.column ? 0.5 : 1) * one.k * m_z[one.row] * m_z[one.column];
  return sum;
}

void
transcription::gradient (double *g)
{
  derivatives ();
  std::fill (g, g + m_n, 0.0);
  double *durations = g + std::size_t (K) * nz;
  for (int q = 0; q < K; q++)
    {
      const double whole = whole_weight (q);
      double here = own_unknowns.empty () ? 0 : own_integrand (q);
      for (int l : own_unknowns)
        g[std::size_t (nz) * q + l] += whole * own_slope (l, q);
      for (int e : gradient_of)
        {
          const double at_end = q == K - 1 ? final_f[f_of[e] - 1] : 0;
          g[columns_of[(1 + nz + np) * q + by[e] - 1]]
              += double (G[nJ * q + e]) * (by[e] == 1 ? tau[q] : 1)
                 * (goals[f_of[e] - 1] * whole + at_end);
        }
      for (int i = 0; i < nf; i++)
        here += goals[i] * double (F[nf * q + i]);
      for (int p = 0; p < nT; p++)
        durations[p] += integral[nT * q + p] * here;
    }
  for (int p = 0; p < nT; p++)
    durations[p] += goal_time;
  for (int j = 0; j < S.nx; j++)
    g[std::size_t (K - 1) * nz + j] += final_x[j];
  for (const pair& one : rough)
    {
      g[one.row] += one.k * m_z[one.column];
      if (one.row != one.column)
        g[one.column] += one.k * m_z[one.row];
    }
}

void
transcription::equations_at (double *g)
{
  for (int q : stages)
    for (int i = 0; i < nr; i++)
      *g++ = double (F[nf * q + i]);
  for (int q : stages)
    for (int i : bounded)
      *g++ = double (F[nf * q + i]);
  doubles s;
  sums (s);
  for (std::size_t k = 0; k < own.size (); k++)
    for (int j = 0; j < S.nx; j++)
      *g++ = double (state (own[k])[j] - state (left[k])[j]) + T[of_defect[k]] * s[S.nx * k + j];
}

void
transcription::jacobian (double *v)
{
  derivatives ();
  v = std::copy (fixed.begin (), fixed.end (), v);
  for (const triplet& one : plain)
    *v++ = one.k * double (G[one.from]);
  for (const timed& one : by_time)
    *v++ = T[one.phase] * one.k * (one.from >= 0 ? double (G[one.from]) : 1);
  doubles s;
  sums (s);
  std::copy (s.begin (), s.end (), v);
}

// of the functions: of the rates by the multipliers of the defects, of the goal; BARE and SPEEDS
// without the durations, an array for each phase
void
transcription::weights (double factor, const double *lambda)
{
  const double *defect = lambda + m_m - S.nx * own.size ();
  std::fill (bare.begin (), bare.end (), 0.0);
  std::fill (speeds.begin (), speeds.end (), 0.0);
  for (int p = 0; p < nT; p++)
    for (int q = 0; q < K; q++)
      for (int i = 0; i < nf; i++)
        bare[(std::size_t (p) * K + q) * nf + i] = factor * goals[i] * integral[nT * q + p];
  for (const share& one : shares)
    {
      std::size_t at = std::size_t (of_defect[one.column]) * K + one.point;
      for (int j = 0; j < S.nx; j++)
        {
          double w = one.a * defect[S.nx * one.column + j];
          if (rates[j] >= 0)
            bare[at * nf + rates[j]] += w;
          else
            speeds[at * S.nu + j - S.nq] += w;
        }
    }
  for (std::size_t i = 0; i < m_w.size (); i++)
    m_w[i] = 0;
  for (int p = 0; p < nT; p++)
    for (std::size_t i = 0; i < std::size_t (nf) * K; i++)
      m_w[i] += T[p] * bare[std::size_t (p) * nf * K + i];
  for (int i = 0; i < nf; i++)
    m_w[nf * (K - 1) + i] += factor * final_f[i];
  for (int q : stages)
    for (int i = 0; i < nr; i++)
      m_w[nf * q + i] += *lambda++;
  for (int q : stages)
    for (int i : bounded)
      m_w[nf * q + i] += *lambda++;
}

void
transcription::hessian (double factor, const double *lambda, double *v)
{
  derivatives ();
  weights (factor, lambda);
  const fortran f = routine ("dah");
  for (int q = 0; q < K; q++)
    f (&m_t[q], state (q), &m_ud[S.nu * q], &m_lam[S.nlam * q], &m_v[S.nv * q], &m_cst[0],
       &m_w[nf * q], &H[nH * q]);
  for (const triplet& one : curved)
    *v++ = one.k * double (H[one.from]);
  for (const crossed& one : mixed)
    *v++ = one.k * double (G[one.from]) * bare[one.weight];
  for (int at : crossed_speeds)
    *v++ = speeds[at - 1];
  own_hessian (factor, v);
}

bool
transcription::evaluate (int part, const double *z, double factor, const double *lambda,
                         double *out)
{
  if (! move_to (z))
    return false;
  functions ();
  switch (part)
    {
    case GSMBP_GOAL: *out = goal (); break;
    case GSMBP_GRADIENT: gradient (out); break;
    case GSMBP_EQUATIONS: equations_at (out); break;
    case GSMBP_JACOBIAN: jacobian (out); break;
    case GSMBP_HESSIAN: hessian (factor, lambda, out); break;
    default: std::copy (F.begin (), F.begin () + std::size_t (nf) * K, out);
    }
  return true;
}

// ------------------------------------------------------------
// those that are kept, the last ones; by the numbers that they were given

struct kept_program
{
  int number;
  transcription t;
  gsmbp_program program;
};

static std::list<kept_program> the_programs;

extern "C" int
gsmbp_evaluate_program (void *data, int part, const double *z, double factor,
                        const double *lambda, double *out)
{
  return static_cast<transcription *> (data)->evaluate (part, z, factor, lambda, out);
}

// (constants, transcription): the number of the program
static octave_value_list
do_program (arguments& a, int)
{
  const int most = 20;
  static int count = 0;
  const reals cst = a.constants ();
  the_programs.push_back ({ ++count,
                            transcription (a.value ("program").scalar_map_value (), cst),
                            gsmbp_program () });
  kept_program& k = the_programs.back ();
  k.program.data = &k.t;
  k.program.evaluate = gsmbp_evaluate_program;
  if (the_programs.size () > most)
    the_programs.pop_front ();
  return ovl (count);
}

static kept_program&
program_of (arguments& a)
{
  const int number = a.integer_within ("program", 1, 2000000000);
  for (kept_program& k : the_programs)
    if (k.number == number)
      return k;
  error ("%s: there is no program %d any more", a.who ().c_str (), number);
}

// (number): where the program stands, for gsmbp_ipopt_solve
static octave_value_list
do_program_at (arguments& a, int)
{
  uint64NDArray at (dim_vector (1, 1));
  at(0) = octave_uint64 (reinterpret_cast<std::uintptr_t> (&program_of (a).program));
  return ovl (at);
}

// (number, part, point, factor, multipliers): its numbers
static octave_value_list
do_program_part (arguments& a, int)
{
  transcription& t = program_of (a).t;
  const int part = a.integer_within ("part", GSMBP_GOAL, GSMBP_FUNCTIONS);
  Matrix z = a.matrix ("point", t.unknowns (), 1);
  const double factor = double (a.scalar ("factor"));
  Matrix lambda = a.matrix ("multipliers", part == GSMBP_HESSIAN ? t.equations () : -1, 1);
  Matrix out (t.size_of (part), 1, no_number);
  if (! t.evaluate (part, z.data (), factor, lambda.data (), out.fortran_vec ()))
    out.fill (no_number);
  return ovl (out);
}

// (number, repetitions, point, multipliers): the least seconds that all parts take at a new point
static octave_value_list
do_program_time (arguments& a, int)
{
  transcription& t = program_of (a).t;
  const int repetitions = a.integer_within ("repetitions", 1, 1000000);
  Matrix z = a.matrix ("point", t.unknowns (), 1), lambda = a.matrix ("multipliers",
                                                                     t.equations (), 1);
  std::vector<double> out (std::max (t.size_of (GSMBP_JACOBIAN),
                                     std::max (t.size_of (GSMBP_HESSIAN), t.unknowns ())));
  double least = 1e300;
  for (int k = 0; k < repetitions; k++)
    {
      z(0) += 1e-3;
      auto begin = std::chrono::steady_clock::now ();
      for (int part = GSMBP_GOAL; part <= GSMBP_HESSIAN; part++)
        t.evaluate (part, z.data (), 1, lambda.data (), out.data ());
      least = std::min (least, std::chrono::duration<double> (std::chrono::steady_clock::now ()
                                                             - begin).count ());
    }
  return ovl (least);
}
