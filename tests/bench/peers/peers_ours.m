## w = peers_ours (w, s, who, m, methods, word): runs of a model in compiled code at many tolerances
## and steps, as peers_rows; METHODS: a row {method, option, values, further options} for each;
## WORD: what tells this model from another one of the same.

function w = peers_ours (w, s, who, m, methods, word = "")
  for one = methods'
    [method, option, values, more] = one{:};
    for value = values
      o = [s.options, {"method", method, option, value, "drift", false}, more];
      try
        [r, info] = gsmbp_simulate (m, s.x0, [0, s.end], o{:});
      catch problem
        printf ("%s by %s with %g: %s\n", who, method, value, problem.message);
        continue;
      end
      if (info != 0)
        continue;
      end
      [least, spent] = deal (r.stats.seconds);
      for k = 2:50
        if (spent > 0.02)
          break;
        end
        again = gsmbp_simulate (m, s.x0, [0, s.end], o{:}).stats.seconds;
        least = min (least, again);
        spent += again;
      end
      miss = max (abs (r.x(end,1:m.sizes.nq) - s.truth));
      w = peers_rows (w, who, [method sprintf(" %s", more{:}) word], value, least, ...
                      r.stats.calls, miss);
    end
  end
end
