## -*- texinfo -*-
## @deftypefn {} {} gsmbp_csv (@var{file}, @var{names}, @var{data})
## Write the matrix @var{data} as comma-separated values under the column heads
## @var{names} (a cell array of strings), each number with 17 digits.
##
## Written beside and then renamed, so that @var{file} is whole or not there.
## The folder is made if it does not exist.
## @seealso{gsmbp_plot}
## @end deftypefn

function gsmbp_csv (file, names, data)
  if (nargin != 3 || ! ischar (file) || ! iscellstr (names))
    print_usage ();
  endif
  if (numel (names) != columns (data))
    error ("gsmbp_csv: %s: %d column heads for %d columns", file, numel (names), columns (data));
  endif
  folder = fileparts (file);
  if (! isempty (folder) && ! exist (folder, "dir"))
    mkdir (folder);
  endif
  new = sprintf ("%s.%d", file, getpid ());
  f = fopen (new, "w");
  if (f < 0)
    error ("gsmbp_csv: cannot write %s", new);
  endif
  fprintf (f, "%s\n", strjoin (names(:)', ","));
  row = [repmat("%.17g,", 1, columns (data))(1:end-1) "\n"];
  fprintf (f, row, data');
  fclose (f);
  rename (new, file);
endfunction

%!test
%! file = [tempname() ".csv"];
%! unwind_protect
%!   gsmbp_csv (file, {"t", "q"}, [0 0.1; 1 pi]);
%!   assert (fileread (file), "t,q\n0,0.10000000000000001\n1,3.1415926535897931\n");
%! unwind_protect_cleanup
%!   delete (file);
%! end_unwind_protect
%!error <2 column heads for 1 columns> gsmbp_csv ("x", {"a", "b"}, 1)
