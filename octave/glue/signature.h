// What an emitted subroutine takes and gives back, read from a line of words.
#pragma once

#include "numbers.h"

// An argument of an emitted subroutine.
struct slot
{
  enum kind { real, whole, counts, modes, constants, leading, states, indicator } what;
  bool in, out, needed;
  std::string name;
  int rows, cols, room;   // numbers of the array, and places that the subroutine writes
  int low, high;          // of a whole number
};

// All of them in the order of the Fortran, the numbers of those that the handle gives back, and how
// the handle is typed, "t, q[, u]".
struct signature
{
  std::vector<slot> slots;
  std::vector<std::size_t> results;
  std::string usage;
  bool batch, tells;   // many states at once; INFO is among them
};

const std::size_t most_slots = 24;

// a size by its name in the JSON, or a number
static int
size_of (const std::string& word)
{
#define GSMBP_NAMED(size) { #size, S.size },
  static const struct { const char *name; int value; } sizes[]
      = { GSMBP_SIZES (GSMBP_NAMED)
          { "np", S.np },
          { "nbase", S.nbase },
          { "nsp", S.nsp },
          { "nilp", S.nu + 3 * S.nlam },  // rows of ILP: efforts, constraints and two rates
          { "milp", S.nq + 3 * S.nu + S.nsp },
          { "mcmj", S.nact * (S.nqj + 1) + S.nsp },
          { "nby", S.nx + S.nv + S.nsp + 1 },  // states, inputs, parameters, time
          { "norders", S.nqj + 1 },            // a motion and its derivatives
          { "nresidual", 2 * S.nlam + 4 } };   // what PRJ and CLO need to tell one
  for (const auto& entry : sizes)
    if (word == entry.name)
      return entry.value;
  return std::atoi (word.c_str ());
}

// what the arguments of that name always are
static const struct { const char *name, *rows, *meaning; } quantities[]
    = { { "t", "1", "" },
        { "q", "nq", "the coordinates" },
        { "u", "nu", "the speeds" },
        { "ud", "nu", "the accelerations" },
        { "x", "nx", "the states" },
        { "v", "nv", "the inputs" },
        { "tau", "nu", "the efforts" },
        { "xi", "na", "the internal states" },
        { "qj", "nu,norders", "the motion" },
        { "par", "npar", "the parameters" } };

static std::vector<std::string>
words (const std::string& text)
{
  std::vector<std::string> list;
  std::istringstream from (text);
  for (std::string word; from >> word; )
    list.push_back (word);
  return list;
}

// the sizes of SHAPE, "nu", "nu,nq" or "1/nresidual" (one number of so many places)
static void
shape (slot& s, std::string text)
{
  if (text.empty ())
    for (const auto& q : quantities)
      if (s.name == q.name)
        text = q.rows;
  std::size_t comma = text.find (','), slash = text.find ('/');
  s.rows = text.empty () ? 1 : size_of (text.substr (0, std::min (comma, slash)));
  s.cols = comma == std::string::npos ? 1 : size_of (text.substr (comma + 1));
  s.room = slash == std::string::npos ? s.rows * s.cols : size_of (text.substr (slash + 1));
}

// A word of a row of the table `known` (see there).
static slot
slot_of (const std::string& word)
{
  slot s = { slot::real, true, false, true, "", 1, 1, 1, 0, 0 };
  static const struct { const char *name; slot::kind what; } plain[]
      = { { "cst", slot::constants }, { "ld", slot::leading }, { "k", slot::states },
          { "info", slot::indicator } };
  for (const auto& entry : plain)
    if (word == entry.name)
      {
        s.what = entry.what;
        s.in = false;
        return s;
      }
  std::size_t begin = word.find_first_not_of ("?<>#"), end = word.find_first_of ("([");
  std::string marks = word.substr (0, begin), inside;
  if (end != std::string::npos)
    inside = word.substr (end + 1, word.size () - end - 2);
  s.name = word.substr (begin, end == std::string::npos ? end : end - begin);
  s.in = marks.find ('>') == std::string::npos;
  s.out = marks.find_first_of ("<>") != std::string::npos;
  s.needed = marks.find ('?') == std::string::npos;
  if (s.name == "mode")
    s.what = slot::modes;
  else if (word.find ('[') != std::string::npos)
    {
      s.what = slot::whole;
      s.low = size_of (inside.substr (0, inside.find (':')));
      s.high = size_of (inside.substr (inside.find (':') + 1));
    }
  else
    shape (s, inside);
  if (marks.find ('#') != std::string::npos)
    s.what = slot::counts;
  return s;
}

// what the user types: "t, q, u[, v[, tau]]"
static std::string
usage_of (const std::vector<slot>& slots)
{
  std::string text, close;
  std::size_t last = 0;
  for (std::size_t i = 0; i < slots.size (); i++)
    if (slots[i].in && slots[i].needed)
      last = i;
  for (std::size_t i = 0; i < slots.size (); i++)
    if (slots[i].in)
      {
        if (i > last)
          close += "]";
        text += (i > last ? "[" : "") + std::string (text.empty () ? "" : ", ") + slots[i].name;
      }
  return text + close;
}

// a row of the table as a signature; RESULTS: names in the order of the handle, "" for that of the
// Fortran
static signature
signature_of (const std::string& text, const std::string& results)
{
  signature g;
  g.batch = g.tells = false;
  for (const std::string& word : words (text))
    {
      slot s = slot_of (word);
      if (s.what == slot::leading && ! g.slots.empty ())
        s.rows = std::max (1, g.slots.back ().rows);
      g.batch = g.batch || s.what == slot::states;
      g.tells = g.tells || s.what == slot::indicator;
      g.slots.push_back (s);
    }
  for (std::size_t i = 0; results.empty () && i < g.slots.size (); i++)
    if (g.slots[i].out)
      g.results.push_back (i);
  for (const std::string& name : words (results))
    for (std::size_t i = 0; i < g.slots.size (); i++)
      if (g.slots[i].name == name)
        g.results.push_back (i);
  if (g.slots.size () > most_slots)
    error ("%s: a subroutine with %d arguments: expected at most %d", S.name,
           int (g.slots.size ()), int (most_slots));
  g.usage = usage_of (g.slots);
  return g;
}
