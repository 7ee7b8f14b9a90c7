## text = gsmbp__refusal (name, value, ...)
## Return why a run is refused, in the words of all hosts (share/c/gsmbp/refusals.h).

function text = gsmbp__refusal (name, varargin)
  rows = gsmbp__run_table ("GS_REFUSALS");
  text = sprintf (rows{strcmp (rows(:,1), name),2}, varargin{:});
endfunction
