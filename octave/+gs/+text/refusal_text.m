## text = gs.text.refusal_text (name, value, ...)
## Return why a run is refused, in the words of all hosts (share/engine/core/gsmbp/refusals.h).

function text = refusal_text (name, varargin)
  rows = gs.text.table_rows ("GS_REFUSALS");
  text = sprintf (rows{strcmp (rows(:,1), name),2}, varargin{:});
endfunction
