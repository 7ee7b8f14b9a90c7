## [lines, aside] = gs.control.drawn_responses (t)
## Two panels of the page of gsmbp_loop in the language of gnuplot, of the responses T
## (gs.control.step_responses): what is measured, what is given.  What changes by less than a tenth
## of the rest has the axis at the right; ASIDE: whether something has.

function [lines, aside] = drawn_responses (t)
  lines = {};
  aside = false;
  for part = {"y", "u"; "Response: measured", "Response: inputs"}
    p = t.(part{1});
    name = upper (part{1});
    lines = [lines, gs.draw.data_block([name "L"], [t.linear, p.linear])];
    if (! isempty (t.machine))
      lines = [lines, gs.draw.data_block([name "M"], [t.machine, p.machine])];
    endif
    small = is_small (p);
    aside = aside || any (small);
    list = {};
    for i = 1:numel (p.names)
      list = [list, curves(t, p, i, name, small(i), t.stepped && part{1} == "u")];
    endfor
    room = min (0.5, 0.06 * numel (list) + 0.03);   # for the legend
    lines = [lines, {sprintf("set offsets graph 0, graph 0, graph %g, graph 0.03", room), ...
                     "set autoscale yfix", "set xlabel 'time [s]'", ...
                     sprintf("set xrange [%.9g:%.9g]", t.linear(1), ...
                             max ([t.linear(end); t.machine])), ...
                     sprintf("set ylabel %s noenhanced", label (p, ! small)), ...
                     sprintf("set title %s", gs.text.gnuplot_quoted (part{2}))}, right(p, ...
                         small, room), ...
             {["plot " strjoin(list, ", ")], "unset y2tics", "unset y2label", "set ytics mirror"}];
  endfor
endfunction

## which signals would be flat beside the others
function small = is_small (p)
  span = max ([p.linear; p.machine], [], 1) - min ([p.linear; p.machine], [], 1);
  small = span > 0 & span < 0.1 * max (span);
endfunction

## the axis at the right, its range with room for the legend as the other
function lines = right (p, small, room)
  lines = {};
  if (any (small))
    all_ = [p.linear(:,small); p.machine(:,small(1:columns (p.machine)))];
    [low, high] = deal (min (all_(:)), max (all_(:)));
    span = high - low;
    lines = {"set ytics nomirror", "set y2tics", ...
             sprintf("set y2range [%.9g:%.9g]", low - 0.03 * span, high + room * span), ...
             sprintf("set y2label %s noenhanced", label (p, small))};
  endif
endfunction

function text = label (p, which_)
  text = "as of the model";
  if (! isempty (p.units))
    text = ["[" strjoin(unique (p.units(which_)), "], [") "]"];
  endif
  if (! all (which_))
    text = [strjoin(p.names(which_), ", ") " " text];
  endif
  text = gs.text.gnuplot_quoted (text);
endfunction

## of the signal I: the machine, the linear model
function list = curves (t, p, i, name, small, steps)
  axes_ = {"x1y1", "x1y2"}{1 + small};
  aside = {"", " (right)"}{1 + small};
  color = gs.draw.line_colors (i);
  color = color{i};
  list = {};
  if (! isempty (t.machine))
    list{1} = sprintf ("$%sM using 1:%d axes %s with lines lw 2 lc rgb '%s' title %s", name, ...
                       1 + i, axes_, color, ...
                           gs.text.gnuplot_quoted ([p.names{i} ", machine" aside]));
  endif
  list{end+1} = sprintf ("$%sL using 1:%d axes %s with %s lw 1.8 dt %s lc rgb '%s' title %s", ...
                         name, 1 + i, axes_, {"lines", "steps"}{1 + steps}, ...
                         {"(6,4)", "1"}{1 + isempty(t.machine)}, color, ...
                         gs.text.gnuplot_quoted ([p.names{i} ", linear" aside]));
endfunction
