## text = gs.controller.drive_text (c, name, k, reads, drives, d, nv)
## Fortran of the controller C (gsmbp_model_control, through loops and drives), number K of the
## scene NAME with the sizes D, NV of its own inputs: devices of share/controllers, NAME_CLk and
## NAME_CVk, closure and command as they call them, and NAME_CDk that takes its numbers from the
## outputs READS and the inputs behind NV, and drives the inputs DRIVES.

function text = drive_text (c, name, k, reads, drives, d, nv)
  t = c.through;
  t.nv = nv;
  t.n = d.nu;
  t.loops = d.nlam > 0;
  t.nx = d.nx;
  t.at = @(part) sprintf ("%s_%s%d", name, part, k);
  device = struct ("computed_torque", "gsctd", "feedforward", "gsffd", "impedance", "gsimd", ...
                   "cartesian_impedance", "gscim").(strrep (c.method, " ", "_"));
  text = [sources(device, t), closure(name, t), command(name, t), ...
          sprintf("%s\n", sample (c, name, t, device, reads, drives){:})];
endfunction

## the devices under names of this controller's own
function text = sources (device, t)
  list = {device, "CN"; "gsmot", "CJ"; "gsmor", "CR"};
  if (any (strcmp (device, {"gsctd", "gsffd"})))
    list = list(1:2 - strcmp (device, "gsffd"),:);
  endif
  text = "";
  for i = 1:rows (list)
    text = [text, fileread(gs.files.own_place ("share", "controllers", [list{i,1} ".f"]))];
  endfor
  list = [list; {"gstrn", "CA"; "gstrv", "CB"; "gstax", "CC"}];
  for i = 1:rows (list)
    text = regexprep (text, ['\<' upper(list{i,1}) '\>'], t.at (list{i,2}));
  endfor
endfunction

function text = closure (name, t)
  out = {sprintf("      SUBROUTINE %s( T, QJ, CST, INFO )", t.at ("CL")), ...
         "      IMPLICIT NONE", "      INTEGER            INFO", ...
         "      DOUBLE PRECISION   T, QJ(*), CST(*), RES", "C", "      INFO = 0"};
  if (t.loops)
    out{end+1} = sprintf ("      CALL %s_CLO(\n     $   T, QJ, CST, RES, INFO )", name);
  endif
  text = sprintf ("%s\n", out{:}, "      END");
endfunction

## the arguments of CMQ have the margins where there are some
function text = command (name, t)
  out = {sprintf("      SUBROUTINE %s( T, QJ, CST, V, INFO )", t.at ("CV")), ...
         "      IMPLICIT NONE", "      INTEGER            INFO, I", ...
         "      DOUBLE PRECISION   T, QJ(*), CST(*), V(*)", ...
         sprintf("      DOUBLE PRECISION   XI(%d), XID(%d)", t.nx, t.nx), ...
         sprintf("      DOUBLE PRECISION   G(%d)", max (1, t.margins)), "C", ...
         sprintf("      DO 10 I = 1, %d", t.nx), "         XI(I) = 0.0D0", "   10 CONTINUE"};
  if (strcmp (t.command, "cmd"))
    out{end+1} = sprintf ("      CALL %s_CMD(\n     $   T, QJ, XI, CST, V, XID, INFO )", name);
  elseif (t.margins > 0)
    out{end+1} = sprintf ("      CALL %s_CMQ(\n     $   T, QJ, CST, V, G, INFO )", name);
  else
    out{end+1} = sprintf ("      CALL %s_CMQ(\n     $   T, QJ, CST, V, INFO )", name);
  endif
  text = sprintf ("%s\n", out{:}, "      END");
endfunction

function out = sample (c, name, t, device, reads, drives)
  na = numel (t.independent);
  nr = numel (c.references);
  out = {sprintf("      SUBROUTINE %s( T, Y, XK, CST, V )", t.at ("CD")), ...
         sprintf("C     The controller %s (%s) on the scene.", c.name, c.method), ...
         "      IMPLICIT NONE", "      INTEGER            I, N, NA, NO, NR, NV", ...
         sprintf("      PARAMETER        ( N = %d, NA = %d, NO = %d, NR = %d, NV = %d )", t.n, ...
                 na, t.order, nr, t.nv), ...
         "      INTEGER            IA(NA), ID(NA), IW(NA), INFO", ...
         "      DOUBLE PRECISION   T, Y(*), XK(*), CST(*), V(*), Q(NA)", ...
         "      DOUBLE PRECISION   U(NA), RJ(NR+NA), KP(NA), KD(NA), KI(NA)", ...
         "      DOUBLE PRECISION   A(NA), QJ(N,0:NO), WJ(N,0:NO), M(N,N)", ...
         "      DOUBLE PRECISION   TR(N,NA), MR(NA,NA), QG(N), VC(NV+1)", ...
         "      DOUBLE PRECISION   RAW", "      LOGICAL            FREE(NA)"};
  out = [out, declared(c, name, t)];
  [constants, lines] = believed (c);
  out = [out, lines, {"C"}, given(c, t, reads, drives)];
  out = [out, {"      DO 10 I = 1, NR", "         RJ(I) = V(NV+I)", "   10 CONTINUE"}];
  out = [out, guesses(t, na), call_(c, t, device, constants, name)];
  last = rows (c.A);
  out = [out, {"      IF ( INFO.NE.0 ) THEN", ...
               sprintf("         XK(%d) = XK(%d) + 1.0D0", last, last), ...
               "         RETURN", "      END IF"}, kept(t, na)];
  for i = 1:numel (drives)
    out = [out, limited(c, t, i, drives(i))];
  endfor
  if (! any (strfind (c.method, "impedance")))
    for i = 1:na
      out = [out, {sprintf("      IF ( FREE(%d) ) XK(%d) = XK(%d)", i, i, i), ...
                   sprintf("     $   + %s*( RJ(%d) - Q(%d) )", ...
                           gs.text.fortran_number (c.period), i, i)}];
    endfor
  endif
  out{end+1} = "      END";
endfunction

function out = declared (c, name, t)
  out = {sprintf("      EXTERNAL           %s", t.at ("CL")), ...
         sprintf("      EXTERNAL           %s", t.at ("CV")), ...
         sprintf("      EXTERNAL           %s_MAS", name)};
  if (t.cartesian)
    out = [out, {sprintf("      DOUBLE PRECISION   K(6,6), D(6,6), P(3,%d)", c.tools), ...
                 sprintf("      DOUBLE PRECISION   R(3,%d), JP(6,%d), DJU(6,%d)", 3 * c.tools, ...
                         c.tools * t.n, c.tools), ...
                 sprintf("      EXTERNAL           %s_PNT", name), ...
                 sprintf("      EXTERNAL           %s_JPT", name)}];
  endif
endfunction

## the machine's own constants, or those that the controller believes
function [name, out] = believed (c)
  [name, out] = deal ("CST", {});
  if (! isempty (c.cst))
    name = "OWN";
    out = {sprintf("      DOUBLE PRECISION   OWN(%d)", numel (c.cst)), "C"};
    for i = 1:numel (c.cst)
      out{end+1} = sprintf ("      OWN(%d) = %s", i, gs.text.fortran_number (c.cst(i)));
    endfor
  endif
endfunction

## what is measured, numbers of coordinates and inputs, gains
function out = given (c, t, reads, drives)
  n = numel (t.independent);
  gains = {"KP", "KD", "KI"; "Kp", "Kd", "Ki"};
  if (t.cartesian)
    gains = {"KP"; "damping"};
  elseif (strcmp (c.method, "impedance"))
    gains = {"KP", "KD"; "K", "D"};
  endif
  out = {};
  for i = 1:n
    out = [out, {sprintf("      IA(%d) = %d", i, t.independent(i)), ...
                 sprintf("      ID(%d) = %d", i, drives(t.pair(i))), ...
                 sprintf("      Q(%d) = Y(%d)", i, reads(i)), ...
                 sprintf("      U(%d) = Y(%d)", i, reads(n + i)), ...
                 sprintf("      FREE(%d) = .TRUE.", i)}];
    for gain = gains
      out{end+1} = sprintf ("      %s(%d) = %s", gain{1}, i, ...
                            gs.text.fortran_number (c.(gain{2})(i)));
    endfor
  endfor
  if (t.cartesian)
    for i = 1:36
      [j, k] = ind2sub ([6, 6], i);
      out = [out, {sprintf("      K(%d,%d) = %s", j, k, gs.text.fortran_number (c.K(j,k))), ...
                   sprintf("      D(%d,%d) = %s", j, k, gs.text.fortran_number (c.D(j,k)))}];
    endfor
  endif
endfunction

## where the loops are closed from: as they stood at the sample before
function out = guesses (t, na)
  out = {};
  for i = 1:t.n
    if (t.loops)
      out{end+1} = sprintf ("      QG(%d) = XK(%d)", i, i + na * (1 - t.cartesian));
    else
      out{end+1} = sprintf ("      QG(%d) = 0.0D0", i);
    endif
  endfor
endfunction

function out = kept (t, na)
  out = {};
  for i = 1:t.n * t.loops
    out{end+1} = sprintf ("      XK(%d) = QG(%d)", i + na * (1 - t.cartesian), i);
  endfor
endfunction

function out = call_ (c, t, device, constants, name)
  n = numel (t.independent);
  head = {sprintf("      CALL %s(", t.at ("CN")), ...
          sprintf("     $   %s, %s,", t.at ("CL"), t.at ("CV"))};
  refs = sprintf ("     $   RJ, RJ(%d), RJ(%d),", n + 1, 2 * n + 1);
  switch (device)
    case "gsctd"
      more = {"     $   N, NA, NO, IA, T, Q, U,", refs, ...
              ["     $   KP, KD, KI, XK, QG, " constants ", A, QJ, VC, INFO )"]};
    case "gsffd"
      more = {"     $   N, NA, NO, IA, T, Q, U,", ...
              ["     $   RJ, KP, KD, KI, XK, ID, QG, " constants ", QJ, VC, INFO )"]};
    case "gsimd"
      more = {sprintf("     $   %s_MAS,", name), "     $   N, NA, NO, IA, T, Q, U,", refs, ...
              sprintf("     $   KP, KD, %s,", gs.text.fortran_number (c.zeta)), ...
              ["     $   QG, " constants ", A, QJ, WJ, M, TR, MR, VC, IW, INFO )"]};
    case "gscim"
      more = {sprintf("     $   %s_MAS, %s_PNT,", name, name), ...
              sprintf("     $   %s_JPT,", name), ...
              sprintf("     $   N, NA, NO, %d, %d, %d, IA, T, Q, U,", c.tools, c.tool, ...
                      strcmp (c.axes, "tool")), ...
              ["     $   RJ, RJ(7), K, D, KP, QG, " constants ", A, QJ,"], ...
              "     $   WJ, M, TR, MR, P, R, JP, DJU, VC, IW, INFO )"};
  endswitch
  out = [head, more];
endfunction

## limits and converter; the integrals of the coordinates that an input drives stop while it is
## limited
function out = limited (c, t, i, drive)
  out = {sprintf("      RAW = VC(%d)", drive)};
  for row = {1, 2; "MAX", "MIN"}
    if (isfinite (c.limits(i,row{1})))
      out{end+1} = sprintf ("      VC(%d) = %s( VC(%d), %s )", drive, row{2}, drive, ...
                            gs.text.fortran_number (c.limits(i,row{1})));
    endif
  endfor
  for j = find (t.acts(i,:))
    out{end+1} = sprintf ("      IF ( RAW.NE.VC(%d) ) FREE(%d) = .FALSE.", drive, j);
  endfor
  if (c.step_out(i) > 0)
    step = gs.text.fortran_number (c.step_out(i));
    out = [out, {sprintf("      VC(%d) = %s*", drive, step), ...
                 sprintf("     $   ANINT( VC(%d)/%s )", drive, step)}];
  endif
  out{end+1} = sprintf ("      V(%d) = VC(%d)", drive, drive);
endfunction
