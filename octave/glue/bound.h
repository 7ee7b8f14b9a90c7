// Handles of a model: a call of the module with the model's constants, as one function of Octave.
// An anonymous function that calls the module takes three times as long.
#pragma once

#include <dlfcn.h>
#include <octave/ov-builtin.h>
#include <octave/ov-fcn-handle.h>

// of the module: what the call NAME answers
static octave_value_list answer (const std::string& name, const octave_value_list& args,
                                 int nargout);

class bound_call : public octave_builtin
{
public:

  bound_call (const std::string& name, const octave_value& constants)
    : octave_builtin (static_cast<fcn> (nullptr), name), m_constants (constants) { }

  octave_value_list execute (octave::tree_evaluator&, int nargout,
                             const octave_value_list& args) override
  {
    if (args.has_magic_colon ())
      error ("invalid use of colon in function argument list");
    octave_value_list all (args.length () + 1);
    all(0) = m_constants;
    for (octave_idx_type k = 0; k < args.length (); k++)
      all(k+1) = args(k);
    return answer (name (), all, nargout);
  }

private:

  octave_value m_constants;
};

// A handle's code must stay where it is even if Octave forgets the module: its file, whose name
// has the contents in it, is not unloaded any more.
static void
stay_loaded (void)
{
  Dl_info here;
  if (dladdr (reinterpret_cast<void *> (&stay_loaded), &here))
    dlopen (here.dli_fname, RTLD_NOW | RTLD_NOLOAD | RTLD_NODELETE);
}

// ("bound", constants, call): the handle
static octave_value_list
do_bound (const octave_value_list& args)
{
  stay_loaded ();
  const octave_value f (new bound_call (args(2).string_value (), args(1)));
  return ovl (octave_value (new octave_fcn_handle (f)));
}
