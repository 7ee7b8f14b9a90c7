// What the error indicators of the emitted subroutines say, and to whom.
#pragma once

#include "arguments.h"

static std::string meaning (const std::string& call, int info);

// Lost rank is a warning where it is not so everywhere; where the derivation did not find that the
// scene has redundant constraints it is shown once per model.
static bool the_rank_said = false, the_rank_full = false;

static void
say_rank (const char *call)
{
  if ((the_rank_said || S.redundant > 0) && ! the_rank_full)
    return;
  the_rank_said = true;
  warning_with_id (
      "gsmbp:rank", "%s.%s: INFO = 2: %s%s", S.name, call, meaning (call, 2).c_str (),
      the_rank_full ? "" : "; this is said once a model: gsmbp_mobility tells which ones are");
}

// INFO becomes the output after the others if the caller takes it; otherwise
// an error, but for lost rank (2), whose results are usable, a warning.
static void
finish (octave_value_list& out, int info, int nargout, const char *call)
{
  int place = out.length ();
  if (info == 0 && S.nlam > 0
      && std::strstr (" rhs acc acd ", (" " + std::string (call) + " ").c_str ()))
    the_rank_full = true;
  // what is out of reach, or singular, is an answer of inverse kinematics
  bool answer = info > 0 && std::strstr (" ikn nik ", (" " + std::string (call) + " ").c_str ());
  if (nargout <= place && info != 0 && ! answer)
    {
      if (info == 2
          && std::strstr (" rhs acc acd out jac evt rst prj con ",
                          (" " + std::string (call) + " ").c_str ()))
        say_rank (call);
      else
        error_with_id ("gsmbp:info", "%s.%s: INFO = %d: %s", S.name, call, info,
                       meaning (call, info).c_str ());
    }
  out.append (octave_value (info));
}
