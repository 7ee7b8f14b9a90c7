## text = gsmbp__why_left_out (m, request)
## Why a scene was emitted without a request.

function text = gsmbp__why_left_out (m, request)
  text = "add it to the requests of gsmbp_fortran";
  if (isfield (m.json, "left_out"))
    for row = m.json.left_out(:)'
      if (iscell (row))
        row = row{1};
      endif
      if (strcmp (row.request, request))
        text = row.reason;
      endif
    endfor
  endif
endfunction
