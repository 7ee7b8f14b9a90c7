// The program of an optimal motion (gsmbp_collocate) as
// octave/+gs/+collocation/transcribe_problem.m lays
// it out: what it is made of, and a point taken apart.
#pragma once

#include "gsmbp_program.h"
#include "handles.h"
#include "parameters.h"

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
