## text = gs.text.plot_label (text)
## A label of an axis as a figure shows it: its unit, in brackets, with the signs of the field where
## it was typed in plain letters ("[um]", "[m^2]", "[degrees]", "[N*m]", "[ohm]").

function text = plot_label (text)
  [from, to] = regexp (text, '\[[^\]]*\]');
  if (isempty (from))
    return;
  endif
  unit = text(from(end):to(end));
  table = {'\*', " "; '\^2', "\302\262"; '\^3', "\302\263"; '\<(degrees|deg)\>', "\302\260"
           '\<u(m|s|A|V|N|rad|Pa|W|J|Hz|C|Wb|F|H|K|g|T|ohm)\>', "\302\265$1"; 'ohm\>', "\316\251"};
  for row = table'
    unit = regexprep (unit, row{:});
  endfor
  text = [text(1:from(end)-1), unit, text(to(end)+1:end)];
endfunction
