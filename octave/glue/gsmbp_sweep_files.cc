// Chunks and tables of sweeps on disk, for Octave: see sweep_files.h.
#include <octave/oct.h>

#include <string>

#include "sweep_files.h"

// rows of Octave's matrix, one run after the other
static void
write_chunk (const octave_value_list& args)
{
  std::string folder = args(1).string_value (), text = args(4).string_value ();
  Matrix rows = args(3).matrix_value ().transpose ();   // a column for each run
  gs_chunk c = { args(2).int64_scalar_value (), rows.columns (), rows.rows (),
                 static_cast<long long> (text.size ()), rows.fortran_vec (), &text[0] };
  char why[GS_WHY] = "";
  if (gs_write_chunk (folder.c_str (), &c, why) != 0)
    error ("gsmbp_sweep: %s", why);
}

// first run (from 0), rows, text; nothing where the file is not whole
static octave_value_list
read_chunk (const octave_value_list& args)
{
  std::string folder = args(1).string_value (), name = args(2).string_value ();
  gs_chunk c;
  char why[GS_WHY] = "";
  if (gs_read_chunk (folder.c_str (), name.c_str (), &c, why) != 0)
    return ovl (-1.0, Matrix (), "");
  Matrix rows (c.n, c.columns);
  for (octave_idx_type i = 0; i < c.n; i++)
    for (octave_idx_type j = 0; j < c.columns; j++)
      rows.xelem (i, j) = c.values[c.columns * i + j];
  octave_value_list out = ovl (double (c.first), rows, std::string (c.text, c.length));
  gs_free_chunk (&c);
  return out;
}

// the names of the files of chunks; what is no whole write is taken away
static octave_value
list_chunks (const octave_value_list& args)
{
  std::string folder = args(1).string_value ();
  char **names, why[GS_WHY] = "";
  int count;
  if (gs_list_chunks (folder.c_str (), 1, &names, &count, why) != 0)
    error ("gsmbp_sweep: %s", why);
  Cell list (count, 1);
  for (int i = 0; i < count; i++)
    list(i) = std::string (names[i]);
  gs_free_list (names, count);
  return list;
}

static void
export_table (const octave_value_list& args)
{
  std::string job_file = args(1).string_value (), folder = args(2).string_value (),
              file = args(3).string_value ();
  char why[GS_WHY] = "";
  gs_job job;
  int bad = gs_read_job (job_file.c_str (), &job, why)
            || gs_export_sweep (&job, folder.c_str (), file.c_str (), why);
  gs_free_job (&job);
  if (bad)
    error ("gsmbp_sweep: %s", why);
}

DEFUN_DLD (gsmbp_sweep_files, args, , "Called by gsmbp_sweep; not for direct use.")
{
  std::string what = args.length () > 0 ? args(0).string_value () : "";
  if (what == "write" && args.length () == 5)
    write_chunk (args);
  else if (what == "read" && args.length () == 3)
    return read_chunk (args);
  else if (what == "list" && args.length () == 2)
    return list_chunks (args);
  else if (what == "export" && args.length () == 4)
    export_table (args);
  else
    error ("gsmbp_sweep_files: expected write, read, list or export with their arguments");
  return octave_value_list ();
}
