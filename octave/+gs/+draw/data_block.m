## lines = gs.draw.data_block (name, M)
## A block of data of gnuplot, columns of M.

function lines = data_block (name, M)
  M = M.';
  text = sprintf ([repmat(" %.9g", 1, rows (M)) "\n"], M);
  lines = {sprintf("$%s << EOD", name), strrep(text(1:end-1), "Inf", "NaN"), "EOD"};
endfunction
