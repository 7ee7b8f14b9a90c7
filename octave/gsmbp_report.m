## -*- texinfo -*-
## @c category Figures, tables, pages
## @deftypefn  {} {} gsmbp_report (@var{m}, @var{r}, @var{file})
## @deftypefnx {} {} gsmbp_report (@var{m}, @var{r}, @var{file}, @var{options}, @dots{})
## Write a scene and a run of it as one page for a browser.
##
## @var{m} is a model of @code{gsmbp_build}, @var{r} the result of
## @code{gsmbp_simulate} (fields @code{t}, @code{x}, @code{v} and what else it has;
## @var{nt} x @var{nx} states in SI units), @var{file} ends in @file{.html}.  The page
## fetches nothing: style, scripts, figures and numbers stand in it.
##
## It is the page that Maxima writes (@code{gsmbp_report (scene, html = "file.html")}:
## elements, system graph, equations of motion, devices, laws) with the parts of the
## run: a player of the motion in space (time by a slider, also from the keyboard,
## speed, camera by mouse and arrow keys; where the browser has no WebGL the drawing
## of one instant), how it was run (options, inputs, the planned motion beside that of
## the run, gain, reference and limits of a feedback, parameters: @code{@var{r}.options}),
## coordinates, speeds, states of devices, inputs and outputs over time, the energy
## audit, margins that were not kept, and the figures of the run.
##
## The page of Maxima is @file{@var{name}.html} beside the @file{.json} of the scene,
## or what one of the options says; it must be of the same scene (@code{m.scene_hash}).
## Without one the page has the parts of the run alone, without the player, and says so.
##
## Options:
## @table @code
## @item "page"
## the page that Maxima wrote
## @item "scene"
## the scene file (.mac, it gives the variable @code{scene} its value): Maxima writes the
## page now, as @code{gsmbp_derive} derives
## @item "workprecision"
## the result of @code{gsmbp_workprecision}: a figure and a table, speed against error
## @item "frames"
## how many instants of the run the player shows at most, default 500; the rows of
## @var{r} that are nearest to equal steps, nothing is interpolated
## @item "title"
## a line below the head
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_simulate (m, m.initial, 0:0.05:0.5, "input", 12);
## >> scene = "examples/slider_crank/slider_crank.mac";
## >> gsmbp_report (m, r, "crank.html", "scene", scene);
## @end example
##
## Errors: a result without t and x of the model's size; a file that does not end in
## .html or cannot be written; a page of another scene, or none of GSMBP's; an
## option that is unknown or out of its range; Maxima's error in one line.
## Source: own.
## @seealso{gsmbp_build, gsmbp_simulate, gsmbp_workprecision, gsmbp_animate, gsmbp_plot}
## @end deftypefn

function gsmbp_report (m, r, file, varargin)
  if (nargin < 3 || ! isstruct (m) || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_report";
  gs.given.refuse_words (who, "r", r);
  table = {"page", "", "text"
           "scene", "", "text"
           "workprecision", [], "any"
           "frames", 500, "positive"
           "title", "", "text"};
  o = gs.given.call_options (who, table, varargin);
  if (! (numel (file) > 5 && strcmpi (file(end-4:end), ".html")))
    error ("%s: argument file must end in .html, found: %s", who, file);
  endif
  check_result (who, m, r);
  [head, foot, drawing] = gs.report.page_parts (who, m, o);
  parts = {run_summary(r, o), gs.report.motion_player(who, m, r, drawing, o), ...
           gs.report.setup_section(m, r), ...
           gs.report.run_figures(m, r), gs.report.page_tables(m, r), ...
           gs.report.precision_section(who, o.workprecision)};
  gs.files.write_text (who, make_absolute_filename (file), [head, parts{:}, foot]);
endfunction

function check_result (who, m, r)
  if (! (isstruct (r) && isscalar (r) && all (isfield (r, {"t", "x"})) && isnumeric (r.x) ...
           && isnumeric (r.t)))
    error ("%s: argument r must be a result of gsmbp_simulate, with t and x, found: %s", who,
           gs.text.shown_value (r));
  endif
  if (isfield (r, "ud") && isfield (r, "tau"))
    error (["%s: argument r must be a result of gsmbp_simulate, found one of gsmbp_inverse: " ...
            "its motion needs drives; simulate it with them (option motion)"], who);
  endif
  nx = m.sizes.nx;
  if (numel (r.t) < 2 || rows (r.x) != numel (r.t) || columns (r.x) != nx)
    error (["%s: argument r: expected at least 2 times and as many rows of the %d states of " ...
            "%s, found %d times, x of %d x %d"], who, nx, m.name, numel (r.t), size (r.x));
  endif
endfunction

## what was run
function text = run_summary (r, o)
  text = sprintf ("<h2>The run</h2>\n");
  if (! isempty (o.title))
    text = [text, sprintf("<p>%s</p>\n", gs.text.html_escaped (o.title))];
  endif
  said = sprintf ("From t = %.6g s to %.6g s, %d instants", r.t(1), r.t(end), numel (r.t));
  if (isfield (r, "stats") && isfield (r.stats, "method"))
    said = sprintf ("%s; method %s", said, r.stats.method);
    if (isfinite (r.stats.rtol))
      said = sprintf ("%s, rtol %.3g", said, r.stats.rtol);
    endif
  endif
  text = [text, sprintf("<p>%s.</p>\n", gs.text.html_escaped (said))];
endfunction

%!function [m, r] = motor (varargin)
%!  addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%!  m = gsmbp_hand ("motor_pendulum");
%!  r = struct ("t", (0:0.1:1)', "x", [sin(0:0.1:1)', cos(0:0.1:1)', (0:0.1:1)'.^2], ...
%!              "v", 3*ones (11, 1));
%!endfunction
%!test # without Maxima's page: the parts of the run alone, names as text
%! [m, r] = motor ();
%! file = [tempname() ".html"];
%! tidy = onCleanup (@() unlink (file));
%! gsmbp_report (m, r, file, "title", "<script>alert(1)</script> & more");
%! text = fileread (file);
%! assert (any (strfind (text, "&lt;script&gt;alert(1)&lt;/script&gt; &amp; more")));
%! assert (isempty (strfind (text, "<script>alert")));
%! assert (any (strfind (text, ["at " fullfile(m.directory, "motor_pendulum.html")])));
%! assert (numel (strfind (text, "<svg")) >= 3);
%! assert (numel (strfind (text, "<svg")), numel (strfind (text, "</svg>")));
%!function text = page (m, r)
%!  file = [tempname() ".html"];
%!  tidy = onCleanup (@() unlink (file));
%!  gsmbp_report (m, r, file);
%!  text = fileread (file);
%!endfunction
%!test # how it was run: options, gain, reference, limits, parameters
%! [m, ~] = motor ();
%! r = gsmbp_simulate (m, [0 0 0], 0:0.5:1, "gain", [400 10 0.25], "reference", [0.5; 0; 0], ...
%!                     "limits", 12, "rtol", 1e-8, "maxstep", 0.1);
%! text = page (m, r);
%! row = @(varargin) any (strfind (text, ["<tr>" sprintf("<td>%s</td>", varargin{:}) "</tr>"]));
%! assert (row ("method", "dp853") && row ("rtol", "1e-08") && row ("maxstep", "0.1"));
%! assert (row ("drive.v", "400", "10", "0.25") && row ("b", "0.05", "N*m*s"));
%! assert (any (strfind (text, "Reference x0: q = 0.5, q_d = 0, drive.i = 0.")));
%! assert (any (strfind (text, "Limits of the inputs: 12.")));
%!test # gains and inputs that change with time; the planned motion is drawn beside the run's
%! [m, ~] = motor ();
%! plan = gsmbp_plan ("septic", [0 2], [0 1]);
%! text = page (m, gsmbp_simulate (m, [0 0 0], 0:0.5:1, "motion", plan, "method", "rk4"));
%! assert (any (strfind (text, "<title>Planned motion: q</title>")));
%! assert (any (strfind (text, "1 piece of degree 7 from 0 s to 1 s")));
%! assert (any (strfind (text, "<td>step [s]</td><td>0.001</td>")));
%! K = mkpp ([0 1 2], [400 10 0; 300 8 0]'(:), 3);
%! text = page (m, gsmbp_simulate (m, [0 0 0], 0:0.5:1, "gain", K, "reference", [0.5; 0; 0]));
%! assert (any (strfind (text, "At the start; K is a piecewise polynomial: 2 pieces of degree 0")));
%! text = page (m, gsmbp_simulate (m, [0 0 0], 0:0.5:1, "input", @(t, x) 3*(x(1) < 1)));
%! assert (any (strfind (text, "A function: @(t, x) 3 * (x (1) &lt; 1).")));
%! text = page (m, gsmbp_simulate (m, [0 0 0], 0:0.5:1, "input", 12));
%! assert (any (strfind (text, "Constant: drive.v = 12.")));
%!error <Invalid call> gsmbp_report (1)
%!error <argument file must end in .html, found: a.htm>
%! [m, r] = motor (); gsmbp_report (m, r, "a.htm")
%!error <expected at least 2 times and as many rows of the 3 states of motor_pendulum, found 11>
%! [m, r] = motor (); r.x(end,:) = []; gsmbp_report (m, r, "a.html")
%!error <argument r must be a result of gsmbp_simulate>
%! [m, r] = motor (); gsmbp_report (m, 1, "a.html")
%!error <option page: there is no file nowhere.html>
%! [m, r] = motor (); gsmbp_report (m, r, "a.html", "page", "nowhere.html")
%!error <unknown option "pages"> [m, r] = motor (); gsmbp_report (m, r, "a.html", "pages", "b")
