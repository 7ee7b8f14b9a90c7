## [source, header] = gs.controller.target_c (c, t)
## C99 of the controller C of gsmbp_model_control alone: NAME (t, y, r, z, u) and NAME_start (z, u),
## over the C of the scene and of share/controllers.  T: of gs.controller.target_files.

function [source, header] = target_c (c, t)
  t.ny = numel (c.measured);
  t.nr = numel (c.references);
  t.nu = numel (c.driven);
  t.nv = t.json.dimensions.nv;
  t.n = t.json.dimensions.nu;
  t.prefix = tolower (t.name);
  t.taken = sprintf (["(double t, const double y[%d], const double r[%d], double z[%d], " ...
                      "double u[%d])"], t.ny, t.nr, t.nz + t.cst, t.nu);
  header = header_of (c, t);
  if (isfield (c, "through"))
    [data, body] = through (c, t);
  else
    [data, body] = at_efforts (c, t);
  endif
  out = [{sprintf("/* %s.c: see %s.h */", c.name, c.name), sprintf("#include \"%s.h\"", c.name), ...
          "", "#include <math.h>", "", "#include \"controllers.h\"", ...
          sprintf("#include \"%s.h\"", t.name), ""}, ...
         ints("drives", t.drives), numbers("low", c.limits(:,1)), ...
         numbers("high", c.limits(:,2)), numbers("step", c.step_out), data, start(c, t), ...
         {"void", [c.name " " t.taken], "{"}, strcat({"  "}, body), {"}"}];
  source = sprintf ("%s\n", out{:});
endfunction

function text = header_of (c, t)
  head = strjoin (gs.controller.target_head (c, t, " *"), "\n");
  NAME = upper (c.name);
  guard = ["GSMBP_CONTROLLER_" NAME "_H"];
  sizes = {"MEASURED", t.ny; "REFERENCES", t.nr; "MEMORY", t.nz + t.cst; "OUTPUTS", t.nu}';
  text = [sprintf("/*\n%s\n */\n#ifndef %s\n#define %s\n\n", head, guard, guard), ...
          sprintf(["#define " NAME "_%s %d\n"], sizes{:}), ...
          sprintf("#define %s_PERIOD %.17g\n#define %s_DELAY %.17g\n\n", NAME, c.period, NAME, ...
                  c.delay), ...
          sprintf("#ifdef __cplusplus\nextern \"C\" {\n#endif\n/* one sample */\nvoid %s %s;\n", ...
                  c.name, t.taken), ...
          sprintf(["/* memory, outputs and constants where it starts */\n" ...
                   "void %s_start (double z[%d], double u[%d]);\n" ...
                   "#ifdef __cplusplus\n}\n#endif\n\n#endif\n"], c.name, t.nz + t.cst, t.nu)];
endfunction

function out = start (c, t)
  names = gs.given.names_and_units (t.json.parameters);
  z = zeros (t.nz, 1);
  if (isfield (c, "starts"))
    z = c.starts;
  endif
  out = [{"", sprintf("static const %s_parameters parameters = {", t.prefix)}, ...
         each(numel (names), @(i) sprintf ("  %s, /* %s */", gs.text.c_number (t.values(i)), ...
                                           names{i})), ...
         {"};", "", "void", sprintf("%s_start (double z[%d], double u[%d])", c.name, ...
                                    t.nz + t.cst, t.nu), "{"}, ...
         each(t.nz, @(i) sprintf ("  z[%d] = %s;", i - 1, gs.text.c_number (z(i)))), ...
         each(t.nu, @(i) sprintf ("  u[%d] = %s;", i - 1, gs.text.c_number (c.u0(i)))), ...
         {sprintf("  %s_pre (&parameters, z + %d);", t.prefix, t.nz), "}", ""}];
endfunction

## a tree with efforts: INV
function [data, body] = at_efforts (c, t)
  impedance = strcmp (c.method, "impedance");
  data = gains_of (c, impedance);
  n = t.n;
  body = {sprintf("double qdd[%d], tau[%d], mt[%d], v[%d] = { 0.0 };", n, n, n * n, t.nv), ...
          sprintf("const double *cst = z + %d;", t.nz), ...
          sprintf("gs_sample s = { t, y, y + %d, r, r + %d, r + %d };", n, n, 2 * n), ...
          sprintf("gs_gains k = { kp, kd, %s, %s };", {"ki", "0"}{1 + impedance}, ...
                  gs.text.c_number (c.zeta)), "(void) qdd; (void) mt;"};
  inv = [t.prefix "_inv"];
  switch (c.method)
    case "computed torque"
      body{end+1} = sprintf ("gsctq (%s, %d, &s, &k, z, v, cst, qdd, tau);", inv, n);
    case "feedforward"
      body{end+1} = sprintf ("gsffw (%s, %d, &s, &k, z, v, cst, tau);", inv, n);
    case "impedance"
      body{end+1} = sprintf ("gsimt (%s, %s_mas, %d, &s, &k, v, cst, mt, tau);", inv, t.prefix, n);
  endswitch
  integral = sprintf ("if (within) z[i] = z[i] + %s * (r[i] - y[i]);", gs.text.c_number (c.period));
  body = [body, {sprintf("for (int i = 0; i < %d; i++)", n), "  {", ...
                 "    int within = gslim (low[i], high[i], step[i], tau + i);", ...
                 ["    " {integral, "(void) within;"}{1 + impedance}], ...
                 "    u[i] = tau[i];", "  }", "(void) drives;"}];
endfunction

## through loops and drives: closure and command
function [data, body] = through (c, t)
  d = c.through;
  [na, n, no] = deal (numel (d.independent), t.n, d.order);
  loops = t.json.dimensions.nlam > 0;
  impedance = any (strfind (c.method, "impedance"));
  tool = strcmp (c.method, "cartesian impedance");
  data = [ints("independent", d.independent), ints("acts", d.acts(:)), routines(t, d, loops)];
  if (tool)
    data = [data, numbers("stiffness", c.K), numbers("damping", c.D), ...
            numbers("own_damping", c.damping)];
  else
    data = [data, gains_of(c, impedance)];
  endif
  if (strcmp (c.method, "feedforward"))
    data = [data, ints("pair", t.drives(d.pair))];
  endif
  at = na * (1 - tool);   # of the coordinates of the loops in the memory
  sized = @(name, k) sprintf ("double %s[%d];", name, max (k, 1));
  names = {"0", "0"; [t.prefix "_pnt"], [t.prefix "_jpt"]}(1 + tool,:);
  each_ = @(line) {sprintf("for (int i = 0; i < %d; i++)", n), sprintf(line, at)}(1:2*loops);
  body = {sprintf("double rj[%d] = { 0.0 }, qg[%d] = { 0.0 };", t.nr + na, n), ...
          sized("qj", n * (no + 1)), sized("v", t.nv), ...
          sprintf("gs_machine m = { %d, %d, %d, independent, closure, command, %s_mas, %s, %s,", ...
                  n, na, no, t.prefix, names{:}), ...
          sprintf("                 z + %d };", t.nz), ...
          sprintf("gs_sample s = { t, y, y + %d, rj, rj + %d, rj + %d };", na, na, 2 * na), ...
          sprintf("for (int i = 0; i < %d; i++)", t.nr), "  rj[i] = r[i];"};
  body = [body, each_("  qg[i] = z[%d + i];"), call_(c, t, na, n, no), ...
          {"if (info != 0)", "  {", sprintf("    z[%d] += 1.0;", t.nz - 1), "    return;", ...
           "  }"}, ...
          each_("  z[%d + i] = qg[i];"), held(c, t, na, impedance)];
endfunction

## closure and command as the devices call them
function out = routines (t, d, loops)
  out = {"", "static int", "closure (double t, double *qj, const double *cst)", "{"};
  if (loops)
    out = [out, {"  double left;", sprintf("  return %s_clo (t, qj, cst, &left);", t.prefix)}];
  else
    out = [out, {"  (void) t; (void) qj; (void) cst;", "  return 0;"}];
  endif
  out = [out, {"}", "", "static int", ...
               "command (double t, const double *qj, const double *cst, double *v)", "{"}];
  na = max (t.json.dimensions.na, 1);
  if (strcmp (d.command, "cmd"))
    out = [out, {sprintf("  double xi[%d] = { 0.0 }, xid[%d];", na, na), ...
                 sprintf("  return %s_cmd (t, qj, xi, cst, v, xid);", t.prefix)}];
  elseif (d.margins > 0)
    out = [out, {sprintf("  double margins[%d];", d.margins), ...
                 sprintf("  return %s_cmq (t, qj, cst, v, margins);", t.prefix)}];
  else
    out = [out, {sprintf("  return %s_cmq (t, qj, cst, v);", t.prefix)}];
  endif
  out = [out, {"}", ""}];
endfunction

function out = call_ (c, t, na, n, no)
  own = {sprintf("double a[%d];", na)};
  work = [own, {sprintf("double wj[%d], mt[%d], tr[%d], mr[%d];", n * (no + 1), n * n, n * na, ...
                        na * na), sprintf("int iw[%d];", na)}];
  switch (c.method)
    case "computed torque"
      out = [own, {"gs_gains k = { kp, kd, ki, 0.0 };", ...
                   "int info = gsctd (&m, &s, &k, z, qg, a, qj, v);"}];
    case "feedforward"
      out = {"gs_gains k = { kp, kd, ki, 0.0 };", ...
             "int info = gsffd (&m, &s, rj, &k, z, pair, qg, qj, v);"};
    case "impedance"
      out = [work, {sprintf("gs_gains k = { kp, kd, 0, %s };", gs.text.c_number (c.zeta)), ...
                    "int info = gsimd (&m, &s, &k, qg, a, qj, wj, mt, tr, mr, v, iw);"}];
    case "cartesian impedance"
      p = c.tools;
      out = [work, {sprintf("double p[%d], axes[%d], jp[%d], dju[%d];", 3 * p, 9 * p, 6 * n * p, ...
                            6 * p), ...
                    sprintf("gs_tool tool = { %d, %d, %d, rj, rj + 6, stiffness, damping,", ...
                            p, c.tool, strcmp (c.axes, "tool")), ...
                    "                 own_damping };", ...
                    ["int info = gscim (&m, &s, &tool, qg, a, qj, wj, mt, tr, mr, p, axes, jp, " ...
                     "dju, v, iw);"]}];
  endswitch
endfunction

## limits; integrals stop where an input that drives them is limited
function out = held (c, t, na, impedance)
  out = {sprintf("for (int i = 0; i < %d; i++)", t.nu), "  {", ...
         "    double *one = v + drives[i] - 1;", ...
         "    int within = gslim (low[i], high[i], step[i], one);", "    u[i] = *one;"};
  if (impedance)
    out = [out, {"    (void) within;", "  }", "(void) acts;"}];
    return;
  endif
  out = [out, {sprintf("    for (int j = 0; j < %d; j++)", na), ...
               sprintf("      if (! within && acts[i + %d * j])", t.nu), ...
               "        limited[j] = 1;", "  }", ...
               sprintf("for (int j = 0; j < %d; j++)", na), "  if (! limited[j])", ...
               sprintf("    z[j] = z[j] + %s * (rj[j] - y[j]);", gs.text.c_number (c.period))}];
  out = [{sprintf("int limited[%d] = { 0 };", na)}, out];
endfunction

function out = gains_of (c, impedance)
  if (impedance)
    out = [numbers("kp", c.K), numbers("kd", c.D)];
  else
    out = [numbers("kp", c.Kp), numbers("kd", c.Kd), numbers("ki", c.Ki)];
  endif
endfunction

function out = numbers (name, x)
  out = listed ("double", name, arrayfun (@gs.text.c_number, x(:)', "UniformOutput", false));
endfunction
function out = ints (name, k)
  out = listed ("int", name, arrayfun (@(i) sprintf ("%d", i), k(:)', "UniformOutput", false));
endfunction

## a static array, a few to a line
function out = listed (type, name, items)
  out = {sprintf("static const %s %s[] = {", type, name)};
  for k = 1:4:numel (items)
    out{end+1} = ["  " strjoin(items(k:min (end, k + 3)), ", ") ","];
  endfor
  out{end+1} = "};";
endfunction

function lines = each (n, line)
  lines = arrayfun (line, 1:n, "UniformOutput", false);
endfunction
