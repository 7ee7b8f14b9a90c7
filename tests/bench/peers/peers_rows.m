## w = peers_rows (w, who, method, setting, seconds, calls, error): a measurement more, or another
## time of one that is there: the least counts.

function w = peers_rows (w, who, method, setting, seconds, calls, error)
  key = sprintf ("%s %s %.9g", who, method, setting);
  k = find (strcmp ({w.key}, key), 1);
  if (isempty (k))
    w(end+1) = struct ("key", key, "who", who, "method", method, "setting", setting, "seconds", ...
                       seconds, "calls", calls, "error", error);
  else
    w(k).seconds = min (w(k).seconds, seconds);
  end
end
