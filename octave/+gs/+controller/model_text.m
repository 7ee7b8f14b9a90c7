## text = gs.controller.model_text (c, name, k, reads, drives, nv)
## Fortran of the controller C (gsmbp_model_control), number K of the scene NAME: its device of
## share/controllers, and NAME_CDk that takes its numbers from the outputs READS and the inputs
## behind NV, and drives the inputs DRIVES.

function text = model_text (c, name, k, reads, drives, nv)
  n = numel (drives);
  device = struct ("computed_torque", "gsctq", "feedforward", "gsffw", "impedance", ...
                   "gsimt").(strrep (c.method, " ", "_"));
  own = sprintf ("%s_CN%d", name, k);
  source = fileread (gs.files.own_place ("share", "controllers", [device ".f"]));
  source = regexprep (source, ['\<' upper(device) '\>'], own);
  number = @gs.text.fortran_number;
  out = {sprintf("      SUBROUTINE %s_CD%d( T, Y, XK, CST, V )", name, k), ...
         sprintf("C     The controller %s (%s) on the scene.", c.name, c.method), ...
         "      IMPLICIT NONE", "      INTEGER            I, N, NV", ...
         sprintf("      PARAMETER        ( N = %d, NV = %d )", n, nv), ...
         "      DOUBLE PRECISION   T, Y(*), XK(*), CST(*), V(*), Q(N), U(N)", ...
         "      DOUBLE PRECISION   QR(N), UR(N), AR(N), KP(N), KD(N), KI(N)", ...
         "      DOUBLE PRECISION   VO(NV+1), A(N), M(N,N), TAU(N), RAW", ...
         sprintf("      EXTERNAL           %s_INV, %s_MAS", name, name)};
  constants = "CST";
  if (! isempty (c.cst))
    out{end+1} = sprintf ("      DOUBLE PRECISION   OWN(%d)", numel (c.cst));
    constants = "OWN";
  endif
  out{end+1} = "C";
  for i = 1:numel (c.cst)
    out{end+1} = sprintf ("      OWN(%d) = %s", i, number (c.cst(i)));
  endfor
  gains = {"KP", "KD", "KI"; "Kp", "Kd", "Ki"};
  if (strcmp (c.method, "impedance"))
    gains = {"KP", "KD"; "K", "D"};
  endif
  for i = 1:n
    out = [out, {sprintf("      Q(%d) = Y(%d)", i, reads(i)), ...
                 sprintf("      U(%d) = Y(%d)", i, reads(n + i))}];
    for gain = gains
      out{end+1} = sprintf ("      %s(%d) = %s", gain{1}, i, number (c.(gain{2})(i)));
    endfor
  endfor
  out = [out, {"      DO 10 I = 1, N", "         QR(I) = V(NV+I)", "         UR(I) = V(NV+N+I)", ...
               "         AR(I) = V(NV+2*N+I)", "   10 CONTINUE", "      DO 20 I = 1, NV", ...
               "         VO(I) = 0.0D0", "   20 CONTINUE"}];   # forces are not measured
  if (strcmp (c.method, "impedance"))
    out = [out, {sprintf("      CALL %s( %s_INV, %s_MAS, N,", own, name, name), ...
                 sprintf("     $   T, Q, U, QR, UR, AR, KP, KD, %s,", number (c.zeta)), ...
                 sprintf("     $   VO, %s, A, M, TAU )", constants)}];
  else
    out = [out, {sprintf("      CALL %s( %s_INV, N, T,", own, name), ...
                 "     $   Q, U, QR, UR, AR, KP, KD, KI, XK,", ...
                 sprintf("     $   VO, %s, A, TAU )", constants)}];
  endif
  for i = 1:n
    out = [out, given(c, i, drives(i), number)];
  endfor
  out{end+1} = "      END";
  text = [source, sprintf("%s\n", out{:})];
endfunction

## limits and converter; the integral grows where the effort is not limited
function lines = given (c, i, drive, number)
  lines = {sprintf("      RAW = TAU(%d)", i)};
  if (isfinite (c.limits(i,1)))
    lines{end+1} = sprintf ("      TAU(%d) = MAX( TAU(%d), %s )", i, i, number (c.limits(i,1)));
  endif
  if (isfinite (c.limits(i,2)))
    lines{end+1} = sprintf ("      TAU(%d) = MIN( TAU(%d), %s )", i, i, number (c.limits(i,2)));
  endif
  if (! strcmp (c.method, "impedance"))
    lines{end+1} = sprintf ("      IF ( RAW.EQ.TAU(%d) )", i);
    lines{end+1} = sprintf ("     $   XK(%d) = XK(%d) + %s*( QR(%d) - Q(%d) )", i, i, ...
                            number (c.period), i, i);
  endif
  if (c.step_out(i) > 0)
    step = number (c.step_out(i));
    lines = [lines, {sprintf("      TAU(%d) = %s*", i, step), ...
                     sprintf("     $   ANINT( TAU(%d)/%s )", i, step)}];
  endif
  lines{end+1} = sprintf ("      V(%d) = TAU(%d)", drive, i);
endfunction
