## text = gs.controller.text_in_fortran (c, name)
## The controller C as Fortran 77: NAME( Y, R, Z, U ), one sample.

function text = text_in_fortran (c, name)
  sizes = [numel(c.measured), numel(c.references), rows(c.A), numel(c.driven)];
  dims = max (sizes, 1);
  out = {sprintf("      SUBROUTINE %s( Y, R, Z, U )", name)};
  out = [out, gs.controller.head_lines(c, name, "C")];
  out{end+1} = "      IMPLICIT NONE";
  out{end+1} = sprintf ("      DOUBLE PRECISION   Y(%d), R(%d), Z(%d), U(%d)", dims);
  out{end+1} = sprintf ("      DOUBLE PRECISION   E(%d), W(%d), D(%d), N(%d), T", ...
                        max (sizes(1) + sizes(2), 1), dims([4, 4, 3]));
  if (isfield (c, "schedule"))
    out{end+1} = sprintf ("      DOUBLE PRECISION   P(%d), M(%d), S", dims([4, 3]));
  endif
  out{end+1} = "C";
  for step = gs.controller.step_lines (c)'
    out = [out, statement(step{:})];
  endfor
  out{end+1} = "      END";
  text = sprintf ("%s\n", out{:});
endfunction

function lines = statement (target, kind, args)
  to = place (target);
  switch (kind)
    case "copy"
      lines = {sprintf("      %s = %s", to, place (args{1}))};
    case "clip"
      lines = {};
      if (isfinite (args{2}))
        lines{end+1} = sprintf ("      %s = MAX( %s, %s )", to, place (args{1}), ...
                                gs.text.fortran_number (args{2}));
      endif
      if (isfinite (args{3}))
        lines{end+1} = sprintf ("      %s = MIN( %s, %s )", to, place (args{1}), ...
                                gs.text.fortran_number (args{3}));
      endif
    case "round"
      lines = {sprintf("      T = %s/%s + 0.5D0", place (args{1}), ...
                       gs.text.fortran_number (args{2})), ...
               sprintf("      %s = AINT( T )", to), ...
               sprintf("      IF ( %s.GT.T ) %s = %s - 1.0D0", to, to, to), ...
               sprintf("      %s = %s*%s", to, gs.text.fortran_number (args{2}), to)};
    case "sum"
      lines = sum_of (to, args);
    case "add"
      lines = sum_of (to, [{1, target}; args]);
    case "when"
      lines = {sprintf("      %sIF ( %s.LT.%s ) THEN", {"", "ELSE "}{1 + args{2}}, to, ...
                       gs.text.fortran_number (args{1}))};
    case "else"
      lines = {"      ELSE"};
    case "end"
      lines = {"      END IF"};
    case "weight"
      lines = {sprintf("      S = ( %s - %s )", to, gs.text.fortran_number (args{1})), ...
               sprintf("      S = S/%s", gs.text.fortran_number (args{2} - args{1})), ...
               "      S = MAX( 0.0D0, MIN( 1.0D0, S ) )"};
      lines{1} = strrep (lines{1}, "- -", "+ ");
    case "keep"
      lines = {sprintf("      %s = %s", to, place (args{1}))};
    case "blend"
      lines = {sprintf("      %s = %s + S*( %s - %s )", to, place (args{1}), to, place (args{1}))};
    case "gain"
      lines = {sprintf("      T = %s", gs.text.fortran_number (args{1})), ...
               sprintf("      T = T + S*( %s )", gs.text.fortran_number (args{2} - args{1})), ...
               sprintf("      %s = %s + T*%s", to, to, place (args{3}))};
  endswitch
endfunction

## a line for each term
function lines = sum_of (to, terms)
  lines = {};
  for part = gs.controller.sum_terms (to, terms, @gs.text.fortran_number, @place, "*")'
    if (part{1} == "=")
      lines{end+1} = sprintf ("      %s = %s", to, part{2});
    else
      lines{end+1} = sprintf ("      %s = %s %s %s", to, to, part{:});
    endif
  endfor
endfunction

function text = place (name)
  text = sprintf ("%s(%s)", upper (name(1)), name(2:end));
endfunction
