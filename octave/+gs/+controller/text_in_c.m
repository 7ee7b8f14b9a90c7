## [text, header] = gs.controller.text_in_c (c, name)
## The controller C as C99: NAME (y, r, z, u), one sample, and NAME_start (z, u); the header.

function [text, header] = text_in_c (c, name)
  sizes = [numel(c.measured), numel(c.references), rows(c.A), numel(c.driven)];
  dims = max (sizes, 1);
  taken = sprintf (["(const double y[%d], const double r[%d], double z[%d], double u[%d])"], ...
                       dims);
  guard = upper (["GSMBP_CONTROLLER_" name "_H"]);
  head = strjoin (gs.controller.head_lines (c, name, " *"), "\n");
  header = sprintf (["/*\n%s\n */\n#ifndef %s\n#define %s\n\n#define %s_MEASURED %d\n" ...
                     "#define %s_REFERENCES %d\n#define %s_MEMORY %d\n#define %s_OUTPUTS %d\n" ...
                     "#define %s_PERIOD %.17g\n#define %s_DELAY %.17g\n\n#ifdef __cplusplus\n" ...
                     "extern \"C\" {\n#endif\n/* one sample */\nvoid %s %s;\n/* memory and " ...
                     "outputs at the trim */\nvoid %s_start (double z[%d], double u[%d]);\n" ...
                     "#ifdef __cplusplus\n}\n#endif\n\n#endif\n"], head, guard, guard, ...
                    upper (name), sizes(1), upper (name), sizes(2), upper (name), sizes(3), ...
                    upper (name), sizes(4), upper (name), c.period, upper (name), c.delay, ...
                    name, taken, name, dims(3), dims(4));
  body = {};
  for step = gs.controller.step_lines (c)'
    body = [body, statement(step{:})];
  endfor
  start = [arrayfun(@(k) sprintf ("z[%d] = 0.0;", k - 1), 1:sizes(3), "UniformOutput", false), ...
           arrayfun(@(k) sprintf ("u[%d] = %s;", k - 1, gs.text.c_number (c.u0(k))), 1:sizes(4), ...
                    "UniformOutput", false)];
  out = {sprintf("/* %s.c: see %s.h */", name, name), "#include <math.h>", ...
         sprintf("#include \"%s.h\"", name), "", "void", [name " " taken], "{", ...
         sprintf("  double e[%d], w[%d], d[%d], n[%d];", max (sizes(1) + sizes(2), 1), ...
                 dims([4, 4, 3]))};
  if (isfield (c, "schedule"))
    out{end+1} = sprintf ("  double p[%d], m[%d], s, t;", dims([4, 3]));
    body{end+1} = "(void) t; (void) m;";
  endif
  out = [out, strcat({"  "}, body), {"  (void) y; (void) r; (void) z; (void) e; (void) n;", ...
         "}", "", "void", sprintf("%s_start (double z[%d], double u[%d])", name, dims([3, 4])), ...
         "{"}, strcat({"  "}, start), {"  (void) z;", "}"}];
  text = sprintf ("%s\n", out{:});
endfunction

function lines = statement (target, kind, args)
  to = place (target);
  switch (kind)
    case "copy"
      lines = {sprintf("%s = %s;", to, place (args{1}))};
    case "clip"
      lines = {};
      if (isfinite (args{2}))
        lines{end+1} = sprintf ("if (%s < %s) %s = %s;", to, gs.text.c_number (args{2}), to, ...
                                gs.text.c_number (args{2}));
      endif
      if (isfinite (args{3}))
        lines{end+1} = sprintf ("if (%s > %s) %s = %s;", to, gs.text.c_number (args{3}), to, ...
                                gs.text.c_number (args{3}));
      endif
    case "round"
      lines = {sprintf("%s = %s * floor (%s / %s + 0.5);", to, gs.text.c_number (args{2}), ...
                       place (args{1}), gs.text.c_number (args{2}))};
    case "sum"
      lines = sum_of (to, args);
    case "add"
      lines = sum_of (to, [{1, target}; args]);
    case "when"
      lines = {sprintf("%sif (%s < %s) {", {"", "} else "}{1 + args{2}}, to, ...
                       gs.text.c_number (args{1}))};
    case "else"
      lines = {"} else {"};
    case "end"
      lines = {"}"};
    case "weight"
      lines = {sprintf("s = (%s - (%s)) / %s;", to, gs.text.c_number (args{1}), ...
                       gs.text.c_number (args{2} - args{1})), ...
               "s = s > 1.0 ? 1.0 : s < 0.0 ? 0.0 : s;"};
    case "keep"
      lines = {sprintf("%s = %s;", to, place (args{1}))};
    case "blend"
      lines = {sprintf("%s = %s + s * (%s - %s);", to, place (args{1}), to, place (args{1}))};
    case "gain"
      lines = {sprintf("t = %s + s * (%s);", gs.text.c_number (args{1}), ...
                       gs.text.c_number (args{2} - args{1})), ...
               sprintf("%s += t * %s;", to, place (args{3}))};
  endswitch
endfunction

## a statement for each term
function lines = sum_of (to, terms)
  lines = {};
  for part = gs.controller.sum_terms (to, terms, @gs.text.c_number, @place, " * ")'
    lines{end+1} = sprintf ("%s %s %s;", to, {[part{1} "="], "="}{1 + (part{1} == "=")}, part{2});
  endfor
endfunction

function text = place (name)
  text = sprintf ("%s[%d]", name(1), str2double (name(2:end)) - 1);
endfunction
