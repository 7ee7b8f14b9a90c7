## text = gs.text.why_left_out (m, request)
## Why a scene was emitted without a request: its reason, or what to write to have it.

function text = why_left_out (m, request)
  text = sprintf (["made on request: requests : '[all, %s]$ beside the scene in its file, or " ...
                   "gsmbp_fortran(scene, [all, %s]) in Maxima"], request, request);
  if (isfield (m.json, "left_out"))
    for row = m.json.left_out(:)'
      if (iscell (row))
        row = row{1};
      endif
      if (strcmp (row.request, request) && isempty (strfind (row.reason, "made on request")))
        text = row.reason;
      endif
    endfor
  endif
endfunction
