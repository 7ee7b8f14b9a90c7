## tell_design (R): what gsmbp_design decided, the margins, and what would have to change.

function tell_design (r)
  printf ("all demands are met: %s\n", {"no", "yes"}{1 + r.met});
  if (! r.met)
    printf ("  not met: %s\n", r.unmet.said);
  endif
  puts ("\ndecisions\n");
  for one = r.decisions
    printf ("%s: %s\n", one.what, one.chosen);
    printf ("  - %s\n", one.why{:});
  endfor
  printf ("\nmargins: nominal, to first order, at the worst of %d corners that were run\n", ...
          numel (r.corners));
  printf ("%-8s %-16s %12s %12s %12s %12s %7s\n", "axis", "quantity", "allowed", "nominal", ...
          "first order", "corners", "used");
  for one = r.margins
    printf ("%-8s %-16s %12.4g %12.4g %12.4g %12.4g %5.0f %%\n", one.axis, one.name, one.limit, ...
            one.found, one.first, one.worst, 100 * one.worst / one.limit);
  endfor
  puts ("\nwhat would have to change\n");
  printf ("- %s\n", r.more.said);
endfunction
