## [color, entry] = gs.draw.legend_entries (body)
## The colours of the BODY names of a skeleton, and the entries of the legend.

function [color, entry] = legend_entries (body)
  family = entry = body(:)';
  if (numel (body) > 8)
    family = regexprep (family, '\d+$', "");
  endif
  kinds = unique (family, "stable");
  group = cellfun (@(f) find (strcmp (f, kinds)), family);
  color = [{"#888888"}, gs.draw.line_colors(max (group) - 1)](group);
  for g = 2:max (group)
    k = find (group == g);
    if (numel (k) > 1)
      entry{k(1)} = sprintf ("%s ... %s", body{k([1 end])});
      entry(k(2:end)) = {""};
    endif
  endfor
  entry{1} = "";
endfunction
