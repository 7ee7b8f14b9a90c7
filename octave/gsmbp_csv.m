## -*- texinfo -*-
## @c category Figures, tables, pages
## @deftypefn  {} {} gsmbp_csv (@var{file}, @var{names}, @var{data})
## @deftypefnx {} {} gsmbp_csv (@var{file}, @var{m}, @var{result}, @var{names})
## Write the matrix @var{data} as comma-separated values under the column heads
## @var{names} (a cell array of strings; in quotation marks where they hold a comma), each number
## with 17 digits.
##
## Written beside and then renamed, so that @var{file} is whole or as it was before;
## a disk that is full is an error.
## The folder is made if it does not exist.
##
## In the second form the time and the named quantities of a @var{result} of
## @code{gsmbp_simulate} or @code{gsmbp_inverse} are written (all of them without @var{names}), with
## their units in the column heads (@code{gsmbp_names}).
##
## @c session octave
## @example
## >> gsmbp_csv ("table.csv", @{"t", "y"@}, [0 1; 0.5 2]);
## >> type table.csv
## t,y
## 0,1
## 0.5,2
## @end example
##
## Errors: a name that the result has not; data that are no real matrix; another number of heads
## than columns; a file that cannot be written.
## Source: own.
## @seealso{gsmbp_plot, gsmbp_names}
## @end deftypefn

function gsmbp_csv (file, names, data, chosen)
  if (nargin < 3 || ! ischar (file) || ! (iscellstr (names) || isstruct (names)) ...
      || (nargin > 3 && iscell (names)))
    print_usage ();
  endif
  if (isstruct (names))
    m = names;
    gs.given.check_model ("gsmbp_csv", m);
    if (nargin < 4)
      chosen = {};
      if (isstruct (data) && isfield (data, "of"))
        chosen = fieldnames (data.of);
      endif
    endif
    panels = gs.model.named_panels ("gsmbp_csv", m, data, chosen);
    names = {"t [s]"};
    data = data.t;
    for p = panels
      names = [names, p{1}.heads];
      data = [data, p{1}.y];
    endfor
  endif
  if (! (isnumeric (data) || islogical (data)) || ! isreal (data) || ndims (data) > 2)
    error ("gsmbp_csv: %s: argument data: expected a real matrix, found %s", file, ...
           gs.text.shown_value (data));
  elseif (numel (names) != columns (data))
    error ("gsmbp_csv: %s: %d column heads for %d columns", file, numel (names), columns (data));
  endif
  parted = cellfun (@(h) any (ismember (h, ",\"\r\n")), names);
  names(parted) = strcat ('"', strrep (names(parted), '"', '""'), '"');
  row = [repmat("%.17g,", 1, columns (data))(1:end-1) "\n"];
  gs.files.write_text ("gsmbp_csv", file, [strjoin(names(:)', ","), "\n", sprintf(row, data')]);
endfunction

%!test
%! file = [tempname() ".csv"];
%! unwind_protect
%!   gsmbp_csv (file, {"t", "q"}, [0 0.1; 1 pi]);
%!   assert (fileread (file), "t,q\n0,0.10000000000000001\n1,3.1415926535897931\n");
%!   gsmbp_csv (file, {"a,b", 'c"d', "e"}, [1 2 3]);
%!   assert (fileread (file), "\"a,b\",\"c\"\"d\",e\n1,2,3\n");
%! unwind_protect_cleanup
%!   delete (file);
%! end_unwind_protect
%!error <2 column heads for 1 columns> gsmbp_csv ("x", {"a", "b"}, 1)
