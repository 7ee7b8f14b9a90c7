## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{r} =} gsmbp_mobility (@var{m}, @var{x})
## @deftypefnx {} {@var{r} =} gsmbp_mobility (@var{m}, @var{x}, @var{t})
## What the constraints of a scene leave free at a state, and which reactions
## they determine.
##
## @var{x} are the @var{nx} states (or the @var{nq} coordinates alone) of the
## model @var{m} at the time @var{t} [s] (0 by default), closed
## (@code{gsmbp_assemble}).  @var{r} has the fields
##
## @table @code
## @item gruebler
## freedoms by counting: speeds of the tree less the rows that the cut joints have by their types,
## and less three for each disc that rolls (drives and other constraints are not counted)
## @item rows, rank
## constraint rows that are kept, and how many are independent at @var{x}
## @item mobility
## true freedoms at @var{x}: speeds less @code{rank}
## @item redundant
## @code{rows} - @code{rank}: so many multipliers may be chosen at will
## @item unique
## for every multiplier: true where the motion determines it, among the rows
## that were left out too (@qcode{"unique"} of @code{m.json.multipliers}) and at
## @var{x}
## @item reactions
## for every @code{output (name, reaction (J))} of the scene: @code{output},
## @code{joint}, and the names of its components (@code{x}, @code{y}, @code{z}:
## force, @code{mx}, @code{my}, @code{mz}: moment) that are @code{unique} and
## @code{not_unique}, in positions near the start.  This does not depend on where
## the loop is cut; the values of the others do
## @item removed
## rows that were left out of the equations, with the reason
## @item singular
## the singular values of the Jacobian, rows scaled to length one
## @end table
##
## Without an output argument this is printed.  Reactions that are not unique
## come out of the simulation as the least of all that fit.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_mobility (m, m.initial);
## >> [r.gruebler, r.rows, r.rank, r.mobility]
## ans =
##
##   -2   2   2   1
## >> r.reactions.unique, r.reactions.not_unique
## ans =
## @{
##   [1,1] = x
##   [1,2] = y
##   [1,3] = mz
## @}
##
## ans =
## @{
##   [1,1] = z
##   [1,2] = mx
##   [1,3] = my
## @}
## @end example
##
## Errors: a state of another size, or one that does not fulfil the
## constraints.
## Source: own: the rank of the constraint Jacobian by singular values;
## Gruebler's count.
## @seealso{gsmbp_assemble, gsmbp_linear}
## @end deftypefn

function r = gsmbp_mobility (m, x, t = 0)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_mobility";
  gs.given.check_model (who, m);
  d = m.sizes;
  t = gs.given.given_vector (who, "t", t, 1);
  q = gs.given.given_guess (who, m, "x", x, zeros (d.nx - d.nq, 1));
  q = q(1:d.nq);
  one = struct ("reactions", {reactions_of(m)}, "gruebler", d.nu, "rows", 0, "rank", 0, ...
                "mobility", d.nu, "redundant", 0, "unique", true (1, 0), "removed", struct ([]), ...
                "singular", []);
  if (isfield (m, "mobility") && isfield (m.mobility, "gruebler"))
    one.gruebler = m.mobility.gruebler;
    one.removed = m.removed;
  endif
  if (d.nlam > 0)
    [~, ~, H] = m.con (t, q, zeros (d.nu, 1));
    ## the rows on positions: speeds do not matter here
    [names, scaled, found] = gs.start.constraint_residuals (m, t, [q; zeros(d.nx - d.nq, 1)]);
    places = cellfun (@isempty, strfind (names, "rate of "));
    scaled(! places) = 0;
    if (! all (abs (scaled) <= 1e-6))
      error ("gsmbp:start", ["gsmbp_mobility: %s: expected a closed state at t = %.9g s, found " ...
                             "%s; close it by gsmbp_assemble"], m.name, t,
             m.module ("worst", scaled, found, 1e-6));
    endif
    ## rows have units of their own: a row counts by its direction, unless it has vanished
    [~, ~, initial] = m.con (t, m.initial(1:d.nq), zeros (d.nu, 1));
    sizes = @(H) sqrt (sum (H .^ 2, 2));
    size_ = sizes (H);
    gone = size_ <= 1e-7 * sizes (initial);
    size_(gone) = sizes (initial)(gone);
    size_(size_ == 0) = 1;
    [U, S, ~] = svd (H ./ size_);
    s = diag (S(1:min (size (S)),1:min (size (S))));
    one.singular = s;
    one.rows = d.nlam;
    one.rank = sum (s > 1e-7 * max ([s; eps]));
    one.mobility = d.nu - one.rank;
    one.redundant = one.rows - one.rank;
    one.unique = (sqrt (sum (U(:,one.rank+1:end) .^ 2, 2)) < 1e-6)' & determined (m);
  endif
  if (nargout > 0)
    r = one;
  else
    show (m, one);
  endif
endfunction

## what the scene's description says of the multipliers, rows that were left out counted
function u = determined (m)
  u = true (1, m.sizes.nlam);
  if (isfield (m, "json") && isfield (m.json, "multipliers") ...
        && isfield (m.json.multipliers, "unique"))
    u = logical ([m.json.multipliers.unique]);
  endif
endfunction

function r = reactions_of (m)
  r = struct ("output", {}, "joint", {}, "unique", {}, "not_unique", {});
  if (isfield (m, "json") && isfield (m.json, "reactions") && isstruct (m.json.reactions))
    for one = m.json.reactions(:)'
      r(end+1) = struct ("output", one.output, "joint", one.joint, "unique", ...
                         {names(one.unique)}, "not_unique", {names(one.not_unique)});
    endfor
  endif
endfunction

## a list of names as it comes out of JSON
function l = names (l)
  if (isempty (l))
    l = cell (1, 0);
  else
    l = cellstr (l)(:)';
  endif
endfunction

function show (m, r)
  printf (["%s: mobility %d by the rank of its constraints here, %d by counting " ...
           "its joints (Gruebler)\n"], m.name, r.mobility, r.gruebler);
  printf ("  %d constraint rows, %d independent, %d redundant\n", r.rows, r.rank, r.redundant);
  for k = 1:numel (r.removed)
    printf ("  %s is left out: %s\n", r.removed(k).row, r.removed(k).reason);
  endfor
  if (any (! r.unique))
    printf ("  not unique: %s\n", strjoin (m.multipliers(! r.unique), ", "));
    unique_ = m.multipliers(r.unique);
    if (isempty (unique_))
      unique_ = {"none"};
    endif
    printf ("  unique: %s\n", strjoin (unique_, ", "));
  endif
  for one = r.reactions
    if (! isempty (one.not_unique))
      printf ("  reaction in %s (%s): not unique: %s; unique: %s\n", one.joint, one.output, ...
              strjoin (one.not_unique, ", "), ...
              strjoin ([one.unique, {"none"}(isempty (one.unique))], ", "));
    endif
  endfor
endfunction

%!error <Invalid call> gsmbp_mobility ()
