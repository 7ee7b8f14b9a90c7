## f = gs.collocation.compile_transcription (m, c)
## The program of gs.collocation.transcribe_problem C, compiled (glue/collocation.h): f (what, z,
## factor, lambda) is its goal "f", "grad", the equations "g", the triplets of "jac" and "hess";
## "places" tells where these stand, "functions" those of DAE at all points; "native" is what
## gs.run.run_ipopt takes instead, to call it without Octave; "time" what all of them take so [s].

function f = compile_transcription (m, c)
  own = c.stage(c.mesh.rule.own,:);
  c.own_points = own(:);
  c.left_points = repmat (c.left, rows (own), 1)(:);
  [column, point, a] = find (c.sums);
  c.share_list = [column(:), point(:), a(:)];
  [~, c.which] = ismember (c.parameters(:), fieldnames (m.par));
  c.par = gs.model.parameter_values (m);
  taken = {"K", "nz", "nT", "np", "nr", "nf", "n", "m", "t0", "goal_time", "tau", "goal", ...
           "weights", "final_x", "final_f", "phase", "rate", "stages", "bounded", ...
           "own_points", "left_points", ...
           "of_defect", "which", "par", "J", "H", "columns", "fixed", "plain", "timed", "of", ...
           "curved", "crossed", "crossed_speeds", "share_list", "own_linear", "own_products", ...
           "own_curved", "own_crossed", "rough"};
  given = cell2struct (cellfun (@(name) c.(name), taken(:), "UniformOutput", false), taken(:), 1);
  number = m.module ("program", m.cst, given);
  places = {[c.fixed(:,1:2); c.plain(:,1:2); c.timed(:,1:2); c.by_duration]
            [c.curved(:,1:2); c.crossed(:,1:2); c.crossed_speeds(:,1:2); c.own_curved(:,1:2)
             c.own_crossed(:,1:2); c.rough(:,1:2)]};
  f = @(varargin) answer (m, number, places, c.nf, varargin{:});
endfunction

function v = answer (m, number, places, nf, what, z = [], factor = 1, lambda = [])
  switch (what)
    case "places"
      v = places;
    case "native"
      v = m.module ("program at", number);
    case "time"   # of all parts at a new point, called from compiled code [s]
      v = m.module ("program time", number, 200, z, lambda);
    case "functions"
      v = reshape (m.module ("program part", number, 5, z, 1, []), nf, []);
    otherwise
      part = find (strcmp (what, {"f", "grad", "g", "jac", "hess"})) - 1;
      v = m.module ("program part", number, part, z, factor, lambda);
  endswitch
endfunction
