// The handles of a scene: the table of the subroutines that gsmbp_fortran knows, those that the
// JSON tells, and why one is not there.
#pragma once

#include "host/failure.h"
#include "info.h"
#include "signature.h"

static std::string
upper (std::string text)
{
  for (char& c : text)
    c = char (std::toupper (static_cast<unsigned char> (c)));
  return text;
}

// why the scene has not what is asked for by a request; or how to have it
static std::string
left_out (const char *request)
{
  std::string all = S.left_out, head = std::string ("\n") + request + ": ";
  std::size_t at = all.find (head), from = at + head.size ();
  if (at != std::string::npos)
    {
      std::string reason = all.substr (from, all.find ('\n', from) - from);
      if (reason.find ("made on request") == std::string::npos)
        return reason;
    }
  return std::string ("derive it with the request ") + request + " of gsmbp_fortran";
}

static std::string
reason_of (const std::string& call, const char *request)
{
  auto is = [&] (const char *calls)
    { return std::strstr (calls, (" " + call + " ").c_str ()) != nullptr; };
  if (S.nlam == 0 && is (" con inl clo acc acd tan cop "))
    return "it has no loops";
  if (S.nlam == 0 && S.nq == S.nu && is (" prj "))
    return "it has neither loops nor Euler parameters";
  if (S.nctl == 0 && is (" ctl ctp "))
    return "it has no sampled devices";
  if (S.nev == 0 && is (" evt hld rst evp "))
    return "it has no events";
  if (S.nsm == 0 && is (" mar "))
    return "no device of it has a margin that its state decides";
  if (S.nlam == 0 && is (" ind red jpi "))
    return "it has no loops";
  if (S.ny == 0 && is (" out oup "))
    return "it has no outputs";
  return left_out (request);
}

static void
absent (const std::string& call, const char *request)
{
  error_with_id ("gsmbp:absent", "%s.%s: the scene was emitted without the subroutine %s: %s",
                 S.name, call.c_str (), upper (call).c_str (),
                 reason_of (call, request).c_str ());
}

// The emitted subroutines that gsmbp_fortran knows: end of the name, what it is asked for by, the
// arguments in the order of the Fortran:
//   q         read, of the shape of `quantities`; q(nq), m(nu,nu): of this one
//   ?v        may be left out, then zero
//   >tau(nu)  a result; <x: read and a result; >res(1/n): one number, n places to work in
//   way[1:4]  a whole number from 1 to 4; >#br(8): whole numbers; mode: the modes
//   cst, ld, k, info: the constants, the leading dimension of the array before it (of all arrays,
//             behind k, the number of states), the number of states, the indicator
// and the results in the order of the handle where that is another.  A subroutine that is not here
// has its arguments from the JSON (gs.model.routine_signature.m); the table says what that does
// not.  What
// nobody asks for (PRE) is no handle.
struct known_routine { const char *name, *request, *slots, *results; };
static const char jacobian_slots[]
    = "t x ?v cst >a(nx,nx) ld >b(nx,nv) ld >c(ny,nx) ld >d(ny,nv) ld info";
static const known_routine known[]
    = {
        { "rhs", "rhs", "t x ?v cst >xd(nx) info", "" },
        { "inv", "inverse", "t q u ud ?v cst >tau", "" },
        { "fwd", "forward", "t q u ?v ?tau cst >ud info", "" },
        { "mas", "mass", "t q cst >m(nu,nu) ld", "" },
        { "rhp", "sensitivity",
          "t x ?v cst >p(nx,nsp) ld >a(nx,nx) ld >b(nx,nv) ld >xd(nx) info", "" },
        { "adj", "adjoint", "t x v cst l(nx) >xb(nx) >vb(nv) >pb(nsp) info", "" },
        { "inp", "sensitivity", "t q u ud ?v cst >p(nu,nsp) ld", "" },
        { "ilp", "sensitivity",
          "t q u ud v cst taua(nact) lam(nlam) >d(nilp,milp) ld", "" },
        { "cop", "sensitivity", "t x cst >pp(nlam,nsp) ld >pv(nlam,nsp) ld", "" },
        { "oup", "sensitivity", "t x ?v cst >p(ny,nsp) ld info", "" },
        { "reg", "regressor", "t q u ud ?v cst >y(nu,nbase) ld >p(nbase) >r(nu)", "" },
        { "bia", "bias", "t q u ?v cst >b(nu)", "" },
        { "kin", "kinematics", "t q u cst >qdot(nq)", "" },
        { "con", "constraints",
          "t q ?u cst >phi(nlam) >phit(nlam) >hc(nlam,nu) ld >gam(nlam) info", "" },
        { "inl", "inverse_loops", "t q u ud ?v cst >tau(nact) >lam(nlam) info", "" },
        { "lin", "linear", "t q u ud ?v cst >m(nu,nu) >b(nu,nu) >c(nu,nq) ld", "" },
        { "prj", "projection", "t <x cst >res(1/nresidual) info", "" },
        { "jac", "jacobian", jacobian_slots, "" },
        { "jad", "jacobian_dense", jacobian_slots, "" },
        { "out", "output", "t x ?v cst >y(ny) info", "" },
        { "cmd", "command", "t qj ?xi cst >v >xid(na) info", "" },
        { "cmx", "command_states", "t qj ?xi cst >v >xid(na) >xa(na) >g(nmar) info", "" },
        { "cmp", "sensitivity", "t qj ?xi cst >vx(nv,na) ld >vp(nv,nsp) ld info", "" },
        { "cmj", "sensitivity", "t qj ?xi cst >vj(nv,mcmj) ld >xj(na,mcmj) ld info", "" },
        { "ctl", "control", "k[0:nctl] t y(ny) <xk(nxk) cst ?<v", "v xk" },
        { "ctp", "control", "cst >period(nctl) >delay(nctl)", "" },
        { "evt", "events", "t x v mode cst >g(nev)", "" },
        { "evp", "sensitivity", "t x v mode k[1:nev] cst >g(nby) info", "" },
        { "hld", "events", "t x ?v cst >row(nev,nu) ld >s(nev) >sd(nev) >prm(4,nev)", "" },
        { "rst", "events", "t <x <v <mode k[-1:nev] cst info", "x mode v" },
        { "clo", "closure", "t <qj cst >res(1/nresidual) info", "" },
        { "ene", "energy", "t x ?v cst >e(ne)", "" },
        { "acc", "accelerations", "t x ?v cst >ud >lam(nlam) info", "" },
        { "acd", "dense", "t x ?v cst way[1:4] >ud >lam(nlam) info", "" },
        { "tan", "tangent", "t x cst >dp(nlam,nq) ld >dv(nlam,nq) ld", "" },
        { "mar", "margins", "t x ?v cst >g(nsm) >sizes(nsm)", "" },
        { "swi", "switches", "cst >ts(nsw)", "" },
        { "ske", "skeleton", "t q cst >p(3,np)", "" },
        { "inv_v", "batch", "t q u ud ?v cst >tau k ld", "" },
        { "mas_v", "batch", "t q cst >m(nu,nu) k ld", "" },
        { "bia_v", "batch", "t q u ?v cst >b(nu) k ld", "" },
        { "fwd_v", "batch", "t q u ?v ?tau cst >ud info k ld", "" },
        { "rhs_v", "batch", "t x ?v cst >xd(nx) info k ld", "" },
        { "gra", "gravity", "", "" },       // these have their arguments from the JSON
        { "cor", "coriolis", "", "" },
        { "pnt", "points", "", "" },
        { "jpt", "point_jacobians", "", "" },
        { "pnj", "pose_jacobians", "", "" },
        { "pnr", "pose_rates", "", "" },
        { "ind", "independent", "", "" },
        { "red", "reduced", "", "" },
        { "jpi", "independent_jacobians", "", "" },
        { "pnt_v", "batch", "", "" },
        { "jpt_v", "batch", "", "" },
        { "rhs_w", "", "", "" },            // runs in lanes call them
        { "con_w", "", "", "" },
        { "prj_w", "", "", "" },
        { "evt_w", "", "", "" },
        { "pre_w", "", "", "" },
        { "pre", "", "par cst info", "" }
      };

static const known_routine *
known_by (const std::string& name)
{
  for (const known_routine& row : known)
    if (name == row.name)
      return &row;
  return nullptr;
}

// why a subroutine that is needed was not emitted, or how to have it
static std::string
why_absent (const std::string& name)
{
  if (name == "vin")
    return "the model was built without option \"input\" of gsmbp_build";
  const known_routine *row = known_by (name);
  if (! row || ! row->request[0])
    return "the scene was emitted without the subroutine " + upper (name);
  return "the scene was emitted without the subroutine " + upper (name) + ": "
         + reason_of (name, row->request);
}

// ... as its handle says it
static void
absent_routine (const std::string& name)
{
  error_with_id ("gsmbp:absent", "%s.%s: %s", S.name, name.c_str (), why_absent (name).c_str ());
}

// A handle of gsmbp_build.
struct handle
{
  std::string name;
  const known_routine *row;   // a null pointer where the JSON alone knows it
  const gsmbp_routine *code;  // a null pointer where it was not emitted
  signature g;

  bool asked_for (void) const { return ! row || row->request[0]; }
};

static handle
handle_of (const std::string& name, const known_routine *row, const gsmbp_routine *code)
{
  std::string slots = row ? row->slots : "";
  if (slots.empty () && code)
    slots = code->arguments;
  return handle { name, row, code, signature_of (slots, row ? row->results : "") };
}

// those of the table, and what else was emitted whose arguments the JSON tells
static const std::vector<handle>&
handles (void)
{
  static std::vector<handle> list;
  if (list.empty ())
    {
      for (const known_routine& row : known)
        list.push_back (handle_of (row.name, &row, emitted (row.name)));
      for (const gsmbp_routine *r = S.routines; r->name; r++)
        if (r->arguments[0] && ! known_by (r->name))
          list.push_back (handle_of (r->name, nullptr, r));
    }
  return list;
}

// the names of the handles that a user may call
static octave_value_list
do_calls (arguments&, int)
{
  string_vector names;
  for (const handle& h : handles ())
    if (h.asked_for () && (! h.g.usage.empty () || ! h.code || h.name == "swi"))
      names.append (h.name);
  return octave_value (Cell (names));
}

// the k-th argument of an emitted subroutine, as its handle calls it
static std::string
fortran_argument (const std::string& call, int k)
{
  for (const handle& h : handles ())
    if (call == h.name && k <= int (h.g.slots.size ()) && h.g.slots[k-1].in)
      {
        std::string name = h.g.slots[k-1].name;
        for (const auto& q : quantities)
          if (name == q.name && *q.meaning)
            return "argument " + name + " (" + q.meaning + ")";
        return "argument " + name;
      }
  return "argument " + std::to_string (k) + " of the Fortran subroutine";
}

// The error indicators of the emitted subroutines as sentences, those of the JSON (also for
// gsmbp_simulate and others, by the call "meaning"): of the greatest number that is not above.
static std::string
meaning (const std::string& call, int info)
{
  if (info == 0)
    return "ok";
  if (info < 0)
    return fortran_argument (call, -info) + " is out of range or not finite";
  const char *found = gsmbp_meaning_of (call.c_str (), info);
  return found ? found
               : "no sentence for this number: see ERROR INDICATOR in the head of the subroutine";
}

static octave_value_list
do_meaning (arguments& a, int)
{
  std::string call = a.value ("subroutine").string_value ();
  return ovl (meaning (call, a.integers ("info", 1)[0]));
}
